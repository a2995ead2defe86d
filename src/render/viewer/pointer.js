// Mouse, pen and fingers: one turns, two move and zoom, a click or tap picks.
'use strict';

class Pointer {
  constructor(viewer) {
    this.viewer = viewer;
    this.down = new Map();
    const {canvas} = viewer;
    const on = (name, act, options) => canvas.addEventListener(name, act, options);
    on('pointerdown', (event) => this.press(event));
    on('pointermove', (event) => this.drag(event));
    on('pointerup', (event) => this.release(event));
    on('pointercancel', (event) => this.down.delete(event.pointerId));
    on('contextmenu', (event) => event.preventDefault());
    on('dblclick', () => viewer.home());
    on('wheel', (event) => this.wheel(event), {passive: false});
  }

  // Pixels right of and above the middle of the pane that is there, and that pane.
  place(event) {
    const box = this.viewer.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const {panes} = this.viewer;
    const pane = panes.find((p) => x >= p.x && x < p.x + p.width && y >= p.y && y < p.y + p.height) || panes[0];
    return {pane, x: x - pane.x - pane.width / 2, y: pane.y + pane.height / 2 - y};
  }

  press(event) {
    this.viewer.canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    this.still = this.down.size === 1 && event.button === 0 ? {x: event.clientX, y: event.clientY} : null;
  }

  spread() {
    const [a, b] = [...this.down.values()];
    return Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));
  }

  drag(event) {
    const before = this.down.get(event.pointerId);
    if (!before) return;
    // A hand trembles.
    if (this.still && Math.hypot(event.clientX - this.still.x, event.clientY - this.still.y) < 5) return;
    this.still = null;
    const {camera} = this.viewer;
    const dx = event.clientX - before.x;
    const dy = event.clientY - before.y;
    const wide = this.down.size > 1 ? this.spread() : 0;
    this.down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (this.down.size > 1) {
      // Two fingers: the solid follows their middle, and their distance.
      const [a, b] = [...this.down.values()];
      const at = this.place({clientX: (a.x + b.x) / 2, clientY: (a.y + b.y) / 2});
      camera.zoom(wide / this.spread(), at.x, at.y);
      camera.move(dx / this.down.size, -dy / this.down.size);
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      camera.move(dx, -dy);
    } else {
      camera.look(camera.azimuth - 0.4 * dx, camera.elevation + 0.4 * dy);
    }
    this.viewer.refresh();
  }

  release(event) {
    const {still} = this;
    this.down.delete(event.pointerId);
    this.still = null;
    if (still) this.viewer.pickAt(this.place({clientX: still.x, clientY: still.y}));
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    const at = this.place(event);
    this.viewer.camera.zoom(Math.exp(0.0012 * lines * event.deltaY), at.x, at.y);
    this.viewer.refresh();
  }
}
