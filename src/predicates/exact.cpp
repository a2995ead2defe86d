// The exact stages: expansions where their range is proven to suffice, else integers.
//
// Range of expansions. Let every nonzero coordinate v satisfy 2^L <= |v| < 2^H, and let the
// determinant have degree n. Coordinates are multiples of 2^(L − 52), so all sums, products
// and rounding errors on the way are multiples of 2^(k (L − 52)) with k <= n: representable,
// hence exact without underflow, if n (L − 52) >= -1074. Differences are below 2^(H + 1) and
// the sum of the monomials' magnitudes is below 2^(n (H + 1) + s) (s: 1 for orient2d's 2, 3 for
// orient3d's 6, 5 for incircle's 12 or 20, 7 for insphere's 72 of pure coordinates). No partial
// sum, product or component exceeds twice that, and cutting a factor into halves multiplies it by
// 2^27 + 1: no overflow if n (H + 1) + s + 1 + 28 <= 1023.
#include "predicates/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "arithmetic/bounded_integer.hpp"
#include "arithmetic/corrected.hpp"
#include "arithmetic/expansion.hpp"
#include "predicates/axis_filter.hpp"
#include "predicates/determinants.hpp"
#include "predicates/filter.hpp"
#include "predicates/lattice.hpp"

namespace tetloft::internal::predicates {

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
// Six monomials, s = 3.
constexpr Range kDistanceRange{0x1p-485, 0x1p+494};  // 2 · -537 = -1074, 2 · 495 + 32 = 1022
constexpr Range kOrient3dRange{0x1p-306, 0x1p+329};  // 3 · -358 = -1074, 3 · 330 + 32 = 1022
constexpr Range kIncircleRange{0x1p-216, 0x1p+246};  // 4 · -268 = -1072, 4 · 247 + 34 = 1022
constexpr Range kInsphereRange{0x1p-162, 0x1p+196};  // 5 · -214 = -1070, 5 · 197 + 36 = 1021

Sign to_sign(int s) { return static_cast<Sign>(s); }

/// Largest power of two that divides all coordinates as doubles.
template <std::size_t n>
int common_unit(const std::array<double, n>& p, const std::array<double, n>& q) {
  int unit = 971;
  for (std::size_t i = 0; i < n; ++i) {
    if (p[i] != 0) unit = std::min(unit, Decomposed(p[i]).exponent);
    if (q[i] != 0) unit = std::min(unit, Decomposed(q[i]).exponent);
  }
  return unit;
}

/// The exact sign of a determinant of the differences p[i] − q[i], `determinant` taking their
/// array over any ring. `bits` is what differences may have for 64 bits to hold all
/// intermediate values.
template <int bits, std::size_t n, class Determinant>
Answer exact_sign(const std::array<double, n>& p, const std::array<double, n>& q,
                  const Range& range, const Determinant& determinant) {
  if (!range.holds(p) || !range.holds(q)) {
    const int unit = common_unit(p, q);
    std::array<BoundedInteger<kCoordinateLimbs + 1>, n> difference;
    for (std::size_t i = 0; i < n; ++i) {
      difference[i] = to_big_integer(p[i], unit) - to_big_integer(q[i], unit);
    }
    return {to_sign(determinant(difference).sign()), &Stages::integer};
  }
  std::array<double, n> value;
  std::array<double, n> error;
  bool rounded = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Rounded difference = two_difference(p[i], q[i]);
    value[i] = difference.value;
    error[i] = difference.error;
    rounded |= difference.error != 0;
  }
  if (rounded) {
    std::array<Expansion<2>, n> sum;
    for (std::size_t i = 0; i < n; ++i) sum[i] = to_expansion(Rounded{value[i], error[i]});
    return {to_sign(determinant(sum).sign()), &Stages::expansion};
  }
  if (const auto integers = to_lattice<bits>(value)) {
    const std::int64_t result = determinant(*integers);
    return {to_sign((result > 0) - (result < 0)), &Stages::lattice};
  }
  // Most differences of nearby points are doubles, and products of single components are
  // several times shorter.
  std::array<Expansion<1>, n> single;
  for (std::size_t i = 0; i < n; ++i) single[i] = to_expansion(value[i]);
  return {to_sign(determinant(single).sign()), &Stages::expansion};
}

// Bits of the lattice stage: (monomials) · 2^(degree · bits) < 2^63.
constexpr int kOrient2dBits = 30;  // 2 · 2^60
constexpr int kDistanceBits = 30;  // 6 · 2^60
constexpr int kOrient3dBits = 20;  // 6 · 2^60
constexpr int kIncircleBits = 14;  // 20 · 2^56
constexpr int kInsphereBits = 11;  // 72 · 2^55

Point2 flat(const Point3& p) { return {p.x, p.y}; }

Answer incircle_of(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const int s = incircle_filter(flat(a), flat(b), flat(c), flat(d)); s != 0) {
    return {to_sign(s), &Stages::filter};
  }
  return exact_incircle(flat(a), flat(b), flat(c), flat(d));
}

Answer orient2d_of(const Point3& a, const Point3& b, const Point3& c) {
  if (const int s = orient2d_filter(flat(a), flat(b), flat(c)); s != 0) {
    return {to_sign(s), &Stages::filter};
  }
  return exact_orient2d(flat(a), flat(b), flat(c));
}

/// Points on two planes of constant z, those of the emptier plane first.
template <std::size_t n>
struct TwoPlanes {
  std::array<const Point3*, n> point;
  std::size_t first = 0;  ///< how many lie in the first plane; 0 if all lie in one
  bool even = true;       ///< whether `point` is an even permutation of the arguments

  const Point3& operator[](std::size_t i) const { return *point[i]; }
  /// The sign of (z of the second plane) − (z of the first), negated by an odd permutation.
  [[nodiscard]] Sign gap() const {
    return (point[0]->z < point[n - 1]->z) == even ? Sign::positive : Sign::negative;
  }
};

/// Nothing if the points lie on more than two planes.
template <std::size_t n>
std::optional<TwoPlanes<n>> split_by_plane(const std::array<const Point3*, n>& p) {
  const double z = p[0]->z;
  std::size_t other = 0;
  while (other < n && p[other]->z == z) ++other;
  if (other == n) return TwoPlanes<n>{p};
  const double other_z = p[other]->z;
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (p[i]->z == other_z) {
      ++count;
    } else if (p[i]->z != z) {
      return std::nullopt;
    }
  }
  const double first_z = 2 * count <= n ? other_z : z;
  TwoPlanes<n> result;
  result.first = std::min(count, n - count);
  std::size_t first = 0;
  std::size_t second = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (p[i]->z == first_z) {
      // It moves past all points of the second plane before it.
      if (second % 2 != 0) result.even = !result.even;
      result.point[first++] = p[i];
    } else {
      result.point[result.first + second++] = p[i];
    }
  }
  return result;
}

// The filters in twice the precision, for points that are nearly cospherical or coplanar, as those
// of a sphere or of a tilted plane are after rounding.
//
// Of near points most differences are doubles, and products of these take half the operations.
template <std::size_t n>
class PreciseDifferences {
 public:
  /// p[i] - q.
  PreciseDifferences(const std::array<const Point3*, n>& p, const Point3& q) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<double, 3> from{p[i]->x, p[i]->y, p[i]->z};
      const std::array<double, 3> to{q.x, q.y, q.z};
      for (std::size_t k = 0; k < 3; ++k) {
        const Rounded difference = two_difference(from[k], to[k]);
        value_[3 * i + k] = difference.value;
        error_[3 * i + k] = difference.error;
        most_[k] = std::max(most_[k], std::abs(difference.value));
        rounded_ |= difference.error != 0;
      }
    }
  }

  /// Whether the filters are of use. They leave lattice data to the lattice stage: there zero is
  /// likely.
  template <int bits>
  [[nodiscard]] bool are_suitable() const {
    return largest(most_[0], most_[1], most_[2]) <= kLargest &&
           (rounded_ || !to_lattice<bits>(value_));
  }
  /// The largest magnitude by axis.
  [[nodiscard]] const std::array<double, 3>& most() const { return most_; }

  /// The determinant of their array, with its correction.
  template <class Determinant>
  [[nodiscard]] double evaluate(const Determinant& determinant) const {
    return evaluate(determinant, std::make_index_sequence<3 * n>());
  }

 private:
  template <class Determinant, std::size_t... k>
  [[nodiscard]] double evaluate(const Determinant& determinant, std::index_sequence<k...>) const {
    const Corrected result = rounded_ ? determinant(Corrected{value_[k], error_[k]}...)
                                      : determinant(Halves(value_[k])...);
    return result.value + result.correction;
  }

  std::array<double, 3 * n> value_{};
  std::array<double, 3 * n> error_{};
  std::array<double, 3> most_{};
  bool rounded_ = false;
};

// Of corrected determinants: the error of second order times the number of monomials. One more
// covers terms of third order and the roundings of the bound, as in filter.hpp.
constexpr double kPreciseOrient3dError = (kOrient3dSecondOrder + 1) * 6 * kRounding * kRounding;
constexpr double kPreciseInsphereError = (kInsphereSecondOrder + 1) * 24 * kRounding * kRounding;

int precise_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const PreciseDifferences<3> p({&b, &c, &d}, a);
  if (!p.are_suitable<kOrient3dBits>()) return 0;
  const auto& most = p.most();
  return certain_sign(
      p.evaluate([](const auto&... difference) { return orient3d_determinant(difference...); }),
      kPreciseOrient3dError * most[0] * most[1] * most[2] + kTiny);
}

int precise_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                     const Point3& e) {
  const PreciseDifferences<4> p({&a, &b, &c, &d}, e);
  if (!p.are_suitable<kInsphereBits>()) return 0;
  const auto& most = p.most();
  const double squares = most[0] * most[0] + most[1] * most[1] + most[2] * most[2];
  return certain_sign(
      p.evaluate([](const auto&... difference) { return insphere_determinant(difference...); }),
      kPreciseInsphereError * most[0] * most[1] * most[2] * squares + kTiny);
}

Answer times(Sign s, const Answer& answer) {
  return s == Sign::positive ? answer : Answer{-answer.sign, answer.stage};
}

}  // namespace

Answer exact_orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return exact_sign<kOrient2dBits>(
      std::array{b.x, b.y, c.x, c.y}, std::array{a.x, a.y, a.x, a.y}, kOrient2dRange,
      [](const auto& d) { return orient2d_determinant(d[0], d[1], d[2], d[3]); });
}

Answer exact_cross(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  return exact_sign<kOrient2dBits>(
      std::array{q.x, q.y, s.x, s.y}, std::array{p.x, p.y, r.x, r.y}, kOrient2dRange,
      [](const auto& d) { return orient2d_determinant(d[0], d[1], d[2], d[3]); });
}

Answer exact_two_plane_insphere(const Point2& p, const Point2& q, const Point2& r, const Point2& s,
                                const Point2& t) {
  return exact_sign<kIncircleBits>(
      std::array{q.x, q.y, s.x, s.y, t.x, t.y, r.x, r.y, s.x, s.y, t.x, t.y},
      std::array{p.x, p.y, r.x, r.y, r.x, r.y, p.x, p.y, p.x, p.y, p.x, p.y}, kIncircleRange,
      [](const auto& d) {
        return two_plane_insphere_determinant(d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8],
                                              d[9], d[10], d[11]);
      });
}

Answer exact_distances(const Point3& p, const Point3& a, const Point3& b) {
  return exact_sign<kDistanceBits>(
      std::array{a.x, a.y, a.z, b.x, b.y, b.z}, std::array{p.x, p.y, p.z, p.x, p.y, p.z},
      kDistanceRange, [](const auto& d) {
        return ((d[0] * d[0] - d[3] * d[3]) + (d[1] * d[1] - d[4] * d[4])) +
               (d[2] * d[2] - d[5] * d[5]);
      });
}

Answer exact_distance(const Point3& p, const Point3& a, double radius) {
  return exact_sign<kDistanceBits>(
      std::array{a.x, a.y, a.z, radius}, std::array{p.x, p.y, p.z, 0.0}, kDistanceRange,
      [](const auto& d) { return (d[0] * d[0] + d[1] * d[1]) + (d[2] * d[2] - d[3] * d[3]); });
}

Answer exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const auto p = split_by_plane(std::array{&a, &b, &c, &d})) {
    switch (p->first) {
      case 0: return {Sign::zero, &Stages::lattice};
      // Moving the apex p0 to the end is odd, and it lies gap() below its base.
      case 1: return times(p->gap(), orient2d_of((*p)[1], (*p)[2], (*p)[3]));
      // det(q, r, s) relative to p with heights 0, h, h is −h q × (s − r).
      default:
        return times(-p->gap(),
                     exact_cross(flat((*p)[0]), flat((*p)[1]), flat((*p)[2]), flat((*p)[3])));
    }
  }
  if (const int s = orient3d_axis_filter(a, b, c, d); s != 0) {
    return {to_sign(s), &Stages::filter};
  }
  if (const int s = precise_orient3d(a, b, c, d); s != 0) return {to_sign(s), &Stages::filter};
  return exact_sign<kOrient3dBits>(
      std::array{b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z},
      std::array{a.x, a.y, a.z, a.x, a.y, a.z, a.x, a.y, a.z}, kOrient3dRange, [](const auto& p) {
        return orient3d_determinant(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]);
      });
}

Answer exact_incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return exact_sign<kIncircleBits>(
      std::array{a.x, a.y, b.x, b.y, c.x, c.y}, std::array{d.x, d.y, d.x, d.y, d.x, d.y},
      kIncircleRange,
      [](const auto& p) { return incircle_determinant(p[0], p[1], p[2], p[3], p[4], p[5]); });
}

Answer exact_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  // In a slab between two sections this is every call; z² is linear in z there, and the
  // determinant loses one degree and the gap.
  if (const auto p = split_by_plane(std::array{&a, &b, &c, &d, &e})) {
    switch (p->first) {
      case 0: return {Sign::zero, &Stages::lattice};
      // Moving p0 to the fourth place is odd, and it lies gap() below the circle.
      case 1: return times(p->gap(), incircle_of((*p)[1], (*p)[2], (*p)[3], (*p)[4]));
      default:
        return times(p->gap(), exact_two_plane_insphere(flat((*p)[0]), flat((*p)[1]), flat((*p)[2]),
                                                        flat((*p)[3]), flat((*p)[4])));
    }
  }
  if (const int s = precise_insphere(a, b, c, d, e); s != 0) {
    return {to_sign(s), &Stages::filter};
  }
  if (const int s = insphere_axis_filter(a, b, c, d, e); s != 0) {
    return {to_sign(s), &Stages::filter};
  }
  return exact_sign<kInsphereBits>(
      std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z},
      std::array{e.x, e.y, e.z, e.x, e.y, e.z, e.x, e.y, e.z, e.x, e.y, e.z}, kInsphereRange,
      [](const auto& p) {
        return insphere_determinant(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9],
                                    p[10], p[11]);
      });
}

}  // namespace tetloft::internal::predicates
