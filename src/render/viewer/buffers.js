// What the graphics processor holds. Buffers are filled anew only where what they show has changed.
'use strict';

const NEVER = 1e9;

function contextOf(canvas) {
  const gl = canvas.getContext('webgl2', {antialias: true, alpha: true});
  if (gl) return gl;
  throw new Error('This browser offers no WebGL 2, which the viewer needs. Open the page in a current browser ' +
    'with hardware acceleration switched on, or draw a picture instead: tetloft render MODEL.vtu -o MODEL.png');
}

class Buffers {
  constructor(gl, layers) {
    this.gl = gl;
    this.parts = layers.map((layer) => this.partsOf(layer));
    this.marked = this.lineArray(new Float32Array(0));
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
}
