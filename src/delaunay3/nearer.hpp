// Which of two points of one section a Voronoi vertex of the other is nearer to: the one
// predicate of the slab engine.
//
// It is the perturbed in-sphere predicate of a triangle in one plane and two points in
// another: there the gap cancels and a determinant of degree four in x and y is left
// (two_plane_insphere_determinant). Stages: the circumcentre as computed once, with its bound and
// that of all points; the same by differences from the two points, whose bound is theirs; the
// determinant in doubles; the exact one; the perturbation.
#pragma once

#include <cmath>

#include <tetloft/ids.hpp>

#include "delaunay3/plane_diagram.hpp"

namespace tetloft::internal::delaunay3_detail {

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
        ey_(a_.y - b_.y),
        size_(std::abs(ex_) + std::abs(ey_)),
        offset_(ex_ * (0.5 * (a_.x + b_.x)) + ey_ * (0.5 * (a_.y + b_.y))) {}

  /// Is the circumcentre of triangle t nearer to p than to q, perturbed? Of a ghost: does its
  /// ray end there? Swapping p and q negates the answer.
  [[nodiscard]] bool nearer_to_first(TriangleId t) const {
    // (|c − q|² − |c − p|²) / 2 = e · (c − m) with e = p − q, m their midpoint. Along an axis, with
    // R the reach of the points: the midpoint is off by u R, its product with e and their sum by
    // 2 u |e| R, those of c by 2 u |e c|, the difference by u |e| (|c| + R), e itself by
    // u |e| (|c| + R), and c by its radius: in all |e| (4 u |c| + 5 u R + radius). The constants of
    // slack are higher, for terms of higher order and the rounding of the bound itself.
    // Underflow: a midpoint loses 2^-1075 at most, times e below 2^402; the products lose less.
    // Overflow: centres with a bound are within 2^400 of their triangle, so no product exceeds
    // 2^803.
    const Circumcentre& c = planes_->centres->centre(t);
    const double value = ex_ * c.x + ey_ * c.y - offset_;
    if (std::abs(value) > size_ * c.slack + kTiny) [[likely]]
      return value > 0;
    return look_closer(t);
  }

 private:
  static constexpr double kTiny = 0x1p-660;

  [[nodiscard]] bool look_closer(TriangleId t) const;
  [[nodiscard]] bool decide(TriangleId t) const;
  [[nodiscard]] bool decide_ghost(TriangleId t) const;

  const CentresAndSites* planes_;
  PlaneVertexId p_;
  PlaneVertexId q_;
  Point2 a_;
  Point2 b_;
  double ex_;
  double ey_;
  double size_;    // |ex_| + |ey_|
  double offset_;  // of the line: e · m
};

/// The sign of (b − a) × (d − c): positive iff turning from a → b to c → d is a left turn.
[[nodiscard]] int turn_between(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

}  // namespace tetloft::internal::delaunay3_detail
