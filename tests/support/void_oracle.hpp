// Which voids of sections belong together, and the Euler characteristics that follow, by
// tetloft/voids.hpp, word by word: all pairs, rationals, nothing fast. Shares no code with the
// library but its value types and the rule's numbers.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/section_stack.hpp>

#include "support/link_rule.hpp"

namespace tetloft::oracle {

struct ExpectedTopology {
  /// Decisions or labels name no void or contradict each other.
  bool refused = false;
  bool realised = true;     ///< every label lies in one void
  bool claims_hold = true;  ///< forced and unrealisable links of the model are such as can be
  /// Voids of all sections in one sequence, the exterior of each first, holes by lowest vertices:
  /// equal numbers, the same void of the stack.
  std::vector<std::size_t> set;
  std::set<RegionPair> links;  ///< of voids, accepted or forced
  std::size_t forced = 0, unrealisable = 0;
  /// Per slab, of each group of solid classes, by its lowest region: chi where all touches are
  /// void; and where all are solid.
  std::vector<std::map<std::size_t, long>> chi, chi_of_touches;
};

/// For small stacks of axis-parallel boxes, their lowest corners first, and of triangles (x, y),
/// (x + a, y), (x, y + a). Of the model the links of voids count; `links` are those of regions, as
/// the oracle of correspondence finds them.
[[nodiscard]] ExpectedTopology expected_topology(const Model& model, const SectionStack& stack,
                                                 const VoidOptions& options,
                                                 const std::set<RegionPair>& links);

}  // namespace tetloft::oracle
