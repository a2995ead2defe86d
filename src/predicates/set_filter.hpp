// Filters with one bound for a whole set of points: the cheapest first stage.
//
// The bounds of filter.hpp with the extents of the set's bounding box for the largest
// differences. Where all coordinates are multiples of one power of two and span few of them,
// the determinants are computed without rounding: then the bound is zero and the sign, zero
// included, is final.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

#include "predicates/determinants.hpp"
#include "predicates/filter.hpp"
#include "predicates/two_doubles.hpp"

namespace tetloft::internal::predicates {

class SetFilter {
 public:
  /// Of no points: it answers nothing.
  SetFilter() = default;
  /// Requires finite coordinates; answers for points of the set only.
  explicit SetFilter(std::span<const Point3> points);
  /// Of point_at(0), point_at(1) …, so many.
  template <class PointAt>
  SetFilter(std::size_t count, const PointAt& point_at) {
    for (std::size_t i = 0; i < count; ++i) take(point_at(i));
    if (count != 0) set_bounds();
  }

  /// Takes a point into the set. Requires finite coordinates.
  void add(const Point3& p) {
    if (p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y && p.z >= low_.z &&
        p.z <= high_.z && !exact_) [[likely]]
      return;
    extend(p);
  }
  /// That of the set and one point more, whose orientations it answers for as well. It is exact for
  /// none.
  [[nodiscard]] SetFilter with(const Point3& p) const;

  /// The set's box; low above high without points.
  [[nodiscard]] const Point3& low() const { return low_; }
  [[nodiscard]] const Point3& high() const { return high_; }

  /// Whether a zero of these filters is the exact sign.
  [[nodiscard]] bool is_exact() const { return exact_; }

  /// As orient3d; 0 where it is not certain.
  [[nodiscard]] int orient3d(const Point3& a, const Point3& b, const Point3& c,
                             const Point3& d) const {
    return certain_sign(orient3d_determinant(b.x - a.x, b.y - a.y, b.z - a.z, c.x - a.x, c.y - a.y,
                                             c.z - a.z, d.x - a.x, d.y - a.y, d.z - a.z),
                        orient3d_bound_);
  }

  /// As insphere; 0 where it is not certain.
  [[nodiscard]] int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                             const Point3& e) const {
    return certain_sign(
        insphere_determinant(a.x - e.x, a.y - e.y, a.z - e.z, b.x - e.x, b.y - e.y, b.z - e.z,
                             c.x - e.x, c.y - e.y, c.z - e.z, d.x - e.x, d.y - e.y, d.z - e.z),
        insphere_bound_);
  }

  /// The same of two simplices and one point.
  [[nodiscard]] std::array<int, 2> insphere(const std::array<const Point3*, 4>& s,
                                            const std::array<const Point3*, 4>& t,
                                            const Point3& e) const {
    const auto x = [&](std::size_t i) {
      return TwoDoubles(s[i]->x, t[i]->x) - TwoDoubles(e.x, e.x);
    };
    const auto y = [&](std::size_t i) {
      return TwoDoubles(s[i]->y, t[i]->y) - TwoDoubles(e.y, e.y);
    };
    const auto z = [&](std::size_t i) {
      return TwoDoubles(s[i]->z, t[i]->z) - TwoDoubles(e.z, e.z);
    };
    const TwoDoubles both = insphere_determinant(x(0), y(0), z(0), x(1), y(1), z(1), x(2), y(2),
                                                 z(2), x(3), y(3), z(3));
    return {certain_sign(both.first(), insphere_bound_),
            certain_sign(both.second(), insphere_bound_)};
  }

 private:
  void extend(const Point3& p);
  void take(const Point3& p);
  void set_bounds();

  // The set's box, and the exponent of a power of two that divides all coordinates, but for points
  // that add() passes over: a filter that is not exact never becomes so, as boxes grow and units
  // become finer, and what else it answers follows from the box.
  Point3 low_{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point3 high_{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  int unit_ = kGreatestUnit;
  double orient3d_bound_ = HUGE_VAL;
  double insphere_bound_ = HUGE_VAL;
  bool exact_ = false;

  // Products of five units must neither under- nor overflow. Coarser units are multiples of the
  // greatest, as zero is of all.
  static constexpr int kLeastUnit = -200;
  static constexpr int kGreatestUnit = 150;
  static constexpr int kNoUnit = kLeastUnit - 1;
};

/// insphere_perturbed where insphere_filter does not answer.
[[nodiscard]] Sign perturbed_insphere_beyond_filter(const Point3& a, const Point3& b,
                                                    const Point3& c, const Point3& d,
                                                    const Point3& e);

/// insphere_perturbed where insphere is known to be zero.
[[nodiscard]] Sign perturbed_insphere_of_cospherical(const Point3& a, const Point3& b,
                                                     const Point3& c, const Point3& d,
                                                     const Point3& e);

/// The same for distinct points of a set whose filter is exact, which tells orientations, too.
/// rank[i] is the place of p[i] in the canonical order of the set.
[[nodiscard]] Sign perturbed_insphere_of_cospherical(const SetFilter& filter,
                                                     const std::array<const Point3*, 5>& p,
                                                     std::array<std::uint32_t, 5> rank);

}  // namespace tetloft::internal::predicates
