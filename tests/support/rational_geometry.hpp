// Plane and space geometry in rationals, for oracles: everything by definition, nothing
// fast.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

#include "support/exact/rational.hpp"

namespace tetloft::oracle {

struct Point2Q {
  Rational x, y;
  friend bool operator==(const Point2Q&, const Point2Q&) = default;
};
struct Point3Q {
  Rational x, y, z;
  friend bool operator==(const Point3Q&, const Point3Q&) = default;
};
using Polygon = std::vector<Point2Q>;

[[nodiscard]] Point2Q exactly(const Point2& p);
[[nodiscard]] Point3Q exactly(const Point3& p);

/// Twice the signed area.
[[nodiscard]] Rational twice_area(const Polygon& polygon);
/// (b − a) × (c − a).
[[nodiscard]] Rational turn(const Point2Q& a, const Point2Q& b, const Point2Q& c);
/// Even-odd rule; for points on the boundary either answer.
[[nodiscard]] bool is_inside(const Point2Q& p, const Polygon& polygon);
[[nodiscard]] bool segments_meet(const Point2Q& a, const Point2Q& b, const Point2Q& c,
                                 const Point2Q& d);
/// Simple and pairwise disjoint polygons?
[[nodiscard]] bool are_disjoint_simple(const std::vector<Polygon>& polygons);
/// Do the interiors of the convex hulls of a and b (a segment's: without its ends) have a
/// common point? Of two triangles, or a triangle and a segment.
[[nodiscard]] bool interiors_meet(const Polygon& a, const Polygon& b);
/// Area of the intersection of two regions with even-odd rule.
[[nodiscard]] Rational common_area(const std::vector<Polygon>& a, const std::vector<Polygon>& b);

/// (b − a) × (c − a) · (d − a).
[[nodiscard]] Rational volume6(const Point3Q& a, const Point3Q& b, const Point3Q& c,
                               const Point3Q& d);
/// Do the interiors of two tets, not flat, have a common point? Tries every separating plane.
[[nodiscard]] bool tets_overlap(const std::array<Point3Q, 4>& a, const std::array<Point3Q, 4>& b);
/// The vertices (perhaps repeated) of the convex set that two closed triangles share.
[[nodiscard]] std::vector<Point3Q> triangle_intersection(const std::array<Point3Q, 3>& a,
                                                         const std::array<Point3Q, 3>& b);
/// Is p on the closed segment from a to b?
[[nodiscard]] bool on_segment(const Point3Q& p, const Point3Q& a, const Point3Q& b);

}  // namespace tetloft::oracle
