// Which contours form one component, by the rule of tetloft/correspondence.hpp, word by word: all
// pairs, rationals, nothing fast. Shares no code with the library but its value types
// and the rule's numbers.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/model.hpp>
#include <tetloft/section_stack.hpp>

#include "support/link_rule.hpp"

namespace tetloft::oracle {

struct ExpectedSets {
  /// Decisions contradict each other or labels, or name no contour.
  bool refused = false;
  bool realised = true;     ///< every label lies in one set
  bool claims_hold = true;  ///< motions and dropped links of the model are such as the rule has
  std::vector<std::size_t> set;  ///< of contours, all sections in one sequence: equal within a set
  std::size_t dropped = 0;
  /// Accepted, of regions numbered as by regions_of().
  std::set<RegionPair> links;
};

/// For `overlap` and `moved`, small stacks, valid labels. Of the model its motions and its dropped
/// links count.
[[nodiscard]] ExpectedSets expected_sets(const Model& model, const SectionStack& stack,
                                         const CorrespondenceOptions& options);

}  // namespace tetloft::oracle
