// The panel: colours and their legend, what is shown, views, and the fold.
'use strict';

// Where the eye stands: in a body by the letters of its sides, else by the axes.
const SIDES = [['front', [0, -1, 0]], ['back', [0, 1, 0]], ['left', [-1, 0, 0]],
               ['right', [1, 0, 0]], ['top', [0, 0, 1]], ['bottom', [0, 0, -1]]];
const BODY_SIDES = [['anterior', 'A'], ['posterior', 'P'], ['left', 'L'],
                    ['right', 'R'], ['superior', 'SH'], ['inferior', 'IF']];

function sidesOf(letters) {
  if (letters[0][1] === '') return SIDES;
  return BODY_SIDES.map(([name, signs]) => {
    const side = [0, 0, 0];
    letters.forEach((pair, k) => pair.forEach((letter, end) => {
      if (signs.includes(letter)) side[k] = end === 0 ? 1 : -1;
    }));
    return [name, side];
  });
}

function legendRow(colour, text, count = '') {
  const item = make('div', {className: 'row'});
  item.append(makeSwatch(colour), text, make('span', {textContent: count}));
  return item;
}

// A bar of colours, of very many some, and what its ends stand for.
function legendRamp(colours, from, to) {
  const bar = make('div', {className: 'ramp'});
  const most = Math.min(24, colours.length);
  const step = (colours.length - 1) / Math.max(1, most - 1);
  const stops = Array.from({length: most}, (_, i) => cssColour(colours[Math.round(i * step)]));
  bar.style.background = stops.length < 2 ? stops[0] : `linear-gradient(to right, ${stops.join()})`;
  const ends = make('div', {className: 'ends'});
  ends.append(...[from, to].map((text) => make('span', {textContent: text})));
  return [bar, ends];
}

class Panel {
  constructor(viewer) {
    this.viewer = viewer;
    this.legend = document.getElementById('legend');
    this.connectShow();
    this.connectViews();
    this.connectFold();
    this.showLayer();
  }

  // What is told of the model that is looked at, and its colours.
  showLayer() {
    const {current, layers} = this.viewer;
    const n = (k, one) => k.toLocaleString('en') + '\u00a0' + one.replace(' ', '\u00a0') + (k === 1 ? '' : 's');
    const figures = [n(current.tetCount, 'tet'), n(current.sections.length, 'section'),
                     n(current.arrays.boundary.length, 'boundary triangle')];
    if (layers.length > 1) figures.unshift(current.name);
    document.getElementById('figures').replaceChildren(
      ...figures.flatMap((text) => [make('span', {textContent: text}), ' ']));
    const by = document.getElementById('colour');
    by.replaceChildren(...current.colourings.map((name) => {
      const button = make('button', {type: 'button', textContent: name});
      button.setAttribute('role', 'radio');
      button.addEventListener('click', () => {
        current.colour = name;
        this.showColour();
      });
      return button;
    }));
    this.showColour();
  }

  showColour() {
    const {viewer} = this;
    for (const button of document.getElementById('colour').children) {
      button.setAttribute('aria-checked', String(button.textContent === viewer.current.colour));
    }
    this.fillLegend(viewer.current, viewer.page);
    viewer.components.mark();
    viewer.refresh();
  }

  fillLegend(layer, page) {
    const {kind, evidence} = layer.arrays;
    const rows = {
      slab: () => legendRamp(layer.slabColours, 'first slab', 'last'),
      dihedral: () => legendRamp(page.dihedralColours, '0°, flat', '70.5°, regular'),
      kind: () => [...new Set(kind)].sort((a, b) => a - b)
        .map((k) => legendRow(page.kindColours[k], page.kindNames[k])),
      evidence: () => {
        const none = page.evidenceNames.length;
        const links = page.evidenceNames.flatMap((name, k) =>
          layer.links[k] > 0 ? [legendRow(page.evidenceColours[k], name, layer.links[k].toLocaleString('en'))] : []);
        if (evidence.includes(none)) links.push(legendRow(page.evidenceColours[none], 'no link'));
        const note = 'Links, by what they rest on. A part of a slab has the colour of its least sure one.';
        return [...links, make('p', {textContent: note})];
      },
      model: () => this.viewer.layers.map((each) => legendRow(each.ownColour(), each.name)),
    }[layer.colour];
    this.legend.replaceChildren(...(rows ? rows() : []));
  }

  connectShow() {
    const {viewer} = this;
    for (const name of ['contours', 'edges', 'smooth']) {
      const box = document.getElementById(name);
      box.checked = viewer.state[name];
      box.addEventListener('change', () => {
        viewer.state[name] = box.checked;
        viewer.refresh();
      });
    }
    const explode = document.getElementById('explode');
    explode.value = viewer.state.explode;
    explode.addEventListener('input', () => viewer.explode(Number(explode.value)));
    document.getElementById('apart').hidden = viewer.layers.every((layer) => layer.slabCount < 2);
  }

  connectViews() {
    const {viewer} = this;
    this.sides = sidesOf(viewer.marks.letters);
    const views = document.getElementById('views');
    this.sides.forEach(([name, side], k) => {
      const button = make('button', {type: 'button', textContent: name, title: `from this side (${k + 1})`});
      button.dataset.side = k + 1;
      button.addEventListener('click', () => this.lookFrom(k));
      views.append(button);
    });
    document.getElementById('home').addEventListener('click', () => viewer.home());
    document.getElementById('spin').addEventListener('click', () => viewer.spin());
  }

  lookFrom(k) {
    this.viewer.camera.lookFrom(this.sides[k][1]);
    this.viewer.fit();
    this.viewer.refresh();
  }

  // On small screens the controls are folded at first.
  connectFold() {
    this.foldButton = document.getElementById('fold');
    const open = () => this.foldButton.getAttribute('aria-expanded') === 'true';
    this.foldButton.addEventListener('click', () => this.fold(open()));
    this.fold(SMALL.matches);
  }

  fold(folded) {
    document.querySelector('main').classList.toggle('folded', folded);
    this.foldButton.textContent = folded ? 'Controls' : 'Hide';
    this.foldButton.setAttribute('aria-expanded', String(!folded));
    this.viewer.card.place(folded || SMALL.matches);
  }
}
