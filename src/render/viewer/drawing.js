// Drawing by WebGL 2. Buffers are filled anew only where what they show has changed.
'use strict';

const NEVER = 1e9;

class Drawing {
  constructor(canvas, layers) {
    this.canvas = canvas;
    const gl = canvas.getContext('webgl2', {antialias: true, alpha: true});
    if (!gl) {
      throw new Error('This browser offers no WebGL 2, which the viewer needs. Open the page in a current browser ' +
        'with hardware acceleration switched on, or draw a picture instead: tetloft render MODEL.vtu -o MODEL.png');
    }
    this.gl = gl;
    this.surface = compile(gl, SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.lines = compile(gl, LINE_VERTEX, LINE_FRAGMENT);
    this.parts = layers.map((layer) => this.partsOf(layer));
    this.marked = this.lineArray(new Float32Array(0));
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  partsOf(layer) {
    return {
      layer,
      boundary: this.faces(layer, layer.arrays.boundary, layer.arrays.normals),
      walls: null,
      cap: this.faces(layer, new Uint32Array(0), null),
      cut: {tets: [], position: new Float32Array(0)},
      contours: this.lineArray(layer.contourLines()),
      capLines: this.lineArray(new Float32Array(0)),
      coloured: '',
      capOf: '',
    };
  }

  fill(index, buffer, data, size, type, normalised) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, type, normalised, 0, 0);
  }

  faces(layer, halfFaces, normals) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffers = [0, 1, 2, 3].map(() => gl.createBuffer());
    this.fill(0, buffers[0], layer.corners(halfFaces), 3, gl.FLOAT, false);
    if (normals) this.fill(1, buffers[1], normals, 3, gl.BYTE, true);
    const tetOf = (k) => halfFaces[k] >>> 2;
    return {array, buffers, faces: halfFaces.length, tetOf, moved: false};
  }

  recolourFaces(layer, faces) {
    const gl = this.gl;
    gl.bindVertexArray(faces.array);
    const words = layer.colours(faces.faces, faces.tetOf);
    this.fill(2, faces.buffers[2], new Uint8Array(words.buffer), 4, gl.UNSIGNED_BYTE, true);
  }

  // The slab of each corner is wanted only where slabs lie apart.
  moveApart(layer, faces) {
    if (faces.moved) return;
    faces.moved = true;
    const gl = this.gl;
    gl.bindVertexArray(faces.array);
    this.fill(3, faces.buffers[3], layer.slabsOf(faces.faces, faces.tetOf), 1, gl.FLOAT, false);
  }

  lineArray(data) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    const buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    for (const [index, size, offset] of [[0, 3, 0], [1, 3, 12], [2, 1, 24]]) {
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, gl.FLOAT, false, 28, offset);
      gl.vertexAttribDivisor(index, 1);
    }
    return {array, buffer, count: data.length / 7};
  }

  setLines(lines, data) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    lines.count = data.length / 7;
  }

  // Brings the buffers of a layer to what the state asks for.
  prepare(parts, state) {
    const {layer} = parts;
    const apart = state.explode > 0;
    if (apart && !parts.walls) {
      parts.walls = this.faces(layer, layer.arrays.walls, null);
      parts.coloured = '';
    }
    const colours = `${layer.colour} ${layer.version}`;
    if (colours !== parts.coloured) {
      parts.coloured = colours;
      this.recolourFaces(layer, parts.boundary);
      if (parts.walls) this.recolourFaces(layer, parts.walls);
      parts.capOf = '';
    }
    if (apart) {
      this.moveApart(layer, parts.boundary);
      this.moveApart(layer, parts.walls);
    }
    this.recut(parts, state.cut);
    if (apart) this.moveApart(layer, parts.cap);
  }

  recut(parts, cut) {
    const {layer, cap} = parts;
    parts.plane = cut.on ? cut.planeOf(layer) : {normal: [0, 0, 1], height: NEVER};
    const key = `${parts.plane.normal} ${parts.plane.height}`;
    if (key === parts.capOf) return;
    parts.capOf = key;
    parts.cut = cut.on ? capOf(layer, parts.plane)
      : {position: new Float32Array(0), tets: [], line: new Float32Array(0)};
    const gl = this.gl;
    const {tets} = parts.cut;
    gl.bindVertexArray(cap.array);
    this.fill(0, cap.buffers[0], parts.cut.position, 3, gl.FLOAT, false);
    cap.faces = tets.length;
    cap.tetOf = (k) => tets[k];
    cap.moved = false;
    this.recolourFaces(layer, cap);
    this.setLines(parts.capLines, parts.cut.line);
  }

  // Marks a tet by its edges; none for null.
  mark(picked) {
    const line = [];
    if (picked) {
      for (let i = 0; i < 4; ++i) {
        for (let j = 0; j < i; ++j) {
          line.push(...picked.layer.corner(picked.tet, i), ...picked.layer.corner(picked.tet, j), picked.slab);
        }
      }
    }
    this.setLines(this.marked, new Float32Array(line));
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
