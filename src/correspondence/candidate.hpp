// A pair of regions that came into question as a link, and what is known of it.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/correspondence.hpp>

#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

/// As RegionLink, with regions by number. `fate` made: a candidate of the rule.
struct LinkCandidate {
  Link link;
  Evidence evidence = Evidence::overlap;
  LinkFate fate = LinkFate::made;
  double ratio = 0;
  double moved = 0;
  double distance = 0;
  double margin = 0;
  std::optional<double> lead = std::nullopt;

  [[nodiscard]] bool made() const { return fate == LinkFate::made; }
  [[nodiscard]] double score() const { return moved - distance; }
};

/// Of one slab, one entry for a pair, sorted by link.
using SlabCandidates = std::vector<LinkCandidate>;
/// Of a stack, by slab.
using StackCandidates = IdVector<SlabId, SlabCandidates>;

/// The entry of a pair, or null.
[[nodiscard]] LinkCandidate* find_candidate(SlabCandidates& candidates, const Link& link);
/// Adds one of a pair that may be there already: it replaces that one, unless that is made and
/// this is not.
void add_candidate(SlabCandidates& candidates, const LinkCandidate& further);

}  // namespace tetloft::internal
