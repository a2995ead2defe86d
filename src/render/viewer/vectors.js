// Vectors [x, y, z], and affine maps as twelve numbers: what the axes become, and the origin.
'use strict';

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const unitOf = (a) => times(1 / (Math.hypot(...a) || 1), a);

const column = (map, k) => [map[3 * k], map[3 * k + 1], map[3 * k + 2]];
const turned = (map, p) => [0, 1, 2].map((i) => map[i] * p[0] + map[3 + i] * p[1] + map[6 + i] * p[2]);
const mapped = (map, p) => plus(turned(map, p), column(map, 3));
// The linear part transposed: of plane normals, from the space that the map leads to.
const pulledBack = (map, n) => [dot(column(map, 0), n), dot(column(map, 1), n), dot(column(map, 2), n)];

// The rows of the inverse of the linear part.
function inverseRows(map) {
  const [a, b, c] = [0, 1, 2].map((k) => column(map, k));
  const whole = dot(a, cross(b, c)) || 1;
  return [times(1 / whole, cross(b, c)), times(1 / whole, cross(c, a)), times(1 / whole, cross(a, b))];
}
