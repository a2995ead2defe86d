// The affine dimension of a point set, and points that span it, by exact orientation.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay3_detail {

/// The dimension of the affine hull (−1 without points) and that many + 1 affinely
/// independent points spanning it, by place: place[0 … dimension], increasing, each the
/// first that is independent of those before.
struct AffineBasis {
  int dimension = -1;
  std::array<std::size_t, 4> place{};
};

/// Linear in the number of points.
[[nodiscard]] AffineBasis affine_basis(std::span<const Point3> points);

/// True iff a, b, c lie on one line.
[[nodiscard]] bool collinear(const Point3& a, const Point3& b, const Point3& c);

}  // namespace tetloft::internal::delaunay3_detail
