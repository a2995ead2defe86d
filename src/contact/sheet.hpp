// Sheets: a few triangles side by side, bounded in the directions that they have themselves.
//
// Long thin triangles lie in parallel, at a slant to all axes, so that their boxes meet by the
// hundred. What they have in common is a direction and, nearly, a plane. A sheet is a box about
// triangles along their edges and their normals, and two sheets are asked for a plane between them:
// in parallel to one of the two, or to the directions of both, as where strips cross each other.
#pragma once

#include <array>
#include <span>

#include <tetloft/point.hpp>

#include "contact/triangle_pair.hpp"

namespace tetloft::internal::contact_detail {

class Sheet {
 public:
  /// About at least one triangle.
  explicit Sheet(std::span<const Triangle3> triangles);

  /// Is it certain that no triangle of one has a point in common with one of the other?
  [[nodiscard]] bool apart(const Sheet& other) const;

 private:
  void bound(std::span<const Triangle3> triangles);
  [[nodiscard]] bool parted(const Sheet& other, const Point3& normal, const Point3& offset) const;

  /// Every point of the triangles is centre + a0 axis0 + a1 axis1 + a2 axis2 + r with |ak| at most
  /// reach k, and no coordinate of r beyond the slack.
  Point3 centre_;
  std::array<Point3, 3> axes_{};  // along, across and aside; about unit vectors, or zero
  std::array<double, 3> reach_{};
  double slack_;
};

}  // namespace tetloft::internal::contact_detail
