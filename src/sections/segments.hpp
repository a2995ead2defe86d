// How two segments of the plane meet, by orientation tests and comparisons alone.
#pragma once

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

namespace tetloft::internal::sections {

/// Requires a ≠ b. Is p, known to be collinear with a and b, strictly between them?
[[nodiscard]] inline bool strictly_between(const Point2& a, const Point2& b, const Point2& p) {
  return canonical_less(a, b) ? canonical_less(a, p) && canonical_less(p, b)
                              : canonical_less(b, p) && canonical_less(p, a);
}

/// Does p lie on the segment a b, ends excluded?
[[nodiscard]] inline bool in_segment(const Point2& a, const Point2& b, const Point2& p) {
  return strictly_between(a, b, p) && orient2d(a, b, p) == Sign::zero;
}

/// Do the segments a b and c d cross in a point interior to both?
[[nodiscard]] inline bool cross(const Point2& a, const Point2& b, const Point2& c,
                                const Point2& d) {
  const Sign abc = orient2d(a, b, c);
  if (abc == Sign::zero || orient2d(a, b, d) != -abc) return false;
  const Sign cda = orient2d(c, d, a);
  return cda != Sign::zero && orient2d(c, d, b) == -cda;
}

/// Do the closed segments a b and c d share a point? Requires that their boxes do: segments that do
/// not straddle each other's lines are apart, collinear ones share what their boxes share.
[[nodiscard]] inline bool touch(const Point2& a, const Point2& b, const Point2& c,
                                const Point2& d) {
  const auto on_one_side = [](Sign s, Sign t) { return s != Sign::zero && s == t; };
  return !on_one_side(orient2d(a, b, c), orient2d(a, b, d)) &&
         !on_one_side(orient2d(c, d, a), orient2d(c, d, b));
}

}  // namespace tetloft::internal::sections
