// The model of the page: arrays, unpacked, and what is derived from them.
'use strict';

const FACE = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

// The arrays are base64 of zlib streams of byte planes: first all lowest bytes, and so on.
async function unpack(name, Type) {
  const text = atob(document.getElementById('array-' + name).textContent.trim());
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const size = Type.BYTES_PER_ELEMENT;
  const n = planes.length / size;
  const bytes = new Uint8Array(planes.length);
  for (let k = 0; k < size; ++k) {
    for (let i = 0; i < n; ++i) bytes[i * size + k] = planes[k * n + i];
  }
  return new Type(bytes.buffer);
}

class Mesh {
  static async read() {
    const mesh = new Mesh();
    Object.assign(mesh, JSON.parse(document.getElementById('model').textContent));
    mesh.points = await unpack('points', Float32Array);
    mesh.tets = await unpack('tets', Uint32Array);
    mesh.boundary = await unpack('boundary', Uint32Array);
    mesh.walls = await unpack('walls', Uint32Array);
    mesh.normals = await unpack('normals', Int8Array);
    mesh.component = await unpack('component', Uint32Array);
    mesh.kind = await unpack('kind', Uint8Array);
    mesh.dihedral = await unpack('dihedral', Uint8Array);
    mesh.evidence = await unpack('evidence', Uint8Array);
    mesh.contours = await unpack('contours', Float32Array);
    mesh.contourSlabs = await unpack('contour_slabs', Uint32Array);
    mesh.tetCount = mesh.tets.length / 4;
    mesh.slab = new Uint32Array(mesh.tetCount);
    for (let s = 0; s < mesh.slabFirst.length - 1; ++s) {
      mesh.slab.fill(s, mesh.slabFirst[s], mesh.slabFirst[s + 1]);
    }
    mesh.hidden = new Set();
    mesh.measure();
    return mesh;
  }

  // The heights that each slab, and all, take, and what lies outermost.
  measure() {
    this.slabLow = [];
    this.slabHigh = [];
    for (let s = 0; s < this.slabFirst.length - 1; ++s) {
      let low = Infinity;
      let high = -Infinity;
      for (let i = 4 * this.slabFirst[s]; i < 4 * this.slabFirst[s + 1]; ++i) {
        const z = this.points[3 * this.tets[i] + 2];
        low = Math.min(low, z);
        high = Math.max(high, z);
      }
      this.slabLow.push(low);
      this.slabHigh.push(high);
    }
    this.low = this.slabLow.reduce((a, b) => Math.min(a, b), Infinity);
    this.high = this.slabHigh.reduce((a, b) => Math.max(a, b), -Infinity);
    // x, y, z and slab of the points of each slab that lie farthest in 16 directions across.
    this.outermost = [];
    for (let s = 0; s < this.slabLow.length; ++s) {
      for (let k = 0; k < 16; ++k) {
        const [c, d] = [Math.cos(k * Math.PI / 8), Math.sin(k * Math.PI / 8)];
        let most = -Infinity;
        let at = 0;
        for (let i = 4 * this.slabFirst[s]; i < 4 * this.slabFirst[s + 1]; ++i) {
          const v = 3 * this.tets[i];
          const reach = c * this.points[v] + d * this.points[v + 1];
          if (reach > most) [most, at] = [reach, v];
        }
        for (const z of [this.slabLow[s], this.slabHigh[s]]) {
          this.outermost.push([this.points[at], this.points[at + 1], z, s]);
        }
      }
    }
  }

  colourOf(tet, by) {
    if (by === 'slab') return this.slabColours[this.slab[tet]];
    if (by === 'kind') return this.kindColours[this.kind[tet]];
    if (by === 'dihedral') return this.dihedralColours[this.dihedral[tet]];
    if (by === 'evidence') return this.evidenceColours[this.evidence[tet]];
    return this.componentColours[this.component[tet] % this.componentColours.length];
  }

  // r, g, b, and 255 where the tet is shown, for each of three corners of the half-faces.
  colours(halfFaces, by) {
    const bytes = new Uint8Array(12 * halfFaces.length);
    for (let k = 0; k < halfFaces.length; ++k) {
      const tet = halfFaces[k] >>> 2;
      const colour = this.colourOf(tet, by);
      const shown = this.hidden.has(this.component[tet]) ? 0 : 255;
      for (let i = 12 * k; i < 12 * k + 12; i += 4) {
        bytes[i] = colour[0];
        bytes[i + 1] = colour[1];
        bytes[i + 2] = colour[2];
        bytes[i + 3] = shown;
      }
    }
    return bytes;
  }

  // Corners of half-faces, and the slab of each corner.
  corners(halfFaces) {
    const position = new Float32Array(9 * halfFaces.length);
    const slab = new Float32Array(3 * halfFaces.length);
    for (let k = 0; k < halfFaces.length; ++k) {
      const tet = halfFaces[k] >>> 2;
      const face = FACE[halfFaces[k] & 3];
      for (let i = 0; i < 3; ++i) {
        const v = 3 * this.tets[4 * tet + face[i]];
        position[9 * k + 3 * i] = this.points[v];
        position[9 * k + 3 * i + 1] = this.points[v + 1];
        position[9 * k + 3 * i + 2] = this.points[v + 2];
        slab[3 * k + i] = this.slab[tet];
      }
    }
    return {position, slab};
  }

  // The faces that a cut at height z lays open: triangles, and the outlines of the polygons. Only
  // tets of slabs that reach across can meet it. In a section these are of the slab below, of which
  // all is kept; at the lowest height, where nothing is, the face above.
  cutAt(z, by) {
    const lowest = z <= this.low;
    const position = [];
    const colour = [];
    const slab = [];
    const line = [];
    const p = this.points;
    const crossing = (a, b) => {
      const za = p[3 * a + 2];
      const t = (z - za) / (p[3 * b + 2] - za);
      return [p[3 * a] + t * (p[3 * b] - p[3 * a]), p[3 * a + 1] + t * (p[3 * b + 1] - p[3 * a + 1])];
    };
    for (let s = 0; s < this.slabLow.length; ++s) {
      if (lowest ? this.slabLow[s] > z : !(this.slabLow[s] < z && z <= this.slabHigh[s])) continue;
      for (let tet = this.slabFirst[s]; tet < this.slabFirst[s + 1]; ++tet) {
        if (this.hidden.has(this.component[tet])) continue;
        const below = [];
        const above = [];
        for (let i = 0; i < 4; ++i) {
          const v = this.tets[4 * tet + i];
          (p[3 * v + 2] < z || (lowest && p[3 * v + 2] === z) ? below : above).push(v);
        }
        if (below.length === 0 || above.length === 0) continue;
        const polygon = below.length === 2
          ? [crossing(below[0], above[0]), crossing(below[0], above[1]),
             crossing(below[1], above[1]), crossing(below[1], above[0])]
          : below.flatMap((a) => above.map((b) => crossing(a, b)));
        const c = this.colourOf(tet, by);
        for (let i = 2; i < polygon.length; ++i) {
          for (const q of [polygon[0], polygon[i - 1], polygon[i]]) {
            position.push(q[0], q[1], z);
            colour.push(c[0], c[1], c[2], 255);
            slab.push(s);
          }
        }
        for (let i = 0; i < polygon.length; ++i) {
          const q = polygon[(i + 1) % polygon.length];
          line.push(polygon[i][0], polygon[i][1], z, q[0], q[1], z, s);
        }
      }
    }
    return {
      position: new Float32Array(position),
      colour: new Uint8Array(colour),
      slab: new Float32Array(slab),
      line: new Float32Array(line),
    };
  }

  // a, b and slab of each piece of a contour, for the slabs on both sides.
  contourLines() {
    const n = this.contourSlabs.length / 2;
    const lines = new Float32Array(14 * n);
    for (let k = 0; k < n; ++k) {
      for (let side = 0; side < 2; ++side) {
        const at = 7 * (2 * k + side);
        for (let i = 0; i < 6; ++i) lines[at + i] = this.contours[6 * k + i];
        lines[at + 6] = this.contourSlabs[2 * k + side];
      }
    }
    return lines;
  }
}
