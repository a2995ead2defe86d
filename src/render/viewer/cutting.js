// The plane that cuts: in the page's space, and as each model has it.
'use strict';

// Heights are those of points in single precision, of at most 1: known to 6e-8, and what is computed of them to a
// few times that. Nearer than this they are the same; a pixel at first is a thousand times as much.
const SAME_HEIGHT = 2e-6;

// What double precision leaves of unit vectors that are the same, or opposite; it moves no point by what single
// precision tells apart.
const parallel = (a, b) => Math.hypot(...cross(a, b)) < 1e-7;

const AXES = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};

// What lies below the plane dot(normal, p) = at stays. From the top of what is shown on nothing is cut.
class Cut {
  constructor(layers) {
    this.layers = layers;
    this.mode = 'sections';
    this.flipped = false;
    this.at = Infinity;
    this.along = layers[0];
    this.normal = this.sectionNormal();
    this.remembered = null;
    this.findRange();
  }

  get on() { return this.at !== Infinity; }

  // Across the sections of the model `along`.
  sectionNormal() { return unitOf(this.along.inverse[2]); }

  // Heights of that model's sections along the normal.
  sectionsAt() {
    if (this.mode !== 'sections') return [];
    const {place, sections} = this.along;
    const rise = dot(this.normal, column(place, 2));
    const base = dot(this.normal, column(place, 3));
    const all = sections.map((z) => base + rise * z);
    return this.flipped ? all.reverse() : all;
  }

  // The heights of what there is: from one end, where nothing is left, to the other.
  findRange() {
    this.low = Infinity;
    this.high = -Infinity;
    for (const layer of this.layers) {
      const {normal} = this.planeOf(layer, 0);
      const heights = heightsOf(layer, normal);
      const base = dot(this.normal, column(layer.place, 3));
      const factor = Math.hypot(...pulledBack(layer.place, this.normal));
      this.low = Math.min(this.low, base + factor * heights.low);
      this.high = Math.max(this.high, base + factor * heights.high);
    }
  }

  // A height as a part of the way up, and back.
  partOf(at) { return (at - this.low) / (this.high - this.low || 1); }

  heightAt(part) { return this.low + part * (this.high - this.low); }

  // The cut that the page asks for at first, across an axis of the stack. Of x and y the part away from the eye stays.
  start({cutAxis, cut}, toward) {
    if (cut === null) return;
    const {place, inverse} = this.along;
    if (cutAxis !== 2) {
      this.normal = unitOf(inverse[cutAxis]);
      this.mode = Object.keys(AXES).find((name) => parallel(AXES[name], this.normal)) || 'oblique';
      this.findRange();
    }
    const at = dot(this.normal, column(place, 3)) + cut * dot(this.normal, column(place, cutAxis));
    this.set(at);
    if (cutAxis !== 2 && dot(this.normal, toward) < 0) {
      this.flip();
      this.set(-at);
    }
  }

  point(mode, normal) {
    const part = this.on ? this.partOf(this.at) : null;
    this.mode = mode;
    this.flipped = false;
    this.normal = unitOf(normal);
    this.findRange();
    // Who asks for a direction wants to see a cut.
    this.set(this.heightAt(part === null ? 0.5 : part));
  }

  flip() {
    this.flipped = !this.flipped;
    this.normal = times(-1, this.normal);
    this.findRange();
    if (this.on) this.at = -this.at;
  }

  // Heights along the normal that are told apart: of a solid that is thin that way they are finer.
  get near() { return SAME_HEIGHT * (this.high - this.low) / 2; }

  set(at) {
    // Rounded from a height of a section, the top is no cut either.
    this.at = at >= this.high - this.near ? Infinity : Math.max(this.low, at);
    if (this.on) this.remembered = this.partOf(this.at);
  }

  toggle() {
    const part = this.remembered === null ? 0.5 : this.remembered;
    this.set(this.on ? Infinity : this.heightAt(part));
  }

  // To the next section up or down, or by a fiftieth; past the last: the whole solid.
  step(way) {
    const from = Math.min(this.at, this.high);
    const {near} = this;
    const stops = this.sectionsAt();
    if (stops.length === 0) {
      this.set(from + way * (this.high - this.low) / 50);
      return;
    }
    const next = way > 0 ? stops.find((h) => h > from + near) : stops.filter((h) => h < from - near).pop();
    if (next !== undefined) this.set(next);
    else if (way > 0) this.set(Infinity);
  }

  // As the model has it: a unit normal in its own coordinates, and the height. Along its sections the normal is
  // ±z exactly, and the height of a section is that of its points.
  planeOf(layer, at = this.at) {
    let normal = pulledBack(layer.place, this.normal);
    const length = Math.hypot(...normal) || 1;
    normal = times(1 / length, normal);
    let height = (at - dot(this.normal, column(layer.place, 3))) / length;
    if (parallel(normal, AXES.z)) {
      const sign = Math.sign(normal[2]);
      normal = [0, 0, sign];
      const near = layer.sections.find((z) => Math.abs(sign * z - height) < SAME_HEIGHT);
      if (near !== undefined) height = sign * near;
    }
    return {normal, height};
  }

  text(page) {
    if (!this.on) return 'the whole solid';
    const sign = this.flipped ? -1 : 1;
    const {normal, height} = this.planeOf(this.along);
    const own = times(height, normal);
    const file = mapped(this.along.file, own);
    const axis = AXES[this.mode];
    // Heights that are stretched across an oblique plane leave it no one coordinate.
    if (axis && parallel(unitOf(pulledBack(this.along.file, axis)), normal)) {
      return `${this.mode} = ${page.number(dot(axis, file))}${page.unitText}`;
    }
    if (this.mode !== 'sections') {
      return `${page.number((this.at - (this.low + this.high) / 2) * page.length)}${page.unitText} from the middle`;
    }
    const z = sign * height;
    const stack = page.number(stackHeight(this.along, z));
    return [`z = ${stack}${page.unitText}`, sectionText(this.along, z)].filter((text) => text !== '').join(' · ');
  }
}

// Where a height of a layer's own lies among its sections; empty for a model that does not tell of any.
function sectionText(layer, z) {
  const {sections} = layer;
  if (sections.length === 0) return '';
  const below = sections.filter((at) => at <= z + SAME_HEIGHT).length - 1;
  if (below < 0) return 'below section 0';
  if (Math.abs(sections[below] - z) < SAME_HEIGHT) return `section ${below}`;
  return below + 1 === sections.length ? `above section ${below}` : `sections ${below} to ${below + 1}`;
}

// The z of the stack's own coordinates, which sections are told by, for a height of the layer's own.
function stackHeight(layer, z) {
  return layer.stackZ[0] + layer.stackZ[1] * z;
}
