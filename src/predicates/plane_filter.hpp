// The filters of the plane for one set of points: what its triangulation asks in its inner loops.
//
// Where all coordinates are multiples of one power of two and span few of them (pixels), the
// determinants are computed without rounding: then the bounds are zero and the sign, zero
// included, is final. Elsewhere the bounds follow each call's own differences, as the triangles
// of a large set are much smaller than the set.
#pragma once

#include <span>

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

#include "predicates/determinants.hpp"
#include "predicates/filter.hpp"

namespace tetloft::internal::predicates {

class PlaneFilter {
 public:
  /// Of any points.
  PlaneFilter() = default;
  /// Of the points of a set. Requires finite coordinates.
  explicit PlaneFilter(std::span<const Point2> points);

  /// Whether a zero of these filters is the exact sign.
  [[nodiscard]] bool is_exact() const { return exact_; }

  /// From now on p is one of the points.
  void admit(const Point2& p) {
    if (exact_ && !on_lattice(p)) *this = PlaneFilter();
  }

  /// As orient2d; 0 where it is not certain, and where a coordinate is NaN.
  [[nodiscard]] int orient2d(const Point2& a, const Point2& b, const Point2& c) const {
    return orient2d_filter(a, b, c, orient2d_bound_);
  }

  /// As incircle; 0 where it is not certain, and where a coordinate is NaN.
  [[nodiscard]] int incircle(const Point2& a, const Point2& b, const Point2& c,
                             const Point2& d) const {
    return incircle_filter(a, b, c, d, incircle_bound_);
  }

 private:
  [[nodiscard]] bool on_lattice(const Point2& p) const;

  Bound orient2d_bound_ = kOrient2dBound;
  Bound incircle_bound_ = kIncircleBound;
  bool exact_ = false;
  // Where exact: the inverse of the unit, and the box within which differences are small.
  double per_unit_ = 0;
  Point2 low_;
  Point2 high_;
};

/// incircle_perturbed where incircle is known to be zero.
[[nodiscard]] Sign perturbed_incircle_of_cocircular(const Point2& a, const Point2& b,
                                                    const Point2& c, const Point2& d);

}  // namespace tetloft::internal::predicates
