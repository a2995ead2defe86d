// The floating-point filters: signs that rounding cannot have changed.
//
// A filter evaluates the determinant in doubles, in exactly the expressions of
// determinants.hpp, and compares it with a bound of its error. It answers 1 or -1 when the
// sign is certain and 0 when it is not; never a wrong sign for any finite arguments.
//
// Error bounds, with u = 2^-53. The computed value is the sum of the determinant's
// monomials, each multiplied by one factor 1 + δ, |δ| <= u, for each rounding on its way:
// k roundings at most, hence |computed − exact| <= ((1 + u)^k − 1) P, where P is the sum of
// the monomials' magnitudes. With mx, my, mz the largest computed |difference| along each
// axis, P is below the number of monomials times a product of these, times (1 + u)^5 for
// the roundings of the differences. The first-order constant, k times the number of
// monomials, is raised by one: that is at least 1/385 of it, while second-order terms and
// the roundings of the bound itself add a relative 40 u at most.
// (Shewchuk 1997, section 4, bounds P by a second evaluation instead. The largest
// differences cost fewer operations: Devillers and Pion, "Efficient exact geometric
// predicates for Delaunay triangulations", ALENEX 2003.)
//
// Underflow adds an absolute error. In the determinant: at most 2^-1075 for each of fewer
// than 2^7 products, each multiplied by at most 2^5 monomials of degree three at most in
// differences below kLargest = 2^160, in total less than 2^-583. In the bound: 2^-1075 times
// at most 3 · 2^640, thrice, in total less than 2^-432. kTiny covers both. Overflow cannot
// occur below kLargest: no intermediate value exceeds 72 · 2^800. Differences that overflow
// are larger.
#pragma once

#include <algorithm>
#include <cmath>

#include <tetloft/point.hpp>

#include "predicates/determinants.hpp"

namespace tetloft::internal::predicates {

inline constexpr double kRounding = 0x1p-53;
inline constexpr double kLargest = 0x1p+160;
inline constexpr double kTiny = 0x1p-400;

/// k = 8 (difference, product, 2 × 2 difference, difference and product along the third
/// axis, two sums: at most 3 + 1 + 2 + 2), 6 monomials.
inline constexpr double kOrient3dError = (8 * 6 + 1) * kRounding;
/// k = 11 (4 for a lift, 4 for a 2 × 2 minor, a product, two sums). By Cauchy and Schwarz the
/// magnitudes |bx cy| + |by cx| of a minor are at most √(blift · clift) <= (blift + clift) / 2,
/// so P <= alift · blift + blift · clift + clift · alift <= S² / 3, S the sum of the lifts: 11 / 3,
/// raised by a third, a relative 1/11, for all terms of higher order and the roundings of S².
/// The same inequality bounds every intermediate value: nothing overflows unless S² does.
inline constexpr double kIncircleError = 4 * kRounding;
/// k = 16 (5 for a lift, 8 for a 3 × 3 minor, a product, two sums), 24 monomials xyz·lift.
inline constexpr double kInsphereError = (16 * 24 + 1) * kRounding;
/// l − r of two products with three roundings each: the last subtraction keeps the sign of
/// its operands' difference, so |l − r| > ((1 + u)^3 − 1) / (1 − u)^3 (|l| + |r|) suffices;
/// with the roundings of l − r, of |l| + |r| and of the bound that is 3 u + 21 u² (+ O(u³)).
inline constexpr double kOrient2dError = (3 + 32 * kRounding) * kRounding;
/// Each product loses 2^-1075 at most by underflow. No limit from above: if a product
/// overflows so does the bound.
inline constexpr double kOrient2dTiny = 0x1p-1000;

/// The error of a determinant: `relative` times a magnitude that its filter defines, and a rest.
/// Both are zero where it is known to be computed without rounding.
struct Bound {
  double relative;
  double absolute;
};
inline constexpr Bound kOrient2dBound{kOrient2dError, kOrient2dTiny};
/// Underflow in the determinant: 2^-1075 for each product, times a lift or a minor at most for
/// those within lifts and minors, in total less than 2^-1068 (S + 1): up to S = 1 less than kTiny,
/// beyond less than the slack of u S².
inline constexpr Bound kIncircleBound{kIncircleError, kTiny};

/// Needs no branch: a comparison with a bound that is NaN is false.
inline int certain_sign(double determinant, double bound) {
  return static_cast<int>(determinant > bound) - static_cast<int>(determinant < -bound);
}

inline double largest(double a, double b, double c) {
  return std::max(std::max(std::abs(a), std::abs(b)), std::abs(c));
}

inline double largest(double a, double b, double c, double d) {
  return std::max(std::max(std::abs(a), std::abs(b)), std::max(std::abs(c), std::abs(d)));
}

inline int orient2d_filter(const Point2& a, const Point2& b, const Point2& c,
                           const Bound& bound = kOrient2dBound) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  return certain_sign(left - right,
                      bound.relative * (std::abs(left) + std::abs(right)) + bound.absolute);
}

inline int orient3d_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  const double dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
  const double mx = largest(bx, cx, dx), my = largest(by, cy, dy), mz = largest(bz, cz, dz);
  if (!(largest(mx, my, mz) <= kLargest)) return 0;
  return certain_sign(orient3d_determinant(bx, by, bz, cx, cy, cz, dx, dy, dz),
                      kOrient3dError * mx * my * mz + kTiny);
}

inline int incircle_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d,
                           const Bound& bound = kIncircleBound) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double lifts = (ax * ax + ay * ay) + ((bx * bx + by * by) + (cx * cx + cy * cy));
  return certain_sign(incircle_determinant(ax, ay, bx, by, cx, cy),
                      bound.relative * (lifts * lifts) + bound.absolute);
}

/// k = 11 (5 for a difference of lifts, 3 for a minor, a product, two sums). In the largest
/// differences: qlift · (ux vy − uy vx) is at most 2 mx my (mx² + my²), and each of the two
/// other products 4 mx my (mx² + my²), as ulift and vlift have factors that are sums of two.
inline constexpr double kTwoPlaneInsphereError = (11 * 10 + 1) * kRounding;

/// See exact_two_plane_insphere.
inline int two_plane_insphere_filter(const Point2& p, const Point2& q, const Point2& r,
                                     const Point2& s, const Point2& t) {
  const double qx = q.x - p.x, qy = q.y - p.y;
  const double ux = s.x - r.x, uy = s.y - r.y;
  const double vx = t.x - r.x, vy = t.y - r.y;
  const double rx = r.x - p.x, ry = r.y - p.y;
  const double sx = s.x - p.x, sy = s.y - p.y;
  const double tx = t.x - p.x, ty = t.y - p.y;
  const double mx = std::max(largest(qx, ux, vx), largest(rx, sx, tx));
  const double my = std::max(largest(qy, uy, vy), largest(ry, sy, ty));
  if (!(std::max(mx, my) <= kLargest)) return 0;
  return certain_sign(
      two_plane_insphere_determinant(qx, qy, ux, uy, vx, vy, rx, ry, sx, sy, tx, ty),
      kTwoPlaneInsphereError * mx * my * (mx * mx + my * my) + kTiny);
}

inline int insphere_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                           const Point3& e) {
  const double ax = a.x - e.x, ay = a.y - e.y, az = a.z - e.z;
  const double bx = b.x - e.x, by = b.y - e.y, bz = b.z - e.z;
  const double cx = c.x - e.x, cy = c.y - e.y, cz = c.z - e.z;
  const double dx = d.x - e.x, dy = d.y - e.y, dz = d.z - e.z;
  const double mx = largest(ax, bx, cx, dx);
  const double my = largest(ay, by, cy, dy);
  const double mz = largest(az, bz, cz, dz);
  if (!(largest(mx, my, mz) <= kLargest)) return 0;
  return certain_sign(insphere_determinant(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz),
                      kInsphereError * mx * my * mz * (mx * mx + my * my + mz * mz) + kTiny);
}

}  // namespace tetloft::internal::predicates
