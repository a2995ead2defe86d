// Runs and gaps around edges: the rules of completion within the ring of one edge.
#include <algorithm>

#include "completion/completion.hpp"

namespace tetloft::internal {

bool Completion::fill_rings(SlabVertexId p) {
  to_keep_.clear();
  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    if (primary_[k] == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const SlabVertexId q = slab_.vertex(spokes_[k].tet, i);
      // Each pinched link vertex once.
      if (i == spokes_[k].corner || link_vertex_[q].boundary_edges <= 2) continue;
      link_vertex_[q].boundary_edges = 0;
      if (slab_.ring(p, q, spokes_[k].tet, ring_)) {
        fill_gaps();
      } else {
        fill_run(p, q);
      }
    }
  }
  const ClassId c = classes_.of(p);
  for (const TetId t : to_keep_) keep(t, c);
  return !to_keep_.empty();
}

// The ring is a path: its attached tets become one run.
void Completion::fill_run(SlabVertexId p, SlabVertexId q) {
  std::size_t first = 0;
  while (!in_primary(ring_[first])) ++first;
  std::size_t last = ring_.size() - 1;
  while (!in_primary(ring_[last])) --last;
  bool whole = true;
  for (std::size_t at = first; at <= last; ++at) {
    if (in_primary(ring_[at])) continue;
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
    if (in_primary(ring_[at])) continue;
    if (at == 0 || in_primary(ring_[at - 1])) gaps.push_back({at, at, ring_[at]});
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
