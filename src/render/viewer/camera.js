// Where the eye stands. The projection is parallel: a length has the same size on the screen wherever it lies,
// so that the scale bar holds for all that is seen.
'use strict';

class Camera {
  constructor(azimuth, elevation) {
    this.home = {azimuth, elevation};
    this.look(azimuth, elevation);
    this.unit = 0.005;  // of the page's space, a pixel
    this.target = [0, 0, 0];
    this.lift = 0;  // pixels by which the target is drawn above the middle of the picture
  }

  look(azimuth, elevation) {
    this.azimuth = ((azimuth + 180) % 360 + 360) % 360 - 180;
    this.elevation = Math.max(-90, Math.min(90, elevation));
  }

  axes() {
    const a = this.azimuth * Math.PI / 180;
    const e = this.elevation * Math.PI / 180;
    return {
      right: [-Math.sin(a), Math.cos(a), 0],
      up: [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)],
      toward: [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)],
    };
  }

  // The eye on that side; straight above and below as if it had gone there from the front.
  lookFrom(side) {
    const upright = side[0] === 0 && side[1] === 0;
    this.look(upright ? -90 : Math.atan2(side[1], side[0]) * 180 / Math.PI,
              Math.asin(Math.max(-1, Math.min(1, side[2]))) * 180 / Math.PI);
  }

  // From as near as all `points` are seen in `room` = {width, height, lift}, in pixels.
  fit(points, room) {
    const {right, up} = this.axes();
    const span = (axis) => {
      let low = Infinity;
      let high = -Infinity;
      for (const p of points) {
        const at = dot(axis, p);
        if (at < low) low = at;
        if (at > high) high = at;
      }
      return low < high ? [low, high] : [-0.5, 0.5];
    };
    const [x0, x1] = span(right);
    const [y0, y1] = span(up);
    this.unit = Math.max((x1 - x0) / Math.max(20, room.width), (y1 - y0) / Math.max(20, room.height));
    this.target = plus(times((x0 + x1) / 2, right), times((y0 + y1) / 2, up));
    this.lift = room.lift;
    this.fitted = true;
  }

  // Nearer by `factor`; what is seen (x, y) pixels from the middle stays there.
  zoom(factor, x = 0, y = 0) {
    const before = this.unit;
    // Of points in single precision, known to 6e-8 of the page's space, nothing is seen nearer.
    this.unit = Math.max(1e-7, Math.min(10, this.unit * factor));
    const moved = before - this.unit;
    const {right, up} = this.axes();
    this.target = plus(this.target, plus(times(moved * x, right), times(moved * (y - this.lift), up)));
    this.fitted = false;
  }

  // By pixels to the right and up.
  move(dx, dy) {
    const {right, up} = this.axes();
    this.target = plus(this.target, plus(times(-dx * this.unit, right), times(-dy * this.unit, up)));
    this.fitted = false;
  }

  // Pixels right of and above the middle of the picture, and nearer to the eye.
  project(p) {
    const {right, up, toward} = this.axes();
    const from = minus(p, this.target);
    return [dot(right, from) / this.unit, dot(up, from) / this.unit + this.lift, dot(toward, from) / this.unit];
  }

  // The point of the plane through the target that is seen there.
  unproject(x, y) {
    const {right, up} = this.axes();
    return plus(this.target, plus(times(x * this.unit, right), times((y - this.lift) * this.unit, up)));
  }

  // Of a picture of so many pixels, for what lies in the ball of this radius.
  matrices(width, height, reach) {
    const {right, up, toward} = this.axes();
    const view = new Float32Array([
      right[0], up[0], toward[0], 0,
      right[1], up[1], toward[1], 0,
      right[2], up[2], toward[2], 0,
      -dot(right, this.target), -dot(up, this.target), -dot(toward, this.target), 1,
    ]);
    const room = reach + Math.hypot(...this.target);
    const projection = new Float32Array([
      2 / (width * this.unit), 0, 0, 0,
      0, 2 / (height * this.unit), 0, 0,
      0, 0, -1 / room, 0,
      0, 2 * this.lift / height, 0, 1,
    ]);
    return {view, projection};
  }
}
