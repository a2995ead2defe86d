// The determinants behind the predicates, over any ring: doubles (the filters, whose error
// bounds count the roundings in exactly these expressions), expansions, big integers.
//
// Arguments are differences: a translation moves one of the points into the origin.
#pragma once

namespace tetloft::internal::predicates {

/// b × c, for b and c relative to a.
template <class T>
auto orient2d_determinant(const T& bx, const T& by, const T& cx, const T& cy) {
  return bx * cy - by * cx;
}

/// b × c · d, for b, c, d relative to a.
template <class T>
auto orient3d_determinant(const T& bx, const T& by, const T& bz, const T& cx, const T& cy,
                          const T& cz, const T& dx, const T& dy, const T& dz) {
  return (bx * cy - by * cx) * dz + ((cx * dy - cy * dx) * bz + (dx * by - dy * bx) * cz);
}

/// Rows (x, y, x² + y²) of a, b, c relative to d.
template <class T>
auto incircle_determinant(const T& ax, const T& ay, const T& bx, const T& by, const T& cx,
                          const T& cy) {
  return (ax * ax + ay * ay) * (bx * cy - by * cx) +
         ((bx * bx + by * by) * (cx * ay - cy * ax) + (cx * cx + cy * cy) * (ax * by - ay * bx));
}

/// Minus the determinant of rows (x, y, z, lift) of a, b, c, d.
template <class T, class Lift>
auto lifted_insphere_determinant(const T& ax, const T& ay, const T& az, const T& bx, const T& by,
                                 const T& bz, const T& cx, const T& cy, const T& cz, const T& dx,
                                 const T& dy, const T& dz, const Lift& alift, const Lift& blift,
                                 const Lift& clift, const Lift& dlift) {
  const auto ab = ax * by - bx * ay;
  const auto bc = bx * cy - cx * by;
  const auto cd = cx * dy - dx * cy;
  const auto da = dx * ay - ax * dy;
  const auto ac = ax * cy - cx * ay;
  const auto bd = bx * dy - dx * by;
  const auto abc = (az * bc - bz * ac) + cz * ab;
  const auto bcd = (bz * cd - cz * bd) + dz * bc;
  const auto cda = (cz * da + dz * ac) + az * cd;
  const auto dab = (dz * ab + az * bd) + bz * da;
  return (clift * dab - dlift * abc) + (alift * bcd - blift * cda);
}

/// Minus the determinant of rows (x, y, z, x² + y² + z²) of a, b, c, d relative to e.
template <class T>
auto insphere_determinant(const T& ax, const T& ay, const T& az, const T& bx, const T& by,
                          const T& bz, const T& cx, const T& cy, const T& cz, const T& dx,
                          const T& dy, const T& dz) {
  const auto lift = [](const T& x, const T& y, const T& z) { return (x * x + y * y) + z * z; };
  return lifted_insphere_determinant(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz,
                                     lift(ax, ay, az), lift(bx, by, bz), lift(cx, cy, cz),
                                     lift(dx, dy, dz));
}

/// Where p, q lie on one plane of constant z and r, s, t on another, h above it, the
/// determinant of q, r, s, t relative to p is h times this one: rows (x, y, x² + y²) of q
/// relative to p, and the differences of the rows s − r and t − r, with
/// |s|² − |r|² = (s − r) · (s + r). u = s − r and v = t − r; all else is relative to p.
template <class T>
auto two_plane_insphere_determinant(const T& qx, const T& qy, const T& ux, const T& uy, const T& vx,
                                    const T& vy, const T& rx, const T& ry, const T& sx, const T& sy,
                                    const T& tx, const T& ty) {
  const auto qlift = qx * qx + qy * qy;
  const auto ulift = ux * (sx + rx) + uy * (sy + ry);
  const auto vlift = vx * (tx + rx) + vy * (ty + ry);
  return qlift * (ux * vy - uy * vx) + (vlift * (qx * uy - qy * ux) - ulift * (qx * vy - qy * vx));
}

}  // namespace tetloft::internal::predicates
