// The models of the page: what is told of them, and their arrays.
'use strict';

const FACE = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

const ARRAYS = {
  points: Float32Array, tets: Uint32Array, boundary: Uint32Array, walls: Uint32Array, normals: Int8Array,
  component: Uint32Array, kind: Uint8Array, dihedral: Uint8Array, evidence: Uint8Array,
  contours: Float32Array, contour_slabs: Uint32Array,
};
// What the first picture needs, whatever it shows.
const FIRST = ['points', 'tets', 'boundary', 'normals', 'component', 'contours', 'contour_slabs'];

class Layer {
  constructor(page, number) {
    this.page = page;
    this.number = number;
    Object.assign(this, page.models[number]);
    this.arrays = {};
    this.inverse = inverseRows(this.place);
    this.shown = new Uint8Array(this.components.length).fill(1);
    this.version = 0;
    this.visible = true;
    this.opacity = 1;
    this.colour = page.colour;
    this.firstColour = 0;
    if (page.models.length > 1) this.colourings = [...this.colourings, 'model'];
  }

  async unpack(names) {
    await Promise.all(names.filter((name) => !(name in this.arrays)).map(async (name) => {
      this.arrays[name] = null;
      this.arrays[name] = await unpack(`array-${this.number}-${name}`, ARRAYS[name]);
    }));
  }

  async unpackFirst() {
    const coloured = ['kind', 'dihedral', 'evidence'].filter((name) => name === this.colour);
    await this.unpack([...FIRST, ...coloured, ...(this.page.explode > 0 ? ['walls'] : [])]);
    this.tetCount = this.arrays.tets.length / 4;
    this.slabCount = this.slabFirst.length - 1;
    this.middle = (this.slabCount - 1) / 2;
    this.slab = new Uint32Array(this.tetCount);
    for (let s = 0; s < this.slabCount; ++s) this.slab.fill(s, this.slabFirst[s], this.slabFirst[s + 1]);
    this.findOutermost();
  }

  async unpackRest() { await this.unpack(Object.keys(ARRAYS)); }

  // For each slab its points that lie farthest in 26 directions, with the slab as fourth: what a camera must see.
  findOutermost() {
    const {points, tets} = this.arrays;
    const ways = [];
    for (let k = 0; k < 27; ++k) if (k !== 13) ways.push([k % 3 - 1, Math.floor(k / 3) % 3 - 1, Math.floor(k / 9) - 1]);
    this.outermost = [];
    // Of very many tets only some are looked at: the fit leaves room.
    const step = Math.max(1, Math.floor(this.tetCount / 40000));
    for (let s = 0; s < this.slabCount; ++s) {
      const most = ways.map(() => -Infinity);
      const at = ways.map(() => 0);
      for (let t = this.slabFirst[s]; t < this.slabFirst[s + 1]; t += step) {
        for (let i = 4 * t; i < 4 * t + 4; ++i) {
          const v = 3 * tets[i];
          for (let k = 0; k < 26; ++k) {
            const reach = ways[k][0] * points[v] + ways[k][1] * points[v + 1] + ways[k][2] * points[v + 2];
            if (reach > most[k]) {
              most[k] = reach;
              at[k] = v;
            }
          }
        }
      }
      for (const v of new Set(at)) this.outermost.push([points[v], points[v + 1], points[v + 2], s]);
    }
  }

  // In the page's space; slabs moved apart by so many mean heights.
  placed(p, slab, explode) {
    return mapped(this.place, [p[0], p[1], p[2] + explode * this.gap * (slab - this.middle)]);
  }

  corner(tet, i) {
    const v = 3 * this.arrays.tets[4 * tet + i];
    const {points} = this.arrays;
    return [points[v], points[v + 1], points[v + 2]];
  }

  // Corners of half-faces.
  corners(halfFaces) {
    const {points, tets} = this.arrays;
    const position = new Float32Array(9 * halfFaces.length);
    for (let k = 0, at = 0; k < halfFaces.length; ++k) {
      const first = halfFaces[k] & ~3;
      const face = FACE[halfFaces[k] & 3];
      for (let i = 0; i < 3; ++i) {
        const v = 3 * tets[first + face[i]];
        position[at++] = points[v];
        position[at++] = points[v + 1];
        position[at++] = points[v + 2];
      }
    }
    return position;
  }

  // The slab of each corner.
  slabsOf(count, tetOf) {
    const slab = new Float32Array(3 * count);
    for (let k = 0; k < count; ++k) slab.fill(this.slab[tetOf(k)], 3 * k, 3 * k + 3);
    return slab;
  }

  // What each tet is coloured by, and the colours of that.
  colouring() {
    const {page, arrays} = this;
    if (this.colour === 'slab') return [this.slab, this.slabColours];
    if (this.colour === 'kind') return [arrays.kind, page.kindColours];
    if (this.colour === 'dihedral') return [arrays.dihedral, page.dihedralColours];
    if (this.colour === 'evidence') return [arrays.evidence, page.evidenceColours];
    if (this.colour === 'model') return [null, [this.ownColour()]];
    return [arrays.component, page.componentColours.map((_, c) => this.componentColour(c))];
  }

  ownColour() { return this.page.componentColours[this.number % this.page.componentColours.length]; }

  componentColour(c) {
    const {componentColours} = this.page;
    return componentColours[(this.firstColour + c) % componentColours.length];
  }

  // For each of three corners of a face r, g, b, and 255 where its tet is shown.
  colours(count, tetOf) {
    const [values, list] = this.colouring();
    const words = list.map((c) => (c[0] | c[1] << 8 | c[2] << 16 | 255 << 24) >>> 0);
    const {component} = this.arrays;
    const out = new Uint32Array(3 * count);
    for (let k = 0; k < count; ++k) {
      const tet = tetOf(k);
      let word = words[values === null ? 0 : values[tet] % words.length];
      if (!this.shown[component[tet]]) word &= 0xffffff;
      out[3 * k] = out[3 * k + 1] = out[3 * k + 2] = word;
    }
    return out;
  }

  // a, b and slab of each piece of a contour: all for the slabs below, then for those above, which lie in the
  // same place unless slabs are apart.
  contourLines() {
    const {contours, contour_slabs} = this.arrays;
    const n = contour_slabs.length / 2;
    const lines = new Float32Array(14 * n);
    for (let side = 0; side < 2; ++side) {
      for (let k = 0; k < n; ++k) {
        const at = 7 * (n * side + k);
        for (let i = 0; i < 6; ++i) lines[at + i] = contours[6 * k + i];
        lines[at + 6] = contour_slabs[2 * k + side];
      }
    }
    return lines;
  }

  show(component, on) {
    this.shown[component] = on ? 1 : 0;
    ++this.version;
  }

  showAll(on) {
    this.shown.fill(on ? 1 : 0);
    ++this.version;
  }
}

// What is told of the page as a whole, and its numbers as text.
class Page {
  constructor() {
    Object.assign(this, JSON.parse(document.getElementById('model').textContent));
    this.unitText = this.unit === '' ? '' : '\u00a0' + this.unit;
    this.decimals = 4 - Math.floor(Math.log10(2 * this.length));
  }

  // A coordinate, or a length, to a ten-thousandth of the solid's size: points are known a little better.
  number(x) {
    if (this.decimals > 12 || this.decimals < -8) return x.toPrecision(5);
    return String(Number(x.toFixed(Math.max(0, this.decimals))) + 0).replace('-', '−');
  }

  pointText(p) { return p.map((x) => this.number(x)).join(', ') + this.unitText; }

  lengthText(x) { return this.number(x) + this.unitText; }

  volumeText(x) {
    if (x === null) return '';
    const plain = x !== 0 && (x < 1e-3 || x >= 1e7) ? x.toExponential(2)
      : Number(x.toPrecision(4)).toLocaleString('en', {maximumFractionDigits: 6});
    return plain + (this.unit === '' ? '' : this.unitText + '³');
  }
}
