// The topology that a model has: of its parts in each slab, and of what is not solid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/tet_mesh.hpp>

#include "check/resampling.hpp"
#include "check/stack_voids.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// What hangs together by faces of tets between two planes, or beyond the first or last.
struct SlabPart {
  std::int64_t slab = 0;             ///< −1 below the first plane, n − 1 above the last of n
  TetId first;                       ///< a tet of it
  long chi = 0;                      ///< vertices − edges + faces − tets
  std::vector<std::size_t> regions;  ///< on whose contours it has vertices, sorted
};

/// By (slab, first tet). Tets that cross a plane count to the slab of their lowest vertex, and flat
/// ones in a plane for nothing.
[[nodiscard]] std::vector<SlabPart> slab_parts(const ModelView& view, const OnContours& on,
                                               const Regions& regions);

/// Which voids of sections the model's complement joins.
struct ModelVoids {
  std::vector<std::size_t> set;  ///< of each void: equal numbers, the same void
  /// The first triangle of each boundary surface that meets no contour.
  std::vector<TriangleVertices> bubbles;
  std::size_t cavities = 0;  ///< bubbles included
};

/// `surface` is of view.boundary. Requires that the model fills the sections (guarantee 2).
[[nodiscard]] ModelVoids model_voids(const ModelView& view, const SurfaceComponents& surface,
                                     const OnContours& on, const Regions& voids);

}  // namespace tetloft::internal::checking
