// Winding numbers of a closed surface, exactly: how many tets lie over one another just
// outside each of its components.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

#include "core/union_find.hpp"

namespace tetloft::internal::checking {

/// A ray upwards from one triangle of a surface.
struct Probe {
  std::uint32_t surface = 0;
  std::array<Point3, 3> corner;  ///< of the triangle
  long winding = 0;
};

/// Winding numbers of surfaces whose triangles come in batches, none above a surface that begins in
/// a batch after its own.
class OuterWinding {
 public:
  /// surface[i]: that of triangle i; all of one set are one surface.
  ///
  /// Requires non-degenerate triangles, oriented outward, without contact. Near-linear for
  /// triangles of similar size.
  void add(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
           std::span<const std::uint32_t> surface, const UnionFind& sets);

  /// Of each surface, named by one of its set, the winding number of all triangles about points
  /// just off its outer side, next to its first triangle that is not vertical. For the boundary
  /// surface of positive tets it is the number of tets that contain such a point. None of a surface
  /// of vertical triangles only, which no closed embedded one is.
  [[nodiscard]] const std::vector<Probe>& probes(const UnionFind& sets) {
    keep_first(sets);
    return probes_;
  }

 private:
  // Of those of one surface; returns the surfaces that have one.
  std::set<std::size_t> keep_first(const UnionFind& sets);
  std::vector<Probe> probes_;
};

/// winding[c]: the same of one batch, of component c; 0 where it has none.
[[nodiscard]] std::vector<long> outer_winding(std::span<const Point3> points,
                                              std::span<const TriangleVertices> triangles,
                                              std::span<const std::uint32_t> component,
                                              std::size_t component_count);

}  // namespace tetloft::internal::checking
