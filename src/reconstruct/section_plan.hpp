// What is decided over a stack about one section and the slab above it: the part of a plan that
// windows are put together from. And as bytes, for machines that have nothing else.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "correspondence/correspondence.hpp"

namespace tetloft::internal {

/// Which components the regions of a section belong to, and its contours.
struct SectionComponents {
  IdVector<RegionId, ComponentId> of_region;
  IdVector<ContourId, ComponentId> of_contour;
};

/// Links of a slab, accepted ones sorted, and all that came into question. Their slab is 0.
struct SlabDecision {
  std::vector<Link> links;
  SlabCandidates candidates;
};

struct SectionPlan {
  Section section;  ///< in the plan's unit
  SectionComponents regions;
  /// Of complements (sections/complement.hpp); none where nothing is decided about voids.
  std::optional<SectionComponents> voids;

  // The slab above; of the last section empty.
  SlabDecision region_links;
  SlabDecision void_links;
  std::vector<RegionMotion> motions;  ///< in the plan's unit; their slab is 0
};

[[nodiscard]] std::string to_record(const SectionPlan& plan);

/// What to_record() wrote, the same in every bit. Refused (invalid_input; `name` stands for the
/// file) where the bytes are no such record. That it fits its section, and the next one, is for the
/// window to check (window.hpp).
[[nodiscard]] Result<SectionPlan> section_plan_from_record(std::string_view bytes,
                                                           const std::string& name);

}  // namespace tetloft::internal
