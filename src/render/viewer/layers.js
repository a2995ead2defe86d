// Several models: which are shown, how solid, and whether over each other or side by side.
'use strict';

class LayerList {
  constructor(viewer) {
    this.viewer = viewer;
    const {layers} = viewer;
    document.getElementById('models').hidden = layers.length < 2;
    if (layers.length < 2) return;
    this.list = document.getElementById('layers');
    this.rows = layers.map((layer) => this.row(layer));
    this.list.append(...this.rows);
    this.buttons = [...document.querySelectorAll('[data-layout]')];
    for (const button of this.buttons) {
      button.addEventListener('click', () => this.setLayout(button.dataset.layout));
    }
    this.mark();
  }

  setLayout(layout) {
    this.viewer.layout = layout;
    this.mark();
    this.viewer.fit();
    this.viewer.refresh();
  }

  row(layer) {
    const item = make('li');
    const eye = make('input', {type: 'checkbox', checked: layer.visible});
    eye.setAttribute('aria-label', 'show ' + layer.name);
    eye.addEventListener('change', () => {
      layer.visible = eye.checked;
      if (this.viewer.layout === 'side') this.viewer.fit();
      this.viewer.refresh();
    });
    const name = make('button', {type: 'button', className: 'name', textContent: layer.name});
    name.title = 'colours and components of ' + layer.name;
    name.addEventListener('click', () => {
      this.viewer.choose(layer);
      this.mark();
    });
    const opacity = make('input', {type: 'range', min: 0, max: 1, step: 0.01, value: layer.opacity});
    opacity.setAttribute('aria-label', 'opacity of ' + layer.name);
    opacity.title = 'opacity';
    opacity.addEventListener('input', () => {
      layer.opacity = Number(opacity.value);
      this.viewer.refresh();
    });
    item.append(eye, name, opacity);
    return item;
  }

  mark() {
    if (!this.rows) return;
    this.rows.forEach((row, k) => row.classList.toggle('current', this.viewer.layers[k] === this.viewer.current));
    this.rows.forEach((row, k) =>
      row.querySelector('.name').setAttribute('aria-pressed', String(this.viewer.layers[k] === this.viewer.current)));
    for (const button of this.buttons) {
      button.setAttribute('aria-checked', String(button.dataset.layout === this.viewer.layout));
    }
  }
}

// Models that fill nearly the same box would hide each other: they are compared side by side.
function firstLayout(layers) {
  if (layers.length < 2) return 'over';
  const boxes = layers.map((layer) => {
    const points = layer.outermost.map((p) => layer.placed(p, p[3], 0));
    return [0, 1, 2].map((k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
  });
  const alike = boxes.every((box) => box.every(([low, high], k) => {
    const [low0, high0] = boxes[0][k];
    return Math.abs(low - low0) + Math.abs(high - high0) < 0.1 * (high0 - low0);
  }));
  return alike ? 'side' : 'over';
}

// Boxes of the stage, in pixels, one for each model that is shown, or one for all.
function panesOf(viewer, width, height) {
  const shown = viewer.layers.filter((layer) => layer.visible);
  if (viewer.layout !== 'side' || shown.length < 2) return [{x: 0, y: 0, width, height, layers: shown}];
  let best = null;
  for (let columns = 1; columns <= shown.length; ++columns) {
    const rows = Math.ceil(shown.length / columns);
    const least = Math.min(width / columns, height / rows);
    if (!best || least > best.least) best = {columns, rows, least};
  }
  const [w, h] = [width / best.columns, height / best.rows];
  return shown.map((layer, k) =>
    ({x: w * (k % best.columns), y: h * Math.floor(k / best.columns), width: w, height: h, layers: [layer]}));
}
