// A pair of regions that came into question as a link, and what is known of it.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/correspondence.hpp>

#include "slab/link.hpp"

namespace tetloft::internal {

/// As RegionLink, with regions by number. `fate` made: a candidate of the rule.
struct Candidate {
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
using SlabCandidates = std::vector<Candidate>;
/// Of a stack, by slab.
using StackCandidates = IdVector<SlabId, SlabCandidates>;

/// Adds one of a pair that may be there already: a made one replaces one that is not.
void add_candidate(SlabCandidates& candidates, const Candidate& further);

}  // namespace tetloft::internal
