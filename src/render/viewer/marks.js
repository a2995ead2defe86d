// What is written over the picture: scale bar, axes, names of panes, picked points and distances. The same for
// the screen and for saved pictures.
'use strict';

const OPPOSITE = {L: 'R', R: 'L', A: 'P', P: 'A', S: 'I', I: 'S', H: 'F', F: 'H'};
const AXIS_INKS = {light: ['#b3443c', '#4c7f3d', '#3a66a8'], dark: ['#ee8279', '#8fc67e', '#84b1ef']};
const MARK_FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';

// The letters at both ends of each axis of the file's space; empty where there is none.
function axisLetters(orientation) {
  const known = [...orientation.toUpperCase()];
  if (known.length === 3 && known.every((letter) => letter in OPPOSITE)) {
    return known.map((letter) => [letter, OPPOSITE[letter]]);
  }
  return ['x', 'y', 'z'].map((letter) => [letter, '']);
}

// 1, 2 or 5 times a power of ten, at most `most`, whose rounding must not shorten the bar.
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((k) => k * power).find((length) => length <= most * (1 + 1e-9)) || power;
}

class Marks {
  constructor(page) {
    this.page = page;
    this.letters = axisLetters(page.orientation);
  }

  // The length that the bar has, and its pixels.
  bar(camera) {
    const pixel = camera.unit * this.page.length;
    const length = roundLength(130 * pixel);
    return {length, pixels: length / pixel};
  }

  barText(camera) {
    const {length} = this.bar(camera);
    const plain = length >= 1e6 || length < 1e-4 ? length.toExponential(0) : String(Number(length.toPrecision(2)));
    const stretched = this.page.stretch === 1 ? '' : ` across, z × ${this.page.stretch}`;
    return plain + this.page.unitText + stretched;
  }

  paint(ctx, view) {
    this.ctx = ctx;
    this.view = view;
    const dark = view.theme === 'dark';
    this.ink = dark ? '#e8eaee' : '#20242c';
    this.halo = dark ? 'rgba(20, 23, 29, 0.85)' : 'rgba(255, 255, 255, 0.85)';
    this.accent = dark ? '#ff7d9b' : '#c02a50';
    ctx.lineCap = 'round';
    ctx.lineJoin = 'round';
    if (view.panes.length > 1) this.paintPanes();
    for (const pane of view.panes) this.paintPicked(pane);
    this.paintBar();
    this.paintAxes(dark ? AXIS_INKS.dark : AXIS_INKS.light);
  }

  text(words, x, y, {size = 12.5, weight = 500, ink = this.ink, align = 'left'} = {}) {
    const {ctx} = this;
    ctx.font = `${weight} ${size}px ${MARK_FONT}`;
    ctx.textAlign = align;
    ctx.textBaseline = 'middle';
    ctx.lineWidth = 3.5;
    ctx.strokeStyle = this.halo;
    ctx.strokeText(words, x, y);
    ctx.fillStyle = ink;
    ctx.fillText(words, x, y);
  }

  stroke(points, ink, width) {
    const {ctx} = this;
    ctx.beginPath();
    points.forEach(([x, y], k) => (k === 0 ? ctx.moveTo(x, y) : ctx.lineTo(x, y)));
    ctx.strokeStyle = ink;
    ctx.lineWidth = width;
    ctx.stroke();
  }

  paintBar() {
    const {pixels} = this.bar(this.view.camera);
    const y = this.view.height - 18;
    const shape = [[20, y - 5], [20, y], [20 + pixels, y], [20 + pixels, y - 5]];
    this.stroke(shape, this.halo, 4.5);
    this.stroke(shape, this.ink, 1.5);
    this.text(this.barText(this.view.camera), 20, y - 15);
  }

  paintAxes(inks) {
    const {ctx} = this;
    const {right, up, toward} = this.view.camera.axes();
    const both = this.letters[0][1] !== '';
    const radius = both ? 25 : 28;
    const middle = [this.view.width - 46, this.view.height - 46];
    const ends = [];
    this.letters.forEach((pair, k) => {
      for (const [letter, sign] of [[pair[0], 1], [pair[1], -1]]) {
        if (letter !== '') ends.push({letter, ink: inks[k], x: sign * right[k], y: -sign * up[k], z: sign * toward[k]});
      }
    });
    ends.sort((a, b) => a.z - b.z);
    for (const end of ends) {
      const tip = [middle[0] + radius * end.x, middle[1] + radius * end.y];
      ctx.globalAlpha = end.z < -0.25 ? 0.45 : 1;
      this.stroke([middle, tip], end.ink, both ? 1.5 : 2);
      // Of an axis that points at the eye the letter stands in the middle.
      const out = (radius + 10) / radius;
      const beside = Math.hypot(end.x, end.y) < 0.25;
      if (beside && end.z < 0) continue;
      this.text(end.letter, middle[0] + radius * end.x * out, middle[1] + radius * end.y * out,
                {align: 'center', weight: 650, ink: end.ink, size: 13});
    }
    ctx.globalAlpha = 1;
  }

  paintPanes() {
    const line = this.view.theme === 'dark' ? '#3a404c' : '#d0d4dc';
    for (const pane of this.view.panes) {
      if (pane.x > 0) this.stroke([[pane.x, pane.y], [pane.x, pane.y + pane.height]], line, 1);
      if (pane.y > 0) this.stroke([[pane.x, pane.y], [pane.x + pane.width, pane.y]], line, 1);
      this.text(pane.layers[0].name, pane.x + pane.width / 2, pane.y + 20, {align: 'center', weight: 600, size: 13.5});
    }
  }

  // Where a point of a layer is seen in a pane.
  at(pane, picked) {
    const p = picked.layer.placed(picked.own, picked.slab, this.view.explode);
    const [x, y] = this.view.camera.project(p);
    return [pane.x + pane.width / 2 + x, pane.y + pane.height / 2 - y];
  }

  dot([x, y], ink) {
    const {ctx} = this;
    ctx.beginPath();
    ctx.arc(x, y, 4.5, 0, 2 * Math.PI);
    ctx.fillStyle = ink;
    ctx.fill();
    ctx.lineWidth = 2;
    ctx.strokeStyle = '#fff';
    ctx.stroke();
  }

  // Above the middle of a line, and clear of it.
  writeBeside(a, b, words) {
    const {ctx} = this;
    const style = {align: 'center', weight: 650, size: 14};
    ctx.font = `${style.weight} ${style.size}px ${MARK_FONT}`;
    const half = ctx.measureText(words).width / 2;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    const across = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
    const sign = across[1] > 0 ? -1 : 1;
    const clear = sign * (Math.abs(across[0]) * half + Math.abs(across[1]) * 7 + 9);
    this.text(words, (a[0] + b[0]) / 2 + clear * across[0], (a[1] + b[1]) / 2 + clear * across[1], style);
  }

  paintPicked(pane) {
    const {ctx} = this;
    const here = (picked) => picked && picked.layer.visible && pane.layers.includes(picked.layer);
    ctx.save();
    ctx.beginPath();
    ctx.rect(pane.x, pane.y, pane.width, pane.height);
    ctx.clip();
    const {picked, ends} = this.view;
    if (ends.length === 2 && ends.some(here)) {
      const [a, b] = ends.map((end) => this.at(pane, end));
      this.stroke([a, b], '#fff', 4);
      this.stroke([a, b], this.accent, 2);
      this.dot(a, this.accent);
      this.dot(b, this.accent);
      this.writeBeside(a, b, this.page.lengthText(distanceOf(ends)));
    } else if (ends.length === 1 && here(ends[0])) {
      this.dot(this.at(pane, ends[0]), this.accent);
    }
    if (here(picked) && ends.length === 0) this.dot(this.at(pane, picked), this.accent);
    ctx.restore();
  }
}

// In the file's space, of the solid as it is, slabs together.
function distanceOf([a, b]) {
  return Math.hypot(...minus(mapped(a.layer.file, a.own), mapped(b.layer.file, b.own)));
}
