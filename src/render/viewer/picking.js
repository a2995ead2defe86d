// What lies under a point of the picture, exactly: the nearest triangle that the ray from the eye meets.
'use strict';

// Triangles p, q, r against the ray from `from` along `along`: the parameter, or Infinity.
function meetTriangle(from, along, p, q, r) {
  const u = minus(q, p);
  const v = minus(r, p);
  const n = cross(along, v);
  const det = dot(u, n);
  if (det === 0) return Infinity;
  const s = minus(from, p);
  const a = dot(s, n) / det;
  if (!(a >= 0 && a <= 1)) return Infinity;
  const m = cross(s, u);
  const b = dot(along, m) / det;
  return b >= 0 && a + b <= 1 ? dot(v, m) / det : Infinity;
}

// In own coordinates of a layer. The ray is turned so that triangles are looked at along z: most are passed over
// by their boxes.
class Ray {
  constructor(layer, from, along, explode) {
    this.layer = layer;
    this.explode = explode;
    const rows = layer.inverse;
    const own = (v) => rows.map((row) => dot(row, v));
    this.from = own(minus(from, column(layer.place, 3)));
    this.along = own(along);
    this.nearest = {t: Infinity};
    const a = unitOf(this.along);
    const other = Math.abs(a[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    this.u = unitOf(cross(a, other));
    this.v = cross(a, this.u);
    this.u0 = dot(this.u, this.from);
    this.v0 = dot(this.v, this.from);
  }

  // The shift of a slab.
  apart(slab) { return this.explode * this.layer.gap * (slab - this.layer.middle); }

  try(tet, x, i, j, k) {
    const slab = this.layer.slab[tet];
    const lift = this.apart(slab);
    const {u, v, u0, v0} = this;
    const at = (axis, n, base) => axis[0] * x[n] + axis[1] * x[n + 1] + axis[2] * (x[n + 2] + lift) - base;
    const [ui, uj, uk] = [at(u, i, u0), at(u, j, u0), at(u, k, u0)];
    if ((ui > 0 && uj > 0 && uk > 0) || (ui < 0 && uj < 0 && uk < 0)) return;
    const [vi, vj, vk] = [at(v, i, v0), at(v, j, v0), at(v, k, v0)];
    if ((vi > 0 && vj > 0 && vk > 0) || (vi < 0 && vj < 0 && vk < 0)) return;
    const corner = (n) => [x[n], x[n + 1], x[n + 2] + lift];
    const t = meetTriangle(this.from, this.along, corner(i), corner(j), corner(k));
    if (!(t < this.nearest.t)) return;
    const own = plus(this.from, times(t, this.along));
    own[2] -= lift;
    if (this.within(own)) this.nearest = {t, tet, slab, own, layer: this.layer};
  }

  within(own) { return !this.plane || dot(this.plane.normal, own) <= this.plane.height + SAME_HEIGHT; }

  tryHalfFaces(halfFaces) {
    const {points, tets, component} = this.layer.arrays;
    const {shown} = this.layer;
    for (let k = 0; k < halfFaces.length; ++k) {
      const tet = halfFaces[k] >>> 2;
      if (!shown[component[tet]]) continue;
      const face = FACE[halfFaces[k] & 3];
      this.try(tet, points, 3 * tets[4 * tet + face[0]], 3 * tets[4 * tet + face[1]], 3 * tets[4 * tet + face[2]]);
    }
  }
}

// The nearest point of these layers that is seen at (x, y) pixels from the middle of a pane; null for none.
function pick(parts, state, camera, x, y) {
  const {toward} = camera.axes();
  const from = plus(camera.unproject(x, y), times(4 * state.reach + 4, toward));
  let best = {t: Infinity};
  for (const part of parts) {
    const ray = new Ray(part.layer, from, times(-1, toward), state.explode);
    ray.plane = state.cut.on ? part.plane : null;
    ray.tryHalfFaces(part.layer.arrays.boundary);
    if (state.explode > 0) ray.tryHalfFaces(part.layer.arrays.walls);
    const {tets, position} = part.cut;
    ray.plane = null;
    for (let k = 0; k < tets.length; ++k) ray.try(tets[k], position, 9 * k, 9 * k + 3, 9 * k + 6);
    if (ray.nearest.t < best.t) best = ray.nearest;
  }
  return best.t < Infinity ? best : null;
}

// The smallest angle between faces of a tet, in degrees.
function smallestDihedral(layer, tet) {
  const p = [0, 1, 2, 3].map((i) => mapped(layer.file, layer.corner(tet, i)));
  const normals = FACE.map(([a, b, c]) => unitOf(cross(minus(p[b], p[a]), minus(p[c], p[a]))));
  let largest = -1;
  for (let i = 0; i < 4; ++i) for (let j = 0; j < i; ++j) largest = Math.max(largest, -dot(normals[i], normals[j]));
  return Math.acos(Math.max(-1, Math.min(1, largest))) * 180 / Math.PI;
}

// What is told of a picked point: [what, value] of each.
function describe(page, picked, several) {
  const {layer, tet, own, slab} = picked;
  const rows = [];
  if (several) rows.push(['Model', layer.name]);
  rows.push(['Component', layer.components[layer.arrays.component[tet]]]);
  const place = sectionText(layer, own[2]);
  rows.push(['Slab', layer.slabNumbers[slab] + (place === '' ? '' : ', ' + place)]);
  rows.push(['Point', page.pointText(mapped(layer.file, own))]);
  rows.push(['Dihedral', smallestDihedral(layer, tet).toFixed(1) + '° at least']);
  const {kind, evidence} = layer.arrays;
  if (kind && kind.length > 0) rows.push(['Kind', page.kindNames[kind[tet]]]);
  if (evidence && evidence.length > 0) rows.push(['Evidence', page.evidenceNames[evidence[tet]] || 'no link']);
  return rows;
}
