// The predicates by definition: determinants of homogeneous integer matrices, expanded by
// minors, without differences, stages or special cases. Signs as int: -1, 0, 1.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::oracle {

[[nodiscard]] int orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
[[nodiscard]] int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                           const Point3& e);

/// Perturbed in earnest: lifts are raised by actual numbers δ^k, δ that of the point last in
/// canonical order and so small that no greater one could change the sign.
[[nodiscard]] int incircle_perturbed(const Point2& a, const Point2& b, const Point2& c,
                                     const Point2& d);
[[nodiscard]] int insphere_perturbed(const Point3& a, const Point3& b, const Point3& c,
                                     const Point3& d, const Point3& e);

}  // namespace tetloft::oracle
