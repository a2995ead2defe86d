// Where a segment is split.
//
// Plain midpoints need not end at an acute corner: two segments that meet there can split
// each other for ever. On concentric shells around the corner they end: two subsegments
// that reach from the corner to the same shell do not encroach upon each other (Ruppert, "A
// Delaunay refinement algorithm for quality 2-dimensional mesh generation", J. Algorithms
// 18, 1995, section 5; Shewchuk, "Delaunay refinement algorithms for triangular mesh
// generation", Comp. Geom. 22, 2002).
//
// Here all pieces of a segment with an acute end are split on shells, not only the piece at
// the corner: at the roundest radius in the middle third, that which is a multiple of the
// highest power of two. From the corner that is the power of two nearest to the middle;
// farther out it makes segments that leave a corner side by side choose the same radii,
// where midpoints would refine both to the distance between them.
//
// Every rule is symmetric: the point does not depend on the direction of the segment.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay2_detail {

/// The midpoint, each coordinate rounded once, for all finite coordinates.
[[nodiscard]] Point2 midpoint(const Point2& a, const Point2& b);

/// The roundest number in the middle third between two nonnegative numbers in either order.
[[nodiscard]] double roundest_between(double a, double b);

/// True iff c may split the subsegment a b: it lies in their closed bounding box and strictly
/// between them in one coordinate at least.
[[nodiscard]] bool lies_between(const Point2& a, const Point2& c, const Point2& b);

/// A half-line on which to measure radii, from a corner towards a far point.
class Ray {
 public:
  /// Requires distinct points of magnitude at most kLargestSplitCoordinate.
  Ray(const Point2& corner, const Point2& far);

  /// The radius of the far point. Radii are in units of a power of two.
  [[nodiscard]] double length() const { return length_; }

  /// The point at a radius between 0 and length(). Off the exact segment from corner to far
  /// point by at most 2 ulps of its larger coordinates, along each axis: the difference of
  /// the ends, the quotient, the product and the sum are rounded. Monotone in the radius.
  [[nodiscard]] Point2 at(double radius) const;

 private:
  Point2 corner_;
  Point2 direction_;
  double length_;
};

}  // namespace tetloft::internal::delaunay2_detail
