// The list of components: names, colours, volumes; each can be hidden, or shown alone.
'use strict';

// More rows than this no one reads; the search finds the rest.
const MOST_ROWS = 1000;

class ComponentList {
  constructor(viewer) {
    this.viewer = viewer;
    this.list = document.getElementById('components');
    this.search = document.getElementById('search');
    this.search.addEventListener('input', () => this.fill());
    document.getElementById('all').addEventListener('click', () => this.showAll(true));
    document.getElementById('none').addEventListener('click', () => this.showAll(false));
  }

  get layer() { return this.viewer.current; }

  showAll(on) {
    this.layer.showAll(on);
    this.mark();
    this.viewer.refresh();
  }

  fill() {
    const {layer} = this;
    const words = this.search.value.trim().toLowerCase();
    const found = [];
    layer.components.forEach((name, c) => {
      if (name.toLowerCase().includes(words)) found.push(c);
    });
    this.search.hidden = layer.components.length <= 8;
    document.getElementById('component-count').textContent = layer.components.length.toLocaleString('en');
    document.getElementById('component-choice').hidden = layer.components.length < 2;
    this.list.replaceChildren(...found.slice(0, MOST_ROWS).map((c) => this.row(c)));
    const rest = found.length - MOST_ROWS;
    let note = found.length === 0 ? 'none of this name' : '';
    if (rest > 0) note = `and ${rest.toLocaleString('en')} more: search by name`;
    if (note !== '') this.list.append(make('li', {className: 'note', textContent: note}));
    this.mark();
  }

  row(c) {
    const {layer} = this;
    const item = make('li');
    item.dataset.component = c;
    const toggle = make('button', {type: 'button', className: 'component'});
    toggle.title = layer.components[c] + ': show or hide';
    const name = make('span', {className: 'name', textContent: layer.components[c]});
    const volume = make('span', {className: 'volume', textContent: this.viewer.page.volumeText(layer.volumes[c])});
    toggle.append(makeSwatch(layer.componentColour(c)), name, volume);
    toggle.addEventListener('click', () => {
      layer.show(c, !layer.shown[c]);
      this.mark();
      this.viewer.refresh();
    });
    item.append(toggle);
    if (layer.components.length > 1) {
      const only = make('button', {type: 'button', className: 'only', textContent: 'only'});
      only.setAttribute('aria-label', 'show only ' + layer.components[c]);
      only.addEventListener('click', () => this.only(c));
      item.append(only);
    }
    return item;
  }

  // Alone, or all again where it is so already.
  only(c) {
    const {layer} = this;
    const alone = layer.shown[c] === 1 && layer.shown.reduce((sum, on) => sum + on, 0) === 1;
    layer.showAll(alone);
    layer.show(c, true);
    this.mark();
    this.viewer.refresh();
  }

  mark() {
    const {layer} = this;
    this.list.classList.toggle('plain', layer.colour !== 'component');
    for (const item of this.list.children) {
      const toggle = item.querySelector('.component');
      if (toggle) toggle.setAttribute('aria-pressed', String(layer.shown[item.dataset.component] === 1));
    }
  }

  // Shows the row of a component that was picked.
  point(c) {
    for (const item of this.list.children) {
      const here = Number(item.dataset.component) === c;
      item.classList.toggle('picked', here);
      if (here) item.scrollIntoView({block: 'nearest'});
    }
  }
}
