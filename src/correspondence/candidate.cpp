#include "correspondence/candidate.hpp"

#include <algorithm>

namespace tetloft::internal {

void add_candidate(SlabCandidates& candidates, const Candidate& further) {
  const auto at = std::lower_bound(
      candidates.begin(), candidates.end(), further.link,
      [](const Candidate& candidate, const Link& link) { return candidate.link < link; });
  if (at == candidates.end() || at->link != further.link) {
    candidates.insert(at, further);
  } else if (!at->made() && further.made()) {
    *at = further;
  }
}

}  // namespace tetloft::internal
