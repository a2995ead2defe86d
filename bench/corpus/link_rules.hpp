// Rules of correspondence, by what they link.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/link_facts.hpp"

namespace tetloft::bench {

/// What a rule compares with its threshold: overlap as regions lie, or moved overlap, of which the
/// larger, the mean, or that under the mean of both motions. Or links by reverse tets alone.
enum class Evidence : std::uint8_t { reverse, plain, moved_larger, moved_mean, moved_both };

struct LinkRule {
  std::string name;
  Evidence evidence = Evidence::plain;
  double tau = 0;
  /// The threshold grows by this with the distance in gaps.
  double slope = 0;
  /// A weaker link yields where both regions have one as strong as this; above 1: no guard.
  double guard = 2;
  /// Regions without any link get one.
  bool lone = false;
};

[[nodiscard]] std::vector<LinkRule> link_rules();

/// The links of each slab.
[[nodiscard]] std::vector<Pairs> links_by(const LinkRule& rule,
                                          const std::vector<SlabFacts>& slabs);

}  // namespace tetloft::bench
