// The page: camera, controls, and what they say.
'use strict';

class Camera {
  constructor(azimuth, elevation) {
    this.home = {azimuth, elevation};
    this.look(azimuth, elevation);
  }

  // From as near as all `corners` are seen, in a picture of this aspect.
  fit(corners, aspect) {
    const {right, up, toward} = this.axes();
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const reach = 0.88 * Math.tan(14 * Math.PI / 180) * Math.max(1, 1 / aspect);
    this.distance = 0.01;
    for (const corner of corners) {
      const across = Math.max(Math.abs(dot(corner, right)) / aspect, Math.abs(dot(corner, up)));
      this.distance = Math.max(this.distance, across / reach + dot(corner, toward));
    }
    this.target = [0, 0, 0];
    this.fitted = true;
  }

  zoom(times) {
    this.distance = Math.max(0.3, Math.min(400, this.distance * times));
    this.fitted = false;
  }

  look(azimuth, elevation) {
    this.azimuth = azimuth;
    this.elevation = Math.max(-90, Math.min(90, elevation));
  }

  axes() {
    const a = this.azimuth * Math.PI / 180;
    const e = this.elevation * Math.PI / 180;
    return {
      right: [-Math.sin(a), Math.cos(a), 0],
      up: [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)],
      toward: [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)],
    };
  }

  move(dx, dy) {
    const {right, up} = this.axes();
    this.fitted = false;
    for (let i = 0; i < 3; ++i) this.target[i] += this.distance * (dx * right[i] + dy * up[i]);
  }

  // The size on the screen of what is `length` long at the target.
  pixels(length, height) {
    return length / this.distance / Math.tan(14 * Math.PI / 180) * height / 2;
  }

  matrices(aspect, reach) {
    const {right, up, toward} = this.axes();
    const dot = (v) => v[0] * this.target[0] + v[1] * this.target[1] + v[2] * this.target[2];
    const view = new Float32Array([
      right[0], up[0], toward[0], 0,
      right[1], up[1], toward[1], 0,
      right[2], up[2], toward[2], 0,
      -dot(right), -dot(up), -dot(toward) - this.distance, 1,
    ]);
    const room = reach + Math.hypot(...this.target);
    const near = Math.max(0.02 * this.distance, this.distance - room);
    const far = this.distance + room;
    const f = 1 / Math.tan(14 * Math.PI / 180) / Math.max(1, 1 / aspect);
    const projection = new Float32Array([
      f / aspect, 0, 0, 0,
      0, f, 0, 0,
      0, 0, (far + near) / (near - far), -1,
      0, 0, 2 * far * near / (near - far), 0,
    ]);
    return {view, projection};
  }
}

class Viewer {
  constructor(mesh) {
    this.mesh = mesh;
    this.canvas = document.getElementById('picture');
    this.state = {
      colour: mesh.colour,
      cut: mesh.cut === null || mesh.cut >= mesh.high ? Infinity : Math.max(mesh.low, mesh.cut),
      explode: mesh.explode,
      edges: mesh.edges,
      contours: mesh.drawContours,
      smooth: true,
    };
    this.camera = new Camera(mesh.azimuth, mesh.elevation);
    this.drawing = new Drawing(this.canvas, mesh);
    this.frames = 0;
    this.pending = false;
    this.say();
    this.connectControls();
    this.connectPointer();
    this.fit();
    new ResizeObserver(() => {
      if (this.camera.fitted) this.fit();
      this.refresh();
    }).observe(this.canvas);
    this.drawNow();
  }

  // All in the free part of the page, from where the eye looks.
  fit() {
    const mesh = this.mesh;
    const apart = this.state.explode * mesh.gap;
    const middle = (mesh.slabLow.length - 1) / 2;
    const corners = mesh.outermost.map(([x, y, z, slab]) => [x, y, z + apart * (slab - middle)]);
    this.camera.fit(corners, this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight));
  }

  home() {
    this.camera.look(this.camera.home.azimuth, this.camera.home.elevation);
    this.fit();
    this.refresh();
  }

  // The radius of what is drawn, slabs moved apart.
  reach() {
    return 1 + this.state.explode * this.mesh.gap * (this.mesh.slabLow.length - 1) / 2;
  }

  drawNow() {
    this.drawing.draw(this.state, this.camera, this.reach());
    ++this.frames;
  }

  refresh() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.drawNow();
    });
  }

  // For tests.
  pixels() {
    this.drawNow();
    return this.drawing.pixels();
  }

  say() {
    const mesh = this.mesh;
    const n = (k, one) => k.toLocaleString('en') + '\u00a0' + one.replace(' ', '\u00a0') + (k === 1 ? '' : 's');
    document.getElementById('title').textContent = mesh.title;
    document.getElementById('figures').textContent =
      n(mesh.tetCount, 'tet') + ' · ' + n(mesh.boundary.length, 'boundary triangle') + ' · ' +
      n(mesh.componentCount, 'component') + ' · ' + n(mesh.sections.length, 'section');
    const ticks = document.getElementById('ticks');
    for (const section of mesh.sections) {
      const x = 1000 * (section.at - mesh.low) / (mesh.high - mesh.low || 1);
      const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
      for (const [name, value] of [['x1', x], ['x2', x], ['y1', 0], ['y2', 10]]) line.setAttribute(name, value);
      ticks.append(line);
    }
    document.getElementById('apart').hidden = mesh.slabLow.length < 2;
  }

  connectControls() {
    const by = document.getElementById('colour');
    for (const name of this.mesh.colourings) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.setAttribute('role', 'radio');
      button.addEventListener('click', () => {
        this.state.colour = name;
        this.showColour();
      });
      by.append(button);
    }
    this.showColour();
    for (const name of ['contours', 'edges', 'smooth']) {
      const box = document.getElementById(name);
      box.checked = this.state[name];
      box.addEventListener('change', () => {
        this.state[name] = box.checked;
        this.refresh();
      });
    }
    const explode = document.getElementById('explode');
    explode.value = this.state.explode;
    explode.addEventListener('input', () => {
      this.camera.distance /= this.reach();
      this.state.explode = Number(explode.value);
      this.camera.distance *= this.reach();
      if (this.camera.fitted) this.fit();
      this.refresh();
    });
    this.slider = document.getElementById('cut');
    this.slider.addEventListener('input', () => {
      const t = Number(this.slider.value) / 1000;
      this.setCut(t >= 1 ? this.mesh.high : this.mesh.low + t * (this.mesh.high - this.mesh.low));
    });
    document.getElementById('down').addEventListener('click', () => this.step(-1));
    document.getElementById('up').addEventListener('click', () => this.step(1));
    for (const button of document.querySelectorAll('[data-view]')) {
      button.addEventListener('click', () => {
        this.camera.look(...button.dataset.view.split(' ').map(Number));
        this.fit();
        this.refresh();
      });
    }
    this.connectFold();
    document.getElementById('save').addEventListener('click', () => this.save());
    window.addEventListener('keydown', (event) => {
      if (event.target instanceof HTMLInputElement) return;
      const step = {ArrowUp: 1, ArrowDown: -1}[event.key];
      if (!step) return;
      event.preventDefault();
      this.step(step);
    });
    this.setCut(this.state.cut);
  }

  // On small screens the controls are folded at first.
  connectFold() {
    const button = document.getElementById('fold');
    const fold = (folded) => {
      document.querySelector('main').classList.toggle('folded', folded);
      button.textContent = folded ? 'Controls' : 'Hide';
      button.setAttribute('aria-expanded', String(!folded));
    };
    button.addEventListener('click', () => fold(button.getAttribute('aria-expanded') === 'true'));
    fold(window.matchMedia('(max-width: 720px)').matches);
    document.getElementById('hint').textContent = window.matchMedia('(pointer: coarse), (max-width: 720px)').matches
      ? 'drag: turn · two fingers: move and zoom'
      : 'drag: turn · wheel: nearer · shift and drag: move · ↑ ↓: sections';
  }

  showColour() {
    for (const button of document.getElementById('colour').children) {
      button.setAttribute('aria-checked', String(button.textContent === this.state.colour));
    }
    this.showLegend();
    this.refresh();
  }

  showLegend() {
    const legend = document.getElementById('legend');
    const mesh = this.mesh;
    const css = (c) => `rgb(${c[0]}, ${c[1]}, ${c[2]})`;
    const row = (kind, colour, text) => {
      const item = document.createElement(kind);
      const swatch = document.createElement('i');
      swatch.style.background = css(colour);
      item.append(swatch, text);
      return item;
    };
    const list = (colour, text, count = '') => {
      const item = row('div', colour, text);
      item.className = 'row';
      item.append(Object.assign(document.createElement('span'), {textContent: count}));
      legend.append(item);
    };
    const ramp = (colours, from, to) => {
      const bar = document.createElement('div');
      bar.className = 'ramp';
      const stops = colours.length < 2 ? [colours[0], colours[0]] : colours;
      const shown = Array.from({length: Math.min(24, stops.length)}, (_, i, all = Math.min(24, stops.length)) =>
        css(stops[Math.round(i * (stops.length - 1) / (all - 1))]));
      bar.style.background = `linear-gradient(to right, ${shown.join(', ')})`;
      const ends = document.createElement('div');
      ends.className = 'ends';
      ends.append(Object.assign(document.createElement('span'), {textContent: from}),
                  Object.assign(document.createElement('span'), {textContent: to}));
      return [bar, ends];
    };
    legend.replaceChildren();
    if (this.state.colour === 'slab') {
      legend.append(...ramp(mesh.slabColours, 'first slab', 'last'));
    } else if (this.state.colour === 'dihedral') {
      legend.append(...ramp(mesh.dihedralColours, '0°, flat', '70.5°, regular'));
    } else if (this.state.colour === 'kind') {
      const present = new Set(mesh.kind);
      for (const k of [...present].sort((a, b) => a - b)) list(mesh.kindColours[k], mesh.kindNames[k]);
    } else if (this.state.colour === 'evidence') {
      mesh.evidenceNames.forEach((name, k) => {
        if (mesh.links[k] > 0) list(mesh.evidenceColours[k], name, mesh.links[k].toLocaleString('en'));
      });
      const none = mesh.evidenceNames.length;
      if (mesh.evidence.includes(none)) list(mesh.evidenceColours[none], 'no link');
      const note = 'Links, by what they rest on. A part of a slab has the colour of its least sure one.';
      legend.append(Object.assign(document.createElement('p'), {textContent: note}));
    } else {
      const few = Math.min(mesh.componentCount, 12);
      for (let c = 0; c < few; ++c) {
        const item = row('button', mesh.componentColours[c], 'component ' + c);
        item.type = 'button';
        item.title = 'show or hide';
        item.setAttribute('aria-pressed', String(!mesh.hidden.has(c)));
        item.addEventListener('click', () => {
          if (!mesh.hidden.delete(c)) mesh.hidden.add(c);
          item.setAttribute('aria-pressed', String(!mesh.hidden.has(c)));
          this.refresh();
        });
        legend.append(item);
      }
      if (few < mesh.componentCount) legend.append(`and ${mesh.componentCount - few} more`);
    }
  }

  // From the top of the solid on nothing is cut: Infinity, not a plane in its topmost faces.
  setCut(position) {
    const mesh = this.mesh;
    const cut = position >= mesh.high ? Infinity : position;
    this.state.cut = cut;
    const range = mesh.high - mesh.low || 1;
    this.slider.value = cut === Infinity ? 1000 : 1000 * (cut - mesh.low) / range;
    const z = Number((mesh.centre + cut * mesh.scale).toPrecision(6));
    const below = mesh.sections.filter((s) => s.at <= cut).length - 1;
    let text = 'the whole solid';
    if (cut !== Infinity) {
      const exactly = below >= 0 && mesh.sections[below].at === cut;
      text = `z = ${z} · ` + (exactly ? `section ${below}`
        : below < 0 ? 'below section 0'
        : below + 1 === mesh.sections.length ? `above section ${below}`
        : `sections ${below} to ${below + 1}`);
    }
    document.getElementById('place').textContent = text;
    this.refresh();
  }

  // To the next section up or down; past the last: the whole solid.
  step(way) {
    const heights = this.mesh.sections.map((s) => s.at);
    const next = way > 0 ? heights.find((z) => z > this.state.cut)
      : heights.filter((z) => z < Math.min(this.state.cut, this.mesh.high)).pop();
    if (next !== undefined) this.setCut(next);
    else if (way > 0) this.setCut(this.mesh.high);
  }

  save() {
    this.drawNow();
    this.canvas.toBlob((blob) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = (this.mesh.title || 'solid') + '.png';
      link.click();
      URL.revokeObjectURL(link.href);
    });
  }

  connectPointer() {
    const canvas = this.canvas;
    const down = new Map();
    const spread = () => {
      const [a, b] = [...down.values()];
      return Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));
    };
    const move = (dx, dy) => {
      const unit = 0.5 / canvas.clientHeight;
      this.camera.move(-dx * unit, dy * unit);
    };
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = down.get(event.pointerId);
      if (!before) return;
      const dx = event.clientX - before.x;
      const dy = event.clientY - before.y;
      const wide = down.size > 1 ? spread() : 0;
      down.set(event.pointerId, {x: event.clientX, y: event.clientY});
      if (down.size > 1) {
        // Two fingers: the solid follows their middle, and their distance.
        this.camera.zoom(wide / spread());
        move(dx / down.size, dy / down.size);
      } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
        move(dx, dy);
      } else {
        this.camera.look(this.camera.azimuth - 0.4 * dx, this.camera.elevation + 0.4 * dy);
      }
      this.refresh();
    });
    for (const name of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(name, (event) => down.delete(event.pointerId));
    }
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('dblclick', () => {
      this.home();
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      this.camera.zoom(Math.exp(0.0012 * lines * event.deltaY));
      this.refresh();
    }, {passive: false});
  }
}

(async () => {
  const message = document.getElementById('message');
  try {
    window.tetloft = new Viewer(await Mesh.read());
    message.hidden = true;
  } catch (error) {
    message.textContent = error.message;
    throw error;
  }
})();
