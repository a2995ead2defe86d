// Vectors of space, for figures and pictures; signs are for predicates.
#pragma once

#include <cmath>

#include <tetloft/point.hpp>

// A namespace of its own: who needs a few of these names has other ones of his own.
namespace tetloft::internal::vectors {
[[nodiscard]] constexpr Point3 operator+(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] constexpr Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr Point3 operator*(double s, const Point3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
[[nodiscard]] constexpr double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] constexpr Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The unit vector, or `otherwise` for zero.
[[nodiscard]] inline Point3 unit(const Point3& a, const Point3& otherwise = {0, 0, 1}) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : otherwise;
}
[[nodiscard]] constexpr double coordinate(const Point3& a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

}  // namespace tetloft::internal::vectors
