// The controls of the cut: the bar below the picture, and its direction in the panel.
'use strict';

class CutBar {
  constructor(viewer) {
    this.viewer = viewer;
    this.cut = viewer.cut;
    this.slider = document.getElementById('cut');
    this.slider.addEventListener('input', () => {
      const t = Number(this.slider.value) / 1000;
      this.do(() => this.cut.set(t >= 1 ? Infinity : this.cut.heightAt(t)));
    });
    const act = (id, what) => document.getElementById(id).addEventListener('click', what);
    act('down', () => this.step(-1));
    act('up', () => this.step(1));
    act('flip', () => this.flip());
    act('uncut', () => this.toggle());
    for (const button of document.querySelectorAll('[data-cut]')) {
      button.addEventListener('click', () => this.point(button.dataset.cut));
    }
    this.turn = document.getElementById('cut-turn');
    this.tilt = document.getElementById('cut-tilt');
    for (const angle of [this.turn, this.tilt]) angle.addEventListener('input', () => this.pointByAngles());
    this.show();
  }

  do(what) {
    what();
    this.show();
  }

  step(way) { this.do(() => this.cut.step(way)); }

  toggle() { this.do(() => this.cut.toggle()); }

  flip() {
    this.do(() => {
      if (!this.cut.on) this.cut.toggle();
      this.cut.flip();
    });
  }

  // Along the sections, an axis, or what faces the eye, of which then the near part is taken away.
  point(mode) {
    const {camera, current} = this.viewer;
    if (mode === 'sections') this.cut.along = current;
    let normal = AXES[mode];
    if (mode === 'sections') normal = this.cut.sectionNormal();
    if (mode === 'facing') normal = camera.axes().toward;
    this.do(() => this.cut.point(mode, normal));
  }

  pointByAngles() {
    const a = Number(this.turn.value) * Math.PI / 180;
    const e = Number(this.tilt.value) * Math.PI / 180;
    this.do(() => this.cut.point('angles', [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)]));
  }

  show() {
    const {cut} = this;
    this.slider.value = cut.on ? 1000 * cut.partOf(cut.at) : 1000;
    document.getElementById('place').textContent = cut.text(this.viewer.page);
    for (const button of document.querySelectorAll('[data-cut]')) {
      button.setAttribute('aria-checked', String(button.dataset.cut === cut.mode));
    }
    document.getElementById('uncut').setAttribute('aria-pressed', String(cut.on));
    document.getElementById('flip').setAttribute('aria-pressed', String(cut.flipped));
    if (cut.mode !== 'angles') {
      const n = cut.flipped ? times(-1, cut.normal) : cut.normal;
      this.turn.value = Math.round(Math.atan2(n[1], n[0]) * 180 / Math.PI) || 0;
      this.tilt.value = Math.round(Math.asin(Math.max(-1, Math.min(1, n[2]))) * 180 / Math.PI);
    }
    this.showTicks();
    this.viewer.refresh();
  }

  // Where the sections are; of very many some.
  showTicks() {
    const {cut} = this;
    const key = `${cut.mode} ${cut.normal} ${cut.along.number}`;
    if (key === this.ticked) return;
    this.ticked = key;
    const all = cut.sectionsAt();
    const shown = all.filter((_, k) => k % Math.ceil(all.length / 100) === 0);
    document.getElementById('ticks').replaceChildren(...shown.map((at) => {
      const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
      const x = 1000 * cut.partOf(at);
      for (const [name, value] of [['x1', x], ['x2', x], ['y1', 0], ['y2', 10]]) line.setAttribute(name, value);
      return line;
    }));
  }
}
