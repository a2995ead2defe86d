// The topology that a model has: of its parts in each slab, and of what is not solid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/tet_mesh.hpp>

#include "check/resampling.hpp"
#include "check/stack_voids.hpp"
#include "check/surfaces.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// What hangs together by faces of tets between two planes, or beyond the first or last.
struct SlabPart {
  std::int64_t slab = 0;             ///< −1 below the first plane, n − 1 above the last of n
  TetId first;                       ///< a tet of it
  long chi = 0;                      ///< vertices − edges + faces − tets
  std::vector<std::size_t> regions;  ///< on whose contours it has vertices
};

struct SlabParts {
  std::vector<SlabPart> parts;  ///< by (slab, first tet)
  /// Of each sound tet its part, or kNone: of flat ones in a plane.
  std::vector<std::uint32_t> part_of;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
};

/// Of a whole or a segment, without their regions. Tets that cross a plane count to the slab of
/// their lowest vertex, and flat ones in a plane for nothing.
[[nodiscard]] SlabParts slab_parts(const ModelView& view);
/// Adds the regions of the contours of `on` to parts; part_of: as above; by contour its region.
void add_regions(const ModelView& view, const OnContours& on,
                 std::span<const std::uint32_t> part_of, std::span<const std::size_t> region_at,
                 std::vector<SlabPart>& parts);

/// Which one of these, regions or voids, each contour bounds.
[[nodiscard]] std::vector<std::size_t> bounded_by(const SectionStack& stack,
                                                  const Regions& regions);

/// Which voids of sections the model's complement joins.
struct ModelVoids {
  std::vector<std::size_t> set;  ///< of each void: equal numbers, the same void
  /// The first triangle of each boundary surface that meets no contour, by numbers of the whole.
  std::vector<TriangleVertices> bubbles;
  std::size_t cavities = 0;  ///< bubbles included
};

/// By surfaces, which know which voids they bound. Requires that the model fills the sections
/// (guarantee 2).
[[nodiscard]] ModelVoids model_voids(std::span<const BoundarySurface> surfaces,
                                     const Regions& voids);

}  // namespace tetloft::internal::checking
