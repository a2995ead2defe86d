// Points of the plane and of space: plain pairs and triples of doubles.
#pragma once

namespace tetloft {

struct Point2 {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

/// The canonical order of points in one plane: lexicographic in (x, y).
/// -0.0 and 0.0 are the same coordinate.
[[nodiscard]] constexpr bool canonical_less(const Point2& a, const Point2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// The canonical order of points in space: by plane first, (z, x, y). The symbolic
/// perturbation, the vertex numbering and every "lowest id" rule follow it.
[[nodiscard]] constexpr bool canonical_less(const Point3& a, const Point3& b) {
  if (a.z != b.z) return a.z < b.z;
  if (a.x != b.x) return a.x < b.x;
  return a.y < b.y;
}

}  // namespace tetloft
