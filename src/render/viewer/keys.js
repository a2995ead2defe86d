// What keys do, as they are listed by "?".
'use strict';

function keyTable(viewer) {
  const {camera, cutBar, panel} = viewer;
  const look = (da, de) => () => camera.look(camera.azimuth + da, camera.elevation + de);
  const move = (dx, dy) => () => camera.move(dx, dy);
  const zoom = (factor) => () => camera.zoom(factor);
  const side = (k) => () => panel.lookFrom(k);
  const step = (way) => () => cutBar.step(way);
  const point = (mode) => () => cutBar.point(mode);
  return [
    ['← → ↑ ↓', 'turn',
     {ArrowLeft: look(6, 0), ArrowRight: look(-6, 0), ArrowUp: look(0, 6), ArrowDown: look(0, -6)}],
    ['Shift + arrows', 'move', {'Shift ArrowLeft': move(-30, 0), 'Shift ArrowRight': move(30, 0),
                                'Shift ArrowUp': move(0, 30), 'Shift ArrowDown': move(0, -30)}],
    ['+ −', 'nearer, farther', {'+': zoom(1 / 1.15), '=': zoom(1 / 1.15), '-': zoom(1.15)}],
    ['f', 'fit into the window', {f: () => viewer.fit()}],
    ['h', 'first view', {h: () => viewer.home()}],
    ['1 … 6', panel.sides.map(([name]) => name).join(', '),
     Object.fromEntries([0, 1, 2, 3, 4, 5].map((k) => [String(k + 1), side(k)]))],
    ['Space', 'spin', {' ': () => viewer.spin()}],
    ['c', 'cut, or whole', {c: () => cutBar.toggle()}],
    ['[ ]', 'cut one section down, up', {'[': step(-1), ']': step(1), PageDown: step(-1), PageUp: step(1)}],
    ['x y z n', 'cut across x, y, z, along the sections',
     {x: point('x'), y: point('y'), z: point('z'), n: point('sections')}],
    ['v', 'cut facing you', {v: point('facing')}],
    ['r', 'the other side of the cut', {r: () => cutBar.flip()}],
    ['m', 'measure a distance', {m: () => viewer.setMeasuring(!viewer.measuring)}],
    ['s', 'save the picture', {s: () => viewer.picture.save()}],
    ['d', 'dark or light', {d: () => viewer.theme.toggle(() => viewer.refresh())}],
    ['Esc', 'forget what was picked', {Escape: () => viewer.forget()}],
    ['?', 'these keys', {'?': () => viewer.help()}],
  ];
}

class Keys {
  constructor(viewer) {
    this.viewer = viewer;
    const table = keyTable(viewer);
    this.acts = Object.assign({}, ...table.map((row) => row[2]));
    const rows = table.map(([keys, what]) => {
      const row = make('tr');
      row.append(make('th', {textContent: keys, scope: 'row'}),
                 make('td', {textContent: what}));
      return row;
    });
    document.getElementById('keys').append(...rows);
    window.addEventListener('keydown', (event) => this.press(event));
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || document.getElementById('help').open) return;
    const {target} = event;
    // Fields keep their letters, sliders their arrows, and a button its space.
    if (target instanceof HTMLInputElement && target.type === 'search' && event.key !== 'Escape') return;
    if (target instanceof HTMLSelectElement) return;
    if (target instanceof HTMLInputElement && /^(Arrow|Page| )/.test(event.key)) return;
    if ((target instanceof HTMLButtonElement || target.tagName === 'SUMMARY') && event.key === ' ') return;
    const arrow = event.key.startsWith('Arrow');
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const act = this.acts[(event.shiftKey && arrow ? 'Shift ' : '') + key];
    if (!act) return;
    event.preventDefault();
    act();
    this.viewer.refresh();
  }
}
