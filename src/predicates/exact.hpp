// The exact stages, entered where a filter is not certain.
#pragma once

#include <tetloft/predicates.hpp>

#include "predicates/counting.hpp"

namespace tetloft::internal::predicates {

/// An exact sign and the stage that found it.
struct Answer {
  Sign sign;
  Stage stage;
};

[[nodiscard]] Answer exact_orient2d(const Point2& a, const Point2& b, const Point2& c);
/// The sign of |a − p|² − |b − p|².
[[nodiscard]] Answer exact_distances(const Point3& p, const Point3& a, const Point3& b);
/// The sign of |a − p|² − radius².
[[nodiscard]] Answer exact_distance(const Point3& p, const Point3& a, double radius);
[[nodiscard]] Answer exact_orient3d(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d);
[[nodiscard]] Answer exact_incircle(const Point2& a, const Point2& b, const Point2& c,
                                    const Point2& d);
[[nodiscard]] Answer exact_insphere(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d, const Point3& e);

/// The sign of (q − p) × (s − r).
[[nodiscard]] Answer exact_cross(const Point2& p, const Point2& q, const Point2& r,
                                 const Point2& s);
/// For r, s, t counter-clockwise in one plane of constant z and p, q in another: positive iff
/// the sphere through r, s, t and p does not hold q, that is, if the circumcentre of r, s, t is
/// nearer to p. See two_plane_insphere_determinant.
[[nodiscard]] Answer exact_two_plane_insphere(const Point2& p, const Point2& q, const Point2& r,
                                              const Point2& s, const Point2& t);

}  // namespace tetloft::internal::predicates
