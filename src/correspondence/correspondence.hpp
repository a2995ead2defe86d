// Which regions form one component, decided for the whole stack before any complex is
// built: the rule of include/tetloft/correspondence.hpp. And which voids form one cavity, or the
// outside: that of include/tetloft/voids.hpp, on complements of sections (sections/complement.hpp).
#pragma once

#include <set>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"

namespace tetloft::internal {

struct Correspondence {
  /// Accepted links of each slab, sorted.
  IdVector<SlabId, std::vector<Link>> links;
  /// The component of each region: component[section][region], numbered in order of their
  /// first contour by (section, contour).
  IdVector<SectionId, IdVector<RegionId, ComponentId>> component;
  ContourPartition partition;
  /// All that came into question, and what became of it.
  StackCandidates candidates;
};

/// What the user asks for.
struct Asked {
  std::vector<Label> labels;
  std::vector<LinkDecision> decisions;
  /// The regions are the voids of complements, whose exteriors are linked before anything else; no
  /// candidate, and no decision, is about two of them.
  bool voids = false;
};

/// Decides the correspondence from the candidates of rules 1 to 3: rules 4 to 7; of voids, from V1
/// to V3: V4 and V5, on the stack of complements, as whose contours labels and decisions are. Links
/// in `dropped` are none, rule 8. Refused: invalid_input for labels and decisions that name no
/// contour or contradict each other; unrepresentable for labels that cannot be realised, naming
/// contours.
[[nodiscard]] Result<Correspondence> decide_correspondence(
    const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
    const StackSections& sections, StackCandidates candidates, const Asked& asked,
    const std::set<Link>& dropped = {});

}  // namespace tetloft::internal
