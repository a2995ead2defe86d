// Rules of correspondence, by what they link.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "corpus/link_facts.hpp"

namespace tetloft::bench {

/// What is compared with the threshold.
enum class Evidence : std::uint8_t { plain, max, mean, joint, joint_max, three };

struct LinkRule {
  std::string name;
  Evidence evidence = Evidence::plain;
  double tau = 0.02;
  /// The threshold grows by this with the distance in gaps.
  double slope = 0;
  /// A weaker link yields where both regions have one as strong as this; above 1: no guard.
  double guard = 2;
  bool lone = false;
};

/// By slab, the regions linked.
using StackLinks = std::vector<std::vector<std::pair<std::size_t, std::size_t>>>;
[[nodiscard]] StackLinks links_by(const LinkRule& rule, const std::vector<SlabFacts>& slabs);

}  // namespace tetloft::bench
