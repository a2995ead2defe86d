// What the graphics processor runs.
'use strict';

const SURFACE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in float slab;
uniform mat4 view, projection;
uniform mat3 normals;
uniform float apart, middle;
uniform vec3 plane;
invariant gl_Position;
out vec3 eye;
out vec3 eyeNormal;
out float height;
out vec3 corner;
flat out vec4 base;
void main() {
  vec4 moved = view * vec4(position + vec3(0.0, 0.0, apart * (slab - middle)), 1.0);
  eye = moved.xyz;
  eyeNormal = normals * normal;
  height = dot(plane, position);
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
uniform float cut, edges, opacity;
uniform bool smoothed;
uniform vec3 up;
out vec4 result;
void main() {
  vec3 facet = normalize(cross(dFdx(eye), dFdy(eye)));
  vec3 width = fwidth(corner);
  // Faces that lie in the cut are kept where they close what is below, and only there, whatever
  // the interpolation of heights: in single precision, and rounded apart, it would speckle them.
  // The page's unit is half the diagonal of the solid.
  float outward = gl_FrontFacing ? dot(facet, up) : -dot(facet, up);
  if (height > cut + (outward > 0.0 ? 2e-5 : -2e-5) || base.a < 0.5) discard;
  vec3 n = smoothed && gl_FrontFacing ? normalize(eyeNormal) : facet;
  vec3 key = normalize(vec3(-0.45, 0.6, 0.66));
  vec3 fill = normalize(vec3(0.75, 0.1, 0.65));
  float light = 0.36 + 0.10 * n.y + 0.66 * max(0.0, dot(n, key)) + 0.17 * max(0.0, dot(n, fill));
  // Turned away from the eye: a darker rim tells shapes in front of each other apart.
  light *= 0.72 + 0.28 * smoothstep(0.0, 0.55, abs(n.z));
  float shine = 0.05 * pow(max(0.0, dot(n, normalize(key + vec3(0.0, 0.0, 1.0)))), 32.0);
  vec3 colour = pow(base.rgb, vec3(2.2)) * light + shine;
  vec3 inner = smoothstep(vec3(0.0), 1.3 * width, corner);
  float line = 1.0 - min(inner.x, min(inner.y, inner.z));
  colour = mix(colour, vec3(0.012, 0.016, 0.025), 0.55 * edges * line);
  result = vec4(pow(colour, vec3(1.0 / 2.2)) * opacity, opacity);
}`;

const LINE_VERTEX = `#version 300 es
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in float slab;
uniform mat4 view, projection;
uniform float apart, middle, width, nearer;
uniform vec2 size;
uniform vec3 plane;
out float height;
void main() {
  vec3 shift = vec3(0.0, 0.0, apart * (slab - middle));
  vec4 p = projection * view * vec4(a + shift, 1.0);
  vec4 q = projection * view * vec4(b + shift, 1.0);
  vec2 along = (q.xy - p.xy) * size;
  // In pixels: a line seen end on has no direction, and must not divide by zero.
  float length = max(length(along), 1e-6);
  vec2 aside = vec2(-along.y, along.x) / length;
  bool end = gl_VertexID > 1;
  vec4 at = end ? q : p;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec2 reach = (side * aside + (end ? 0.5 : -0.5) * along / length) * width;
  height = dot(plane, end ? b : a);
  // Lines lie on surfaces, and a little nearer to the eye.
  gl_Position = at + vec4(reach / size, -nearer, 0.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in float height;
uniform float cut;
uniform vec4 ink, ghost;
out vec4 result;
void main() {
  // A contour in the cut is below it, however the heights are rounded (cutting.js).
  vec4 drawn = height > cut + ${SAME_HEIGHT} ? ghost : ink;
  if (drawn.a == 0.0) discard;
  result = vec4(drawn.rgb * drawn.a, drawn.a);
}`;

function compile(gl, vertex, fragment) {
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
