// Drawing by WebGL 2.
'use strict';

const SURFACE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in float slab;
uniform mat4 view, projection;
uniform float apart, middle;
out vec3 eye;
out vec3 eyeNormal;
out float height;
out vec3 corner;
flat out vec4 base;
void main() {
  vec4 moved = view * vec4(position + vec3(0.0, 0.0, apart * (slab - middle)), 1.0);
  eye = moved.xyz;
  eyeNormal = mat3(view) * normal;
  height = position.z;
  base = colour;
  int k = gl_VertexID % 3;
  corner = vec3(k == 0, k == 1, k == 2);
  gl_Position = projection * moved;
}`;

const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 eye;
in vec3 eyeNormal;
in float height;
in vec3 corner;
flat in vec4 base;
uniform float cut, edges;
uniform bool smoothed;
uniform vec3 up;
out vec4 result;
void main() {
  vec3 facet = normalize(cross(dFdx(eye), dFdy(eye)));
  vec3 width = fwidth(corner);
  // Faces that lie in the cut are kept where they close what is below, and only there, whatever
  // the interpolation of heights: rounded apart, it would speckle them. The page's unit is half the
  // diagonal of the solid.
  float outward = gl_FrontFacing ? dot(facet, up) : -dot(facet, up);
  if (height > cut + (outward > 0.0 ? 2e-5 : -2e-5) || base.a < 0.5) discard;
  vec3 n = smoothed && gl_FrontFacing ? normalize(eyeNormal) : facet;
  vec3 key = normalize(vec3(-0.45, 0.6, 0.66));
  vec3 fill = normalize(vec3(0.75, 0.1, 0.65));
  float light = 0.36 + 0.10 * n.y + 0.66 * max(0.0, dot(n, key)) + 0.17 * max(0.0, dot(n, fill));
  // Turned away from the eye: a darker rim tells shapes in front of each other apart.
  light *= 0.72 + 0.28 * smoothstep(0.0, 0.55, abs(dot(n, normalize(eye))));
  float shine = 0.05 * pow(max(0.0, dot(n, normalize(key + vec3(0.0, 0.0, 1.0)))), 32.0);
  vec3 colour = pow(base.rgb, vec3(2.2)) * light + shine;
  vec3 inner = smoothstep(vec3(0.0), 1.3 * width, corner);
  float line = 1.0 - min(inner.x, min(inner.y, inner.z));
  colour = mix(colour, vec3(0.012, 0.016, 0.025), 0.55 * edges * line);
  result = vec4(pow(colour, vec3(1.0 / 2.2)), 1.0);
}`;

const LINE_VERTEX = `#version 300 es
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in float slab;
uniform mat4 view, projection;
uniform float apart, middle, width;
uniform vec2 size;
out float height;
void main() {
  vec3 shift = vec3(0.0, 0.0, apart * (slab - middle));
  // A little nearer to the eye, which is at the origin: lines lie on surfaces.
  vec4 p = projection * vec4((view * vec4(a + shift, 1.0)).xyz * 0.998, 1.0);
  vec4 q = projection * vec4((view * vec4(b + shift, 1.0)).xyz * 0.998, 1.0);
  vec2 along = (q.xy / q.w - p.xy / p.w) * size;
  // In pixels: a line seen end on has no direction, and must not divide by zero.
  float length = max(length(along), 1e-6);
  vec2 aside = vec2(-along.y, along.x) / length;
  bool end = gl_VertexID > 1;
  vec4 at = end ? q : p;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec2 reach = (side * aside + (end ? 0.5 : -0.5) * along / length) * width;
  height = a.z;
  gl_Position = at + vec4(reach / size * at.w, 0.0, 0.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in float height;
uniform float cut, ghost;
uniform vec4 ink;
out vec4 result;
void main() {
  float alpha = height > cut ? ghost : ink.a;
  if (alpha == 0.0) discard;
  result = vec4(ink.rgb * alpha, alpha);
}`;

class Drawing {
  constructor(canvas, mesh) {
    this.canvas = canvas;
    this.mesh = mesh;
    const gl = canvas.getContext('webgl2', {antialias: true, alpha: true});
    if (!gl) {
      throw new Error('This browser offers no WebGL 2, which the viewer needs. Open the page in a current browser ' +
        'with hardware acceleration switched on, or draw a picture instead: tetloft render MODEL.vtu -o MODEL.png');
    }
    this.gl = gl;
    this.surface = this.program(SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.lines = this.program(LINE_VERTEX, LINE_FRAGMENT);
    this.boundary = this.faces(mesh.boundary, mesh.normals);
    this.walls = this.faces(mesh.walls, null);
    this.cap = {array: gl.createVertexArray(), count: 0};
    this.capBuffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
    this.contours = this.lineArray(mesh.contourLines());
    this.capLines = this.lineArray(new Float32Array(0));
    this.coloured = '';
    this.capOf = '';
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const at = new Map();
    return {program, uniform: (name) => {
      if (!at.has(name)) at.set(name, gl.getUniformLocation(program, name));
      return at.get(name);
    }};
  }

  attribute(index, buffer, data, size, type, normalised) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    if (data) gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, type, normalised, 0, 0);
  }

  faces(halfFaces, normals) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    const colour = gl.createBuffer();
    gl.bindVertexArray(array);
    const {position, slab} = this.mesh.corners(halfFaces);
    this.attribute(0, gl.createBuffer(), position, 3, gl.FLOAT, false);
    if (normals) this.attribute(1, gl.createBuffer(), normals, 3, gl.BYTE, true);
    this.attribute(2, colour, null, 4, gl.UNSIGNED_BYTE, true);
    this.attribute(3, gl.createBuffer(), slab, 1, gl.FLOAT, false);
    return {array, colour, count: 3 * halfFaces.length, halfFaces, smooth: normals !== null};
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

  // Colours are uploaded anew when they change.
  recolour(state) {
    const key = state.colour + [...this.mesh.hidden].join();
    if (key === this.coloured) return;
    this.coloured = key;
    const gl = this.gl;
    for (const faces of [this.boundary, this.walls]) {
      gl.bindBuffer(gl.ARRAY_BUFFER, faces.colour);
      gl.bufferData(gl.ARRAY_BUFFER, this.mesh.colours(faces.halfFaces, state.colour), gl.STATIC_DRAW);
    }
    this.capOf = '';
  }

  recut(state) {
    const key = String(state.cut);
    if (key === this.capOf) return;
    this.capOf = key;
    const gl = this.gl;
    const cap = this.mesh.cutAt(state.cut, state.colour);
    gl.bindVertexArray(this.cap.array);
    this.attribute(0, this.capBuffers[0], cap.position, 3, gl.FLOAT, false);
    this.attribute(2, this.capBuffers[1], cap.colour, 4, gl.UNSIGNED_BYTE, true);
    this.attribute(3, this.capBuffers[2], cap.slab, 1, gl.FLOAT, false);
    this.cap.count = cap.position.length / 3;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.capLines.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, cap.line, gl.STATIC_DRAW);
    this.capLines.count = cap.line.length / 7;
  }

  draw(state, camera, reach) {
    const gl = this.gl;
    const canvas = this.canvas;
    const dense = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * dense));
    const height = Math.max(1, Math.round(canvas.clientHeight * dense));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    this.recolour(state);
    this.recut(state);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const {view, projection} = camera.matrices(width / height, 1.05 * reach);
    const place = (shader) => {
      gl.useProgram(shader.program);
      gl.uniformMatrix4fv(shader.uniform('view'), false, view);
      gl.uniformMatrix4fv(shader.uniform('projection'), false, projection);
      gl.uniform1f(shader.uniform('apart'), state.explode * this.mesh.gap);
      gl.uniform1f(shader.uniform('middle'), (this.mesh.slabLow.length - 1) / 2);
    };

    place(this.surface);
    const at = (name) => this.surface.uniform(name);
    const show = (faces, cut, edges, smoothed) => {
      gl.uniform1f(at('cut'), Math.min(cut, 1e9));
      gl.uniform1f(at('edges'), edges ? 1 : 0);
      gl.uniform1i(at('smoothed'), smoothed ? 1 : 0);
      gl.bindVertexArray(faces.array);
      if (faces.count > 0) gl.drawArrays(gl.TRIANGLES, 0, faces.count);
    };
    gl.uniform3f(at('up'), view[8], view[9], view[10]);
    show(this.boundary, state.cut, state.edges, state.smooth);
    if (state.explode > 0) show(this.walls, state.cut, state.edges, false);
    // Before the faces that lie in the cut.
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(-1, -4);
    show(this.cap, Infinity, false, false);
    gl.disable(gl.POLYGON_OFFSET_FILL);

    place(this.lines);
    const line = (name) => this.lines.uniform(name);
    gl.uniform2f(line('size'), width / 2, height / 2);
    const trace = (lines, cut, ink, ghost, thick) => {
      gl.uniform1f(line('cut'), Math.min(cut, 1e9));
      gl.uniform1f(line('ghost'), ghost);
      gl.uniform1f(line('width'), thick * dense);
      gl.uniform4fv(line('ink'), ink);
      gl.bindVertexArray(lines.array);
      if (lines.count > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
    };
    gl.enable(gl.BLEND);
    if (state.edges) trace(this.capLines, Infinity, [0.12, 0.14, 0.17, 0.5], 0, 0.4);
    // Where sections are dense, lines are faint: they must not cover the surface.
    const gap = camera.pixels(this.mesh.gap * (1 + state.explode), height) / dense;
    const strength = Math.max(0.04, Math.min(0.9, gap / 12));
    const ink = [0.10, 0.12, 0.16, strength];
    if (state.contours) trace(this.contours, state.cut, ink, 0.13 * strength, 0.75);
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
