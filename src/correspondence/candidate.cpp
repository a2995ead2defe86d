#include "correspondence/candidate.hpp"

#include <algorithm>

namespace tetloft::internal {

namespace {

auto place_of(SlabCandidates& candidates, const Link& link) {
  return std::lower_bound(
      candidates.begin(), candidates.end(), link,
      [](const LinkCandidate& candidate, const Link& other) { return candidate.link < other; });
}

}  // namespace

LinkCandidate* find_candidate(SlabCandidates& candidates, const Link& link) {
  const auto at = place_of(candidates, link);
  return at == candidates.end() || at->link != link ? nullptr : &*at;
}

void add_candidate(SlabCandidates& candidates, const LinkCandidate& further) {
  const auto at = place_of(candidates, further.link);
  if (at == candidates.end() || at->link != further.link) {
    candidates.insert(at, further);
  } else if (further.made() || !at->made()) {
    *at = further;
  }
}

}  // namespace tetloft::internal
