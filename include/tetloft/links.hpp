// What belongs together in a stack, and why, link by link: to find the few places that are worth a
// look, and to overrule them (CorrespondenceOptions::decisions). The rule: correspondence.hpp.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/voids.hpp>

namespace tetloft {

struct StackLinks {
  /// Made ones, and those that nearly were: pairs that overlap, or are moved so that they do, and
  /// of each region left without link the nearest. By (slab, lower, upper region).
  std::vector<RegionLink> links;
  /// By `moved`: the motions that are not 0, by (slab, upper, region).
  std::vector<RegionMotion> motions;
  ContourPartition partition;
  std::size_t components = 0;
  /// Of voids: made ones and those that nearly were, by (slab, lower, upper void), the exterior
  /// first, holes by their lowest vertices; the rule in tetloft/voids.hpp. None without holes, nor
  /// by VoidRule::free.
  std::vector<VoidLink> void_links;
  /// Components of voids that are cavities: not of the outside, nor open in the first or last
  /// section. Where a wall is impossible (rule V6) the model has fewer.
  std::size_t cavities = 0;
  std::vector<Warning> warnings;  ///< the hint that most regions have no partner
};

struct LinkOptions {
  CorrespondenceOptions correspondence = {};
  Execution execution = {};  ///< threads share the slabs
};

/// The links of a stack, without making a solid: rules 1 to 7, and V1 to V5. Refused: invalid_input
/// for an invalid stack, or labels and decisions that name no contour or contradict each other;
/// unrepresentable for labels that cannot be realised, naming contours; work_limit as by
/// reconstruct(), with `reverse` alone; usage for options out of range; cancelled if it was
/// stopped.
[[nodiscard]] TETLOFT_API Result<StackLinks> find_links(const SectionStack& stack,
                                                        const LinkOptions& options = {});

/// Links in order of doubt: those first whose |margin|, or of lone regions' links |lead| where that
/// is less, is least; equal ones stay in order. A link that the user parted counts as one he
/// joined.
[[nodiscard]] TETLOFT_API std::vector<RegionLink> least_sure_first(std::vector<RegionLink> links);
/// The same of voids.
[[nodiscard]] TETLOFT_API std::vector<VoidLink> least_sure_first(std::vector<VoidLink> links);

}  // namespace tetloft
