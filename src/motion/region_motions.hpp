// How regions move through a slab, estimated from its two sections and the two beside them.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

/// Displacements of regions of one slab, of either section from its lower plane to its upper one;
/// none where not asked for.
struct SlabMotions {
  IdVector<RegionId, std::optional<Point2>> lower, upper;
};

/// Regions of a slab's sections.
struct WantedRegions {
  std::vector<RegionId> lower, upper;
};

/// The motions of the wanted regions, as src/motion/README.md defines them. Each is that of its
/// region alone: it depends neither on what else is wanted nor on the order of contours or where
/// they start. Scaling all coordinates by a power of two scales it, and turning the stack upside
/// down negates it. Multiples of 2^-10 of the greatest power of two that is no larger than the gap.
/// Requires a valid stack and its nestings.
[[nodiscard]] SlabMotions estimate_motions(SlabId slab, const SectionStack& stack,
                                           const IdVector<SectionId, Nesting>& nestings,
                                           const WantedRegions& wanted);

}  // namespace tetloft::internal
