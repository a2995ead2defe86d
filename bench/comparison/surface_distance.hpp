// Distances between two surfaces, by samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "comparison/nearest.hpp"
#include "comparison/triangle_mesh.hpp"

namespace tetloft::bench {

/// Points of a surface, spread evenly by area: one at random in each of `count` equal parts of the
/// area in order of triangles. Triangles in the planes z = low and z = high are left out: there
/// the ends of a stack are closed, whatever the method. Empty without any others.
[[nodiscard]] std::vector<Point3> sample_surface(const TriangleMesh& mesh, double low, double high,
                                                 std::size_t count, std::uint64_t seed);

struct SurfaceDistance {
  double mean = 0;       ///< of both directions
  double hausdorff = 0;  ///< the largest of a sample, hence a lower bound
};

/// A surface ready to be compared with others.
struct SampledSurface {
  const SurfaceSearch& search;
  const std::vector<Point3>& samples;
};

/// Nothing where one of them has no samples.
[[nodiscard]] std::optional<SurfaceDistance> surface_distance(const SampledSurface& a,
                                                              const SampledSurface& b);

}  // namespace tetloft::bench
