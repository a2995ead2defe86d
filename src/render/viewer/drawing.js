// Drawing by WebGL 2: panes, and in each the models, solids before ghosts.
'use strict';

class Drawing extends Buffers {
  constructor(canvas, layers) {
    super(contextOf(canvas), layers);
    this.canvas = canvas;
    const {gl} = this;
    this.surface = compile(gl, SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.lines = compile(gl, LINE_VERTEX, LINE_FRAGMENT);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  resize(width, height, dense) {
    const canvas = this.canvas;
    const [w, h] = [width, height].map((side) => Math.max(1, Math.round(side * dense)));
    if (canvas.width !== w || canvas.height !== h) {
      canvas.width = w;
      canvas.height = h;
    }
  }

  // panes: boxes in CSS pixels from the top left, and the layers that each shows.
  draw(state, camera, panes, width, height, dense) {
    const gl = this.gl;
    this.resize(width, height, dense);
    for (const parts of this.parts) if (parts.layer.visible) this.prepare(parts, state);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const pane of panes) {
      gl.viewport(Math.round(pane.x * dense), Math.round((height - pane.y - pane.height) * dense),
                  Math.round(pane.width * dense), Math.round(pane.height * dense));
      const matrices = camera.matrices(pane.width, pane.height, 1.05 * state.reach);
      this.drawPane(state, camera, pane, {...matrices, dense});
    }
  }

  drawPane(state, camera, pane, frame) {
    const shown = this.parts.filter((parts) => parts.layer.visible && pane.layers.includes(parts.layer));
    const solid = (parts) => parts.layer.opacity >= 1;
    for (const parts of shown.filter(solid)) this.drawSurfaces(state, parts, frame);
    for (const parts of shown) this.drawLines(state, camera, pane, parts, frame, parts === shown[0]);
    for (const parts of shown) {
      if (!solid(parts) && parts.layer.opacity > 0) this.drawGhost(state, parts, frame);
    }
    const picked = state.picked;
    const owner = picked && shown.find((parts) => parts.layer === picked.layer);
    if (owner) this.drawMark(state, pane, owner, frame);
  }

  // Depths first: of a ghost only what is nearest is seen.
  drawGhost(state, parts, frame) {
    const gl = this.gl;
    gl.colorMask(false, false, false, false);
    this.drawSurfaces(state, parts, frame);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    this.drawSurfaces(state, parts, frame);
    gl.disable(gl.BLEND);
    gl.depthFunc(gl.LESS);
  }

  // From the layer's own coordinates to the eye's.
  viewOf(layer, frame) {
    const v = frame.view;
    const map = layer.place;
    const view = new Float32Array(16);
    for (let k = 0; k < 4; ++k) {
      for (let i = 0; i < 3; ++i) {
        view[4 * k + i] = v[i] * map[3 * k] + v[4 + i] * map[3 * k + 1] + v[8 + i] * map[3 * k + 2] +
          (k === 3 ? v[12 + i] : 0);
      }
      view[4 * k + 3] = k === 3 ? 1 : 0;
    }
    return view;
  }

  use(shader, state, parts, frame) {
    const gl = this.gl;
    const {layer} = parts;
    gl.useProgram(shader.program);
    gl.uniformMatrix4fv(shader.uniform('view'), false, this.viewOf(layer, frame));
    gl.uniformMatrix4fv(shader.uniform('projection'), false, frame.projection);
    gl.uniform1f(shader.uniform('apart'), state.explode * layer.gap);
    gl.uniform1f(shader.uniform('middle'), layer.middle);
    gl.uniform3fv(shader.uniform('plane'), parts.plane.normal);
  }

  drawSurfaces(state, parts, frame) {
    const gl = this.gl;
    const {layer} = parts;
    this.use(this.surface, state, parts, frame);
    const at = (name) => this.surface.uniform(name);
    const v = frame.view;
    const turn = (n) => [0, 1, 2].map((i) => v[i] * n[0] + v[4 + i] * n[1] + v[8 + i] * n[2]);
    gl.uniformMatrix3fv(at('normals'), false, layer.inverse.flatMap(turn));
    gl.uniform3fv(at('up'), turn(state.cut.normal));
    gl.uniform1f(at('opacity'), layer.opacity);
    const show = (faces, cut, edges, smoothed) => {
      gl.uniform1f(at('cut'), cut);
      gl.uniform1f(at('edges'), edges ? 1 : 0);
      gl.uniform1i(at('smoothed'), smoothed ? 1 : 0);
      gl.bindVertexArray(faces.array);
      if (faces.faces > 0) gl.drawArrays(gl.TRIANGLES, 0, 3 * faces.faces);
    };
    show(parts.boundary, parts.plane.height, state.edges, state.smooth);
    if (state.explode > 0) show(parts.walls, parts.plane.height, state.edges, false);
    // Before the faces that lie in the cut.
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(-1, -4);
    show(parts.cap, NEVER, false, false);
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  trace(lines, cut, ink, ghost, thick, frame) {
    const gl = this.gl;
    gl.uniform1f(this.lines.uniform('cut'), cut);
    gl.uniform4fv(this.lines.uniform('ghost'), ghost);
    gl.uniform4fv(this.lines.uniform('ink'), ink);
    gl.uniform1f(this.lines.uniform('width'), thick * frame.dense);
    gl.bindVertexArray(lines.array);
    if (lines.count > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
  }

  useLines(state, pane, parts, frame, nearer) {
    const gl = this.gl;
    this.use(this.lines, state, parts, frame);
    gl.uniform2f(this.lines.uniform('size'), pane.width * frame.dense / 2, pane.height * frame.dense / 2);
    gl.uniform1f(this.lines.uniform('nearer'), nearer);
    gl.enable(gl.BLEND);
  }

  drawLines(state, camera, pane, parts, frame, first) {
    const {layer} = parts;
    // Some pixels nearer, and of a solid seen from afar no more than a little of its size.
    const nearer = Math.min(0.008, 3 * camera.unit) * -frame.projection[10];
    this.useLines(state, pane, parts, frame, nearer);
    const none = [0, 0, 0, 0];
    if (state.edges && layer.opacity >= 1) this.trace(parts.capLines, NEVER, [0.12, 0.14, 0.17, 0.5], none, 0.4, frame);
    // Contours that are given are the same of all models that a pane shows.
    if (state.contours && (first || !state.sameContours)) {
      // Where sections are dense, lines are faint, and at last none: they must not cover the surface.
      const gap = layer.gap * (1 + state.explode) / camera.unit;
      const strength = Math.max(layer.opacity < 0.5 ? 0.25 : 0, Math.min(0.9, (gap - 1.5) / 10));
      const ink = layer.opacity < 0.5 ? state.ink : [0.10, 0.12, 0.16];
      const {contours} = parts;
      const lines = {array: contours.array, count: state.explode > 0 ? contours.count : contours.count / 2};
      if (strength > 0) {
        this.trace(lines, parts.plane.height, [...ink, strength], [...state.ink, 0.16 * strength], 0.75, frame);
      }
    }
    this.gl.disable(this.gl.BLEND);
  }

  // Seen through all that lies before it.
  drawMark(state, pane, parts, frame) {
    const gl = this.gl;
    this.useLines(state, pane, parts, frame, 0);
    gl.disable(gl.DEPTH_TEST);
    this.trace(this.marked, NEVER, [1, 1, 1, 0.9], [0, 0, 0, 0], 1.6, frame);
    this.trace(this.marked, NEVER, [0.85, 0.15, 0.35, 1], [0, 0, 0, 0], 0.9, frame);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
  }

  // What is on the canvas now, for tests: part of pixels covered, and a number that tells pictures
  // apart.
  pixels() {
    const gl = this.gl;
    const bytes = new Uint8Array(4 * this.canvas.width * this.canvas.height);
    gl.readPixels(0, 0, this.canvas.width, this.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let covered = 0;
    let hash = 0;
    const colours = new Set();
    for (let i = 0; i < bytes.length; i += 4) {
      if (bytes[i + 3] !== 0) ++covered;
      colours.add(bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2]);
      hash = (Math.imul(hash, 31) + bytes[i] + 7 * bytes[i + 1] + 13 * bytes[i + 2] + 17 * bytes[i + 3]) | 0;
    }
    return {covered: 4 * covered / bytes.length, colours: colours.size, hash};
  }
}
