// The faces that a cut lays open, from the very tets.
'use strict';

const BLOCK = 256;

// The heights of all points along a normal; the least and greatest of each block of tets, so that a cut looks
// only at blocks that it goes through; and of all tets.
function heightsOf(layer, normal) {
  const key = normal.join();
  if (layer.heights && layer.heights.key === key) return layer.heights;
  const {points, tets} = layer.arrays;
  const [a, b, c] = normal;
  const point = new Float64Array(points.length / 3);
  for (let v = 0; v < point.length; ++v) point[v] = a * points[3 * v] + b * points[3 * v + 1] + c * points[3 * v + 2];
  const blocks = Math.ceil(layer.tetCount / BLOCK);
  const lows = new Float64Array(blocks).fill(Infinity);
  const highs = new Float64Array(blocks).fill(-Infinity);
  for (let k = 0; k < blocks; ++k) {
    let low = Infinity;
    let high = -Infinity;
    const end = Math.min(tets.length, 4 * BLOCK * (k + 1));
    for (let i = 4 * BLOCK * k; i < end; ++i) {
      const h = point[tets[i]];
      if (h < low) low = h;
      if (h > high) high = h;
    }
    lows[k] = low;
    highs[k] = high;
  }
  let low = Infinity;
  let high = -Infinity;
  for (let k = 0; k < blocks; ++k) {
    if (lows[k] < low) low = lows[k];
    if (highs[k] > high) high = highs[k];
  }
  layer.heights = {key, point, lows, highs, low, high};
  return layer.heights;
}

// Triangles, the tet of each, and the outlines of the polygons as a, b and slab. In a section these are of the
// slab below, of which all is kept; at the lowest height, where nothing is, the face above.
function capOf(layer, {normal, height}) {
  const {point, lows, highs, low} = heightsOf(layer, normal);
  const {points, tets, component} = layer.arrays;
  const lowest = height <= low;
  const position = new Growing(Float32Array);
  const triangles = [];
  const line = [];
  // Of the corners of a tet, those below come first; crossings of the edges between, in order around.
  const order = new Uint32Array(4);
  const crossing = new Float64Array(12);
  const meet = (at, v, w) => {
    const t = (height - point[v]) / (point[w] - point[v]);
    for (let k = 0; k < 3; ++k) crossing[3 * at + k] = points[3 * v + k] + t * (points[3 * w + k] - points[3 * v + k]);
  };
  const cutTet = (tet) => {
    let below = 0;
    let end = 4;
    for (let i = 0; i < 4; ++i) {
      const v = tets[4 * tet + i];
      if (point[v] < height || (lowest && point[v] === height)) order[below++] = v;
      else order[--end] = v;
    }
    if (below === 0 || below === 4) return;
    const corners = below === 2 ? 4 : 3;
    const [p, q, r, s] = order;
    if (below === 1) {
      meet(0, p, q);
      meet(1, p, r);
      meet(2, p, s);
    } else if (below === 3) {
      meet(0, p, s);
      meet(1, q, s);
      meet(2, r, s);
    } else {
      meet(0, p, r);
      meet(1, p, s);
      meet(2, q, s);
      meet(3, q, r);
    }
    for (let i = 2; i < corners; ++i) {
      for (const k of [0, i - 1, i]) position.push(crossing[3 * k], crossing[3 * k + 1], crossing[3 * k + 2]);
      triangles.push(tet);
    }
    for (let i = 0; i < corners; ++i) {
      const j = (i + 1) % corners;
      line.push(crossing[3 * i], crossing[3 * i + 1], crossing[3 * i + 2],
                crossing[3 * j], crossing[3 * j + 1], crossing[3 * j + 2], layer.slab[tet]);
    }
  };
  for (let k = 0; k < lows.length; ++k) {
    if (!(lows[k] <= height && height <= highs[k])) continue;
    const end = Math.min(layer.tetCount, BLOCK * (k + 1));
    for (let tet = BLOCK * k; tet < end; ++tet) if (layer.shown[component[tet]]) cutTet(tet);
  }
  return {position: position.array, tets: triangles, line: new Float32Array(line)};
}
