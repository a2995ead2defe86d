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

namespace tetloft::delaunay3_detail {

/// Filters answer for coordinates up to here; PlaneDiagram::distrust_centres() beyond.
inline constexpr double kFarthestFiltered = 0x1p+400;

class Nearer {
 public:
  /// `centres` and `sites`: the diagrams of two planes, `sites_above` telling which is the
  /// upper one.
  Nearer(const PlaneDiagram& centres, const PlaneDiagram& sites, bool sites_above)
      : centres_(&centres), sites_(&sites), sites_above_(sites_above) {}

  /// Is the circumcentre of the finite triangle t nearer to p than to q, perturbed?
  /// (1) Swapping p and q negates the answer, for p ≠ q. (2) For p, q the vertices of an edge
  /// of `sites`: the side of its Voronoi edge's line.
  [[nodiscard]] bool operator()(TriangleId t, VertexId p, VertexId q) const {
    // |c − q|² − |c − p|² = (p − q) · ((c − p) + (c − q)). Rounding: at most 2 u in each sum
    // of two differences, relative to their magnitudes, and u for the other difference, the
    // product and the last sum: 5 u, raised by one for higher orders. The circumcentre's own
    // error counts twice. Underflow: see orient2d_filter. Overflow: with coordinates up to
    // kFarthestFiltered no product exceeds 2^805, as centres with a bound are within 2^400 of
    // their triangle.
    const Circumcentre& c = centres_->centre(t);
    const Point2& a = sites_->point(p);
    const Point2& b = sites_->point(q);
    const double ex = a.x - b.x, ey = a.y - b.y;
    const double ax = c.x - a.x, bx = c.x - b.x;
    const double ay = c.y - a.y, by = c.y - b.y;
    const double value = ex * (ax + bx) + ey * (ay + by);
    const double bound =
        std::abs(ex) * (kCentre * c.radius + kError * (std::abs(ax) + std::abs(bx))) +
        std::abs(ey) * (kCentre * c.radius + kError * (std::abs(ay) + std::abs(by))) + kTiny;
    if (value > bound) return true;
    if (value < -bound) return false;
    return decide(t, p, q);
  }

 private:
  static constexpr double kError = 6 * 0x1p-53;
  static constexpr double kCentre = 2 + 0x1p-40;
  static constexpr double kTiny = 0x1p-900;

  [[nodiscard]] bool decide(TriangleId t, VertexId p, VertexId q) const;

  const PlaneDiagram* centres_;
  const PlaneDiagram* sites_;
  bool sites_above_;
};

/// The sign of (b − a) × (d − c): positive iff turning from a → b to c → d is a left turn.
[[nodiscard]] int turn_between(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

}  // namespace tetloft::delaunay3_detail
