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
/// Numbers are rationals, or integers where coordinates are known to be small enough.
template <class Number>
struct Vector3 {
  Number x, y, z;
  friend bool operator==(const Vector3&, const Vector3&) = default;
};
using Point3Q = Vector3<Rational>;
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

/// The vertices (perhaps repeated) of the convex set that two closed triangles share.
[[nodiscard]] std::vector<Point3Q> triangle_intersection(const std::array<Point3Q, 3>& a,
                                                         const std::array<Point3Q, 3>& b);
/// Is p on the closed segment from a to b?
[[nodiscard]] bool on_segment(const Point3Q& p, const Point3Q& a, const Point3Q& b);

template <class Number>
[[nodiscard]] Vector3<Number> difference(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
[[nodiscard]] Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Do no values of one point set under `value` lie strictly between those of the other?
template <class PointsA, class PointsB, class Value>
[[nodiscard]] bool separates(const PointsA& a, const PointsB& b, Value&& value) {
  const auto range = [&](const auto& points) {
    auto low = value(points[0]);
    auto high = low;
    for (std::size_t i = 1; i < points.size(); ++i) {
      auto at = value(points[i]);
      if (at < low) low = at;
      if (high < at) high = at;
    }
    return std::pair(low, high);
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return high_a <= low_b || high_b <= low_a;
}

/// Do the interiors of two tets, not flat, have a common point? Tries every separating plane.
template <class Number>
[[nodiscard]] bool tets_overlap(const std::array<Vector3<Number>, 4>& a,
                                const std::array<Vector3<Number>, 4>& b) {
  const auto separated = [&](const Vector3<Number>& axis) {
    return separates(a, b, [&](const Vector3<Number>& p) { return dot(axis, p); });
  };
  for (const auto* tet : {&a, &b}) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3<Number>& p = (*tet)[(i + 1) % 4];
      if (separated(
              cross(difference((*tet)[(i + 2) % 4], p), difference((*tet)[(i + 3) % 4], p)))) {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = k + 1; l < 4; ++l) {
          const Vector3<Number> axis = cross(difference(a[j], a[i]), difference(b[l], b[k]));
          // Parallel edges give no plane of their own.
          if (!(axis == Vector3<Number>{}) && separated(axis)) return false;
        }
      }
    }
  }
  return true;
}

/// Does a plane through b, or one through an edge of b and b's normal, show that the
/// triangles have nothing in common but what their shared vertices span? So it is if the
/// vertices of a that are none of b's lie strictly on one side of it, b not on that side, and
/// the others on it.
template <class Number>
[[nodiscard]] bool is_beside(const std::array<Vector3<Number>, 3>& a,
                             const std::array<Vector3<Number>, 3>& b) {
  const Vector3<Number> normal = cross(difference(b[1], b[0]), difference(b[2], b[0]));
  const auto beside = [&](const Vector3<Number>& axis, const Vector3<Number>& on) {
    for (const Vector3<Number>& p : a) {
      const Number height = dot(axis, difference(p, on));
      if (Number(0) < height) return false;
      if (height == Number(0) && !(p == b[0] || p == b[1] || p == b[2])) return false;
    }
    return true;
  };
  if (beside(normal, b[0]) || beside(difference({}, normal), b[0])) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (beside(cross(normal, difference(b[(k + 1) % 3], b[k])), b[k])) return true;
  }
  return false;
}

}  // namespace tetloft::oracle
