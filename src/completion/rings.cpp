// Runs and gaps around edges: the rules of completion within the ring of one edge.
#include <algorithm>

#include "completion/completion.hpp"

namespace tetloft::internal {

bool Completion::fill_rings(SlabVertexId p) {
  to_keep_.clear();
  for (const HalfFaceId c : sheet_) {
    const TetId t = TetMesh::tet_of(c);
    for (const SlabVertexId q : slab_.vertices(t)) {
      if (q == p || !boundary_.take_pinch(q)) continue;
      if (slab_.ring(p, q, t, ring_)) {
        fill_gaps();
      } else {
        fill_run(p, q);
      }
    }
  }
  for (const TetId t : to_keep_) keep(t, classes_.of(p));
  return !to_keep_.empty();
}

// The ring is a path: its attached tets become one run.
void Completion::fill_run(SlabVertexId p, SlabVertexId q) {
  std::size_t first = 0;
  while (!in_sheet(ring_[first])) ++first;
  std::size_t last = ring_.size() - 1;
  while (!in_sheet(ring_[last])) --last;
  bool whole = true;
  for (std::size_t at = first; at <= last; ++at) {
    if (in_sheet(ring_[at])) continue;
    whole = false;
    to_keep_.push_back(ring_[at]);
  }
  if (whole) return;
  if (slab_.is_upper(p) != slab_.is_upper(q)) {
    count(rules_, Rule::run_at_cross_edge);
  } else {
    count(rules_, slab_.edge_kind(p, q) == EdgeKind::contour ? Rule::run_at_contour_edge
                                                             : Rule::run_at_external_edge);
  }
}

// The ring is a cycle, and starts at an attached tet: no gap wraps around unless it ends at its
// end. All gaps but the longest are filled.
void Completion::fill_gaps() {
  struct Gap {
    std::size_t first, last;
    TetId smallest;
  };
  std::vector<Gap> gaps;
  for (std::size_t at = 0; at < ring_.size(); ++at) {
    if (in_sheet(ring_[at])) continue;
    if (at == 0 || in_sheet(ring_[at - 1])) gaps.push_back({at, at, ring_[at]});
    gaps.back().last = at;
    gaps.back().smallest = std::min(gaps.back().smallest, ring_[at]);
  }
  if (gaps.size() < 2) return;
  count(rules_, Rule::gap_at_cross_edge);
  const auto open = std::max_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    const std::size_t la = a.last - a.first;
    const std::size_t lb = b.last - b.first;
    return la != lb ? la < lb : a.smallest < b.smallest;
  });
  for (auto gap = gaps.begin(); gap != gaps.end(); ++gap) {
    if (gap == open) continue;
    for (std::size_t at = gap->first; at <= gap->last; ++at) to_keep_.push_back(ring_[at]);
  }
}

}  // namespace tetloft::internal
