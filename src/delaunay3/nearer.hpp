// Which of two points of one section a Voronoi vertex of the other is nearer to: the one
// predicate of the slab engine.
//
// It is the perturbed in-sphere predicate of a triangle in one plane and two points in
// another: there the gap cancels and a determinant of degree four in x and y is left
// (two_plane_insphere_determinant). Stages: the circumcentre as computed once, with its
// bound; the determinant in doubles; the exact one; the perturbation.
#pragma once

#include <cmath>

#include <tetloft/ids.hpp>

#include "delaunay3/plane_diagram.hpp"

namespace tetloft::internal::delaunay3_detail {

/// Filters answer for coordinates up to here; PlaneDiagram::distrust_centres() beyond.
inline constexpr double kFarthestFiltered = 0x1p+400;

/// The diagrams of two planes: `centres` are those of one, `sites` the vertices of the other.
struct CentresAndSites {
  const PlaneDiagram* centres;
  const PlaneDiagram* sites;
  bool sites_above;
};

/// The line of points equally near to two sites p ≠ q.
class Bisector {
 public:
  Bisector(const CentresAndSites& planes, PlaneVertexId p, PlaneVertexId q)
      : planes_(&planes),
        p_(p),
        q_(q),
        a_(planes.sites->point(p)),
        b_(planes.sites->point(q)),
        ex_(a_.x - b_.x),
        ey_(a_.y - b_.y) {}

  /// Is the circumcentre of triangle t nearer to p than to q, perturbed? Of a ghost: does its
  /// ray end there? Swapping p and q negates the answer.
  [[nodiscard]] bool nearer_to_first(TriangleId t) const {
    // |c − q|² − |c − p|² = (p − q) · ((c − p) + (c − q)). Rounding: at most 2 u in each sum
    // of two differences, relative to their magnitudes, and u for the other difference, the
    // product and the last sum: 5 u, raised by one for higher orders. The circumcentre's own
    // error counts twice. Underflow: see orient2d_filter. Overflow: with coordinates up to
    // kFarthestFiltered no product exceeds 2^805, as centres with a bound are within 2^400 of
    // their triangle.
    const Circumcentre& c = planes_->centres->centre(t);
    const double ax = c.x - a_.x, bx = c.x - b_.x;
    const double ay = c.y - a_.y, by = c.y - b_.y;
    const double value = ex_ * (ax + bx) + ey_ * (ay + by);
    const double bound = kError * (std::abs(ex_) * (std::abs(ax) + std::abs(bx)) +
                                   std::abs(ey_) * (std::abs(ay) + std::abs(by))) +
                         (kCentre * (std::abs(ex_) + std::abs(ey_)) * c.radius + kTiny);
    if (std::abs(value) > bound) [[likely]]
      return value > 0;
    return decide(t);
  }

 private:
  static constexpr double kError = 6 * 0x1p-53;
  static constexpr double kCentre = 2 + 0x1p-40;
  static constexpr double kTiny = 0x1p-900;

  [[nodiscard]] bool decide(TriangleId t) const;
  [[nodiscard]] bool decide_ghost(TriangleId t) const;

  const CentresAndSites* planes_;
  PlaneVertexId p_;
  PlaneVertexId q_;
  Point2 a_;
  Point2 b_;
  double ex_;
  double ey_;
};

/// The sign of (b − a) × (d − c): positive iff turning from a → b to c → d is a left turn.
[[nodiscard]] int turn_between(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

}  // namespace tetloft::internal::delaunay3_detail
