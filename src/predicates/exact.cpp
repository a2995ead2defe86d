// The exact stages: expansions where their range is proven to suffice, else integers.
//
// Range of expansions. Let every nonzero coordinate v satisfy 2^L <= |v| < 2^H, and let the
// determinant have degree n. Coordinates are multiples of 2^(L − 52), so all sums, products
// and rounding errors on the way are multiples of 2^(k (L − 52)) with k <= n: representable,
// hence exact without underflow, if n (L − 52) >= -1074. Differences are below 2^(H + 1) and
// the sum of the monomials' magnitudes is below 2^(n (H + 1) + s) (s: 1 for orient2d's 2, 3 for
// orient3d's 6, 4 for incircle's 12, 7 for insphere's 72 of pure coordinates). No partial sum,
// product or component exceeds twice that, and cutting a factor into halves multiplies it by
// 2^27 + 1: no overflow if n (H + 1) + s + 1 + 28 <= 1023.
#include "predicates/exact.hpp"

#include <array>
#include <cmath>

#include "predicates/big_integer.hpp"
#include "predicates/determinants.hpp"
#include "predicates/expansion.hpp"

namespace tetloft::predicates {

namespace {

struct Range {
  double least;
  double limit;

  template <std::size_t n>
  [[nodiscard]] bool holds(const std::array<double, n>& coordinates) const {
    for (const double v : coordinates) {
      if (v != 0 && !(std::abs(v) >= least && std::abs(v) < limit)) return false;
    }
    return true;
  }
};

constexpr Range kOrient2dRange{0x1p-485, 0x1p+495};  // 2 · -537 = -1074, 2 · 496 + 30 = 1022
constexpr Range kOrient3dRange{0x1p-306, 0x1p+329};  // 3 · -358 = -1074, 3 · 330 + 32 = 1022
constexpr Range kIncircleRange{0x1p-216, 0x1p+246};  // 4 · -268 = -1072, 4 · 247 + 33 = 1021
constexpr Range kInsphereRange{0x1p-162, 0x1p+196};  // 5 · -214 = -1070, 5 · 197 + 36 = 1021

Sign to_sign(int s) { return static_cast<Sign>(s); }

/// Largest power of two that divides all coordinates as doubles.
template <std::size_t n>
int common_unit(const std::array<double, n>& coordinates) {
  int unit = 971;
  for (const double v : coordinates) {
    if (v != 0) unit = std::min(unit, Decomposed(v).exponent);
  }
  return unit;
}

/// Evaluates a determinant of differences exactly. The last `dimension` coordinates are the
/// origin, subtracted from all other points; `determinant` takes the array of differences
/// over any ring and returns an element of it.
template <std::size_t dimension, std::size_t n, class Determinant>
Answer exact_sign(const std::array<double, n>& coordinates, const Range& range,
                  const Determinant& determinant) {
  constexpr std::size_t m = n - dimension;
  const auto origin = [](std::size_t i) { return m + i % dimension; };
  if (!range.holds(coordinates)) {
    const int unit = common_unit(coordinates);
    std::array<BigInteger<kCoordinateLimbs + 1>, m> difference;
    for (std::size_t i = 0; i < m; ++i) {
      difference[i] =
          to_big_integer(coordinates[i], unit) - to_big_integer(coordinates[origin(i)], unit);
    }
    return {to_sign(determinant(difference).sign()), &Stages::integer};
  }
  std::array<Rounded, m> difference;
  bool rounded = false;
  for (std::size_t i = 0; i < m; ++i) {
    difference[i] = two_difference(coordinates[i], coordinates[origin(i)]);
    rounded = rounded || difference[i].error != 0;
  }
  if (rounded) {
    std::array<Expansion<2>, m> sum;
    for (std::size_t i = 0; i < m; ++i) sum[i] = to_expansion(difference[i]);
    return {to_sign(determinant(sum).sign()), &Stages::expansion};
  }
  // Most differences of nearby points are doubles, and this is eight times shorter.
  std::array<Expansion<1>, m> single;
  for (std::size_t i = 0; i < m; ++i) single[i] = to_expansion(difference[i].value);
  return {to_sign(determinant(single).sign()), &Stages::expansion};
}

}  // namespace

Answer exact_orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return exact_sign<2>(std::array{b.x, b.y, c.x, c.y, a.x, a.y}, kOrient2dRange,
                       [](const auto& d) { return orient2d_determinant(d[0], d[1], d[2], d[3]); });
}

Answer exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return exact_sign<3>(std::array{b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, a.x, a.y, a.z},
                       kOrient3dRange, [](const auto& p) {
                         return orient3d_determinant(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7],
                                                     p[8]);
                       });
}

Answer exact_incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return exact_sign<2>(
      std::array{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y}, kIncircleRange,
      [](const auto& p) { return incircle_determinant(p[0], p[1], p[2], p[3], p[4], p[5]); });
}

Answer exact_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  return exact_sign<3>(
      std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z},
      kInsphereRange, [](const auto& p) {
        return insphere_determinant(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9],
                                    p[10], p[11]);
      });
}

}  // namespace tetloft::predicates
