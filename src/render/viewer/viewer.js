// The page: its state, and what holds its parts together.
'use strict';

const SMALL = window.matchMedia('(max-width: 720px), (max-height: 480px)');

class Viewer {
  constructor(page, layers) {
    this.page = page;
    this.layers = layers;
    this.current = layers[0];
    this.canvas = document.getElementById('picture');
    this.overlay = document.getElementById('marks');
    this.camera = new Camera(page.azimuth, page.elevation);
    this.cut = new Cut(layers);
    this.cut.start(page, this.camera.axes().toward);
    this.state = {
      cut: this.cut, explode: page.explode, edges: page.edges, contours: page.drawContours, smooth: true,
      picked: null, sameContours: page.contoursGiven,
    };
    this.ends = [];
    this.measuring = false;
    this.layout = firstLayout(layers);
    // What lies in one space is told apart; what is compared has the same colours.
    if (this.layout === 'over') {
      let colours = 0;
      for (const layer of layers) {
        layer.firstColour = colours;
        colours += layer.components.length;
      }
    }
    this.marks = new Marks(page);
    this.drawing = new Drawing(this.canvas, layers);
    this.theme = new Theme(() => this.refresh());
    this.frames = 0;
    this.panes = [];
    this.fit();
    this.drawNow();
  }

  // Everything that can be used, once all arrays are there.
  connect() {
    document.getElementById('title').textContent = this.page.title;
    this.components = new ComponentList(this);
    this.layerList = new LayerList(this);
    this.card = new Card(this);
    this.panel = new Panel(this);
    this.cutBar = new CutBar(this);
    this.picture = new Picture(this);
    this.pointer = new Pointer(this);
    this.keys = new Keys(this);
    this.components.fill();
    document.getElementById('measure').addEventListener('click', () => this.setMeasuring(!this.measuring));
    document.getElementById('ask').addEventListener('click', () => this.help());
    // Phones take the graphics processor away from pages in the background, and give it back.
    this.canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.drawing = new Drawing(this.canvas, this.layers);
      this.drawing.mark(this.state.picked);
      this.refresh();
    });
    new ResizeObserver(() => {
      if (this.camera.fitted) this.fit();
      this.refresh();
    }).observe(this.canvas);
  }

  size() { return {width: Math.max(1, this.canvas.clientWidth), height: Math.max(1, this.canvas.clientHeight)}; }

  // Of the stage what the folded panel lies over; none where it lies beside.
  titleCorner() {
    const panel = document.getElementById('panel').getBoundingClientRect();
    const stage = this.canvas.getBoundingClientRect();
    const over = panel.right > stage.left + 1 && panel.bottom > stage.top + 1;
    return over ? {right: panel.right - stage.left + 8, bottom: panel.bottom - stage.top + 8} : {right: 0, bottom: 0};
  }

  // All that is shown in the free part of the stage, from where the eye looks.
  fit() {
    const {width, height} = this.size();
    const [pane] = panesOf(this, width, height);
    const {explode} = this.state;
    const points = this.layers.filter((layer) => layer.visible).flatMap((layer) =>
      layer.outermost.map((p) => layer.placed(p, p[3], explode)));
    const [top, bottom] = pane.height > 320 ? [this.layout === 'side' ? 44 : 28, 76] : [12, 40];
    const side = pane.width > 320 ? 32 : 16;
    const into = (above) => this.camera.fit(points, {
      width: pane.width - 2 * side, height: pane.height - above - bottom, lift: (bottom - above) / 2});
    if (points.length > 0) {
      into(top);
      const title = this.titleCorner();
      const hidden = (p) => {
        const [x, y] = this.camera.project(p);
        return x + pane.width / 2 < title.right && pane.height / 2 - y < title.bottom;
      };
      if (title.bottom > 0 && points.some(hidden)) into(Math.max(top, title.bottom));
    }
    this.state.reach = points.reduce((most, p) => Math.max(most, Math.hypot(...p)), 1);
  }

  home() {
    this.camera.look(this.camera.home.azimuth, this.camera.home.elevation);
    this.fit();
    this.refresh();
  }

  explode(apart) {
    this.state.explode = apart;
    const {fitted, unit, target} = this.camera;
    this.fit();
    if (!fitted) Object.assign(this.camera, {fitted, unit, target});
    this.refresh();
  }

  // Which model the panel is about.
  choose(layer) {
    this.current = layer;
    this.panel.showLayer();
    this.components.fill();
  }

  // What marks are painted from.
  seen(theme) {
    return {...this.size(), camera: this.camera, panes: this.panes, theme, explode: this.state.explode,
            picked: this.state.picked, ends: this.ends};
  }

  drawSolid(dense) {
    const {width, height} = this.size();
    this.panes = panesOf(this, width, height);
    this.state.ink = this.theme.shown === 'dark' ? [0.82, 0.85, 0.90] : [0.10, 0.12, 0.16];
    this.drawing.draw(this.state, this.camera, this.panes, width, height, dense);
  }

  drawNow() {
    const dense = Math.min(window.devicePixelRatio || 1, 2);
    this.drawSolid(dense);
    const {width, height} = this.size();
    this.overlay.width = Math.round(width * dense);
    this.overlay.height = Math.round(height * dense);
    const ctx = this.overlay.getContext('2d');
    ctx.scale(dense, dense);
    this.marks.paint(ctx, this.seen(this.theme.shown));
    ++this.frames;
  }

  // Once for all changes until the next frame; nothing is drawn while nothing changes.
  refresh() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.drawNow();
    });
  }

  spin() {
    this.spinning = !this.spinning;
    document.getElementById('spin').setAttribute('aria-pressed', String(this.spinning));
    let before = null;
    const turn = (now) => {
      if (!this.spinning) return;
      const {camera} = this;
      // 24° a second, without leaps after a pause.
      const passed = before === null ? 0 : Math.min(100, now - before);
      camera.look(camera.azimuth + 0.024 * passed, camera.elevation);
      before = now;
      this.drawNow();
      requestAnimationFrame(turn);
    };
    requestAnimationFrame(turn);
  }

  // For tests.
  pixels() {
    this.drawNow();
    return this.drawing.pixels();
  }

  // What is seen there; solids before ghosts.
  hit({pane, x, y}) {
    const parts = this.drawing.parts.filter((part) => part.layer.visible && pane.layers.includes(part.layer));
    // Of what was changed since the last frame, too.
    for (const part of parts) this.drawing.prepare(part, this.state);
    const among = (solid) => pick(parts.filter((p) => p.layer.opacity > 0 && (p.layer.opacity >= 0.5) === solid),
                                  this.state, this.camera, x, y);
    return among(true) || among(false);
  }

  pickAt(place) {
    const picked = this.hit(place);
    if (this.measuring) {
      if (picked) this.ends = this.ends.length === 2 ? [picked] : [...this.ends, picked];
    } else {
      this.state.picked = picked;
      this.drawing.mark(picked);
      if (picked && picked.layer === this.current) this.components.point(picked.layer.arrays.component[picked.tet]);
    }
    this.card.show();
    this.refresh();
  }

  setMeasuring(on) {
    this.measuring = on;
    this.ends = [];
    this.state.picked = null;
    document.getElementById('measure').setAttribute('aria-pressed', String(on));
    document.getElementById('stage').classList.toggle('measuring', on);
    // Where the controls take the room of the picture, they make way.
    if (on && SMALL.matches) this.panel.fold(true);
    this.card.show();
    this.refresh();
  }

  forget() {
    this.setMeasuring(false);
    this.components.point(-1);
  }

  help() { document.getElementById('help').showModal(); }
}

(async () => {
  const message = document.getElementById('message');
  try {
    document.querySelector('main').classList.toggle('folded', SMALL.matches);
    const start = performance.now();
    const page = new Page();
    const layers = page.models.map((_, k) => new Layer(page, k));
    await Promise.all(layers.map((layer) => layer.unpackFirst()));
    const unpacked = performance.now();
    const viewer = new Viewer(page, layers);
    message.hidden = true;
    const drawn = performance.now();
    await Promise.all(layers.map((layer) => layer.unpackRest()));
    viewer.connect();
    viewer.times = {unpacked: unpacked - start, drawn: drawn - unpacked, rest: performance.now() - drawn};
    window.tetloft = viewer;
  } catch (error) {
    message.hidden = false;
    message.textContent = error.message;
    throw error;
  }
})();
