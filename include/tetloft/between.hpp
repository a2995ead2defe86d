// The longer stack: the given sections with those that a reconstruction puts between them, and what
// belongs together in it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

struct BetweenOptions {
  /// Of the given stack.
  CorrespondenceOptions correspondence = {};
  /// How many, as ReconstructOptions::between says.
  std::optional<std::size_t> sections = std::nullopt;
  bool divide_coarse = true;              ///< as of a reconstruction
  double work_limit = kDefaultWorkLimit;  ///< likewise
  Execution execution = {};               ///< threads share the sections and slabs
};

/// Where a section of a longer stack comes from.
struct SectionSource {
  bool inserted = false;
  SectionId section;  ///< of the given stack; invalid of an inserted one
  SlabId slab;        ///< of the given stack, in which an inserted one lies; invalid of a given one
};

struct LongStack {
  /// Valid. Given sections are as they were: the same contours in the same order, each from the
  /// same vertex on, bit for bit.
  SectionStack stack;
  IdVector<SectionId, SectionSource> source;
  /// Of each contour, by section: Reconstruction::partition of the given stack, numbers and all,
  /// with the contours of inserted sections, which belong to no further components.
  IdVector<SectionId, IdVector<ContourId, ComponentId>> component;
  std::size_t components = 0;
  /// With it, and with no sections between (ReconstructOptions::between = 0), the longer stack has
  /// the components and voids of the shorter one: by overlap, without chains and lone regions, a
  /// decision on each pair of regions, and of voids, that is linked, or would be by the rule, or
  /// overlaps without being linked. Sorted by (slab, region, region). By VoidRule::free there are
  /// none of voids.
  CorrespondenceOptions correspondence;
  std::vector<Warning> warnings;  ///< those of a reconstruction
};

/// The stack with the sections that reconstruct() puts between the given ones, with `between` =
/// options.sections and the same correspondence: those of slabs whose solids took them, so it takes
/// as long. Reconstructed by LongStack::correspondence, with
/// nothing put between, it keeps all guarantees as a stack of its
/// own; and the solid is the one that the shorter stack gives, unless in either
/// (1) a slab asked for finer contours to get the topology that links imply
/// (Rule::gabriel_refinement): one between inserted sections does not ask while it is a part of the
/// shorter stack's;
/// (2) coarse contours were divided (ReconstructOptions::divide_coarse): how, depends on the
/// neighbouring sections, which are others in the longer stack.
/// Refused as by reconstruct().
[[nodiscard]] TETLOFT_API Result<LongStack> between(const SectionStack& stack,
                                                    const BetweenOptions& options = {});

}  // namespace tetloft
