// Where a stack lies in the space of the file that it came from.
#pragma once

#include <array>

#include <tetloft/export.hpp>
#include <tetloft/point.hpp>

namespace tetloft {

/// A positive affine map from the coordinates of a stack, whose sections are planes of constant z,
/// to those of the file: (x, y, z) lies at origin + x · axes[0] + y · axes[1] + z · axes[2]. Files
/// of planes z = const have the identity. Sagittal and coronal planes are turned by exchanging
/// coordinates, which loses no bit; oblique ones by an orthonormal map whose results are rounded
/// once; the voxels of a volume with shear have an affine one.
struct Frame {
  std::array<Point3, 3> axes{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  Point3 origin;
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Whether the map only exchanges coordinates and their signs, so that nothing is rounded.
[[nodiscard]] TETLOFT_API bool is_exact(const Frame& frame);

/// By how much volumes are larger in the file than in the stack: 1 of an orthonormal map, whose
/// rounding does not count; else the determinant of the axes.
[[nodiscard]] TETLOFT_API double volume_factor(const Frame& frame);

/// Where a point of the stack lies in the file: each coordinate is the sum of its terms that are
/// not 0, of x, y, z and the origin in this order.
[[nodiscard]] TETLOFT_API Point3 place(const Frame& frame, const Point3& point);

}  // namespace tetloft
