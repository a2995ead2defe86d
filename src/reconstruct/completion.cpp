#include "reconstruct/completion.hpp"

#include <algorithm>
#include <bit>
#include <functional>

#include "core/check.hpp"

namespace tetloft {

Completion::Completion(const Slab& slab, const SlabClasses& classes,
                       const IdVector<ClassId, std::uint8_t>& active, Complex complex,
                       RuleCounts& rules)
    : slab_(slab),
      classes_(classes),
      active_(active),
      complex_(std::move(complex)),
      rules_(rules),
      queued_(slab.vertex_count(), 0),
      spoke_of_(slab.mesh().tet_slots(), kHull),
      seen_(slab.vertex_count(), 0) {}

std::vector<Unconnectable> Completion::run() {
  for (std::size_t v = 0; v < slab_.vertex_count(); ++v) {
    if (active_[classes_.of(VertexId(v))] != 0) enqueue(VertexId(v));
  }
  settle_queue();

  std::vector<Unconnectable> left;
  for (std::size_t k = 0; k < classes_.class_count(); ++k) {
    const ClassId c(k);
    if (active_[c] == 0 || classes_.is_lone(c)) continue;
    for (;;) {
      const UnionFind sets = parts();
      const auto& regions = classes_.regions(c);
      const bool connected = std::all_of(regions.begin(), regions.end(), [&](SlabRegionId r) {
        return sets.same(r.index(), regions.front().index());
      });
      if (connected) break;
      if (!connect_class(c, sets)) {
        left.push_back({c, regions});
        break;
      }
      settle_queue();
    }
  }
  if (left.empty()) fill_convex();
  return left;
}

void Completion::enqueue(VertexId v) {
  if (queued_[v] != 0) return;
  queued_[v] = 1;
  heap_.push_back(v);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void Completion::keep(TetId t, ClassId c) {
  const std::uint8_t mask = own_corners(slab_, classes_, t, c);
  complex_.kept[t] = static_cast<std::uint8_t>(complex_.kept[t] | mask);
  for (int i = 0; i < 4; ++i) {
    if (has_corner(mask, i)) enqueue(slab_.mesh().vertex(t, i));
  }
}

void Completion::settle_queue() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const VertexId v = heap_.back();
    heap_.pop_back();
    settle(v);
    queued_[v] = 0;
  }
}

void Completion::settle(VertexId p) {
  gather_star(p);
  do {
    find_primary_sheet();
  } while (fill_rings(p) || fill_holes(p));

  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    if (primary_[k] == 0) continue;
    std::uint8_t& attached = complex_.attached[spokes_[k].tet];
    attached = static_cast<std::uint8_t>(attached | (1U << spokes_[k].corner));
  }
}

void Completion::gather_star(VertexId p) {
  spokes_.clear();
  for (const Slab::StarEntry& entry : slab_.star(p)) {
    spoke_of_[entry.tet] = static_cast<std::int32_t>(spokes_.size());
    spokes_.push_back({entry.tet, entry.corner, {}});
  }
  for (Spoke& spoke : spokes_) {
    for (int i = 0; i < 4; ++i) {
      if (i == spoke.corner) continue;
      const TetId across = slab_.mesh().neighbour(spoke.tet, i);
      spoke.next[static_cast<std::size_t>(i)] = across.valid() ? spoke_of_[across] : kHull;
    }
  }
}

// Floods from the type-1 tets on the vertex's own internal triangles.
void Completion::find_primary_sheet() {
  primary_.assign(spokes_.size(), 0);
  stack_.clear();
  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    const Spoke& spoke = spokes_[k];
    if (slab_.kind(spoke.tet) != TetKind::t1_internal) continue;
    const std::uint8_t upper = slab_.upper_corners(spoke.tet);
    const bool triangle_above = std::popcount(upper) == 3;
    if (has_corner(upper, spoke.corner) != triangle_above) continue;  // p is the apex
    primary_[k] = 1;
    stack_.push_back(static_cast<std::uint32_t>(k));
  }
  while (!stack_.empty()) {
    const Spoke& spoke = spokes_[stack_.back()];
    stack_.pop_back();
    for (int i = 0; i < 4; ++i) {
      if (i == spoke.corner) continue;
      const std::int32_t k = spoke.next[static_cast<std::size_t>(i)];
      if (k == kHull || primary_[static_cast<std::size_t>(k)] != 0) continue;
      if (!spoke_kept(static_cast<std::size_t>(k))) continue;
      primary_[static_cast<std::size_t>(k)] = 1;
      stack_.push_back(static_cast<std::uint32_t>(k));
    }
  }
}

bool Completion::fill_rings(VertexId p) {
  ++epoch_;
  to_keep_.clear();
  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    if (primary_[k] == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const VertexId q = slab_.mesh().vertex(spokes_[k].tet, i);
      if (i == spokes_[k].corner || seen_[q] == epoch_) continue;
      seen_[q] = epoch_;
      const bool cyclic = slab_.ring(spokes_[k].tet, p, q, ring_);
      const std::size_t n = ring_.size();
      const auto attached = [&](std::size_t at) { return in_primary(ring_[at]); };

      if (!cyclic) {
        std::size_t first = 0;
        while (!attached(first)) ++first;
        std::size_t last = n - 1;
        while (!attached(last)) --last;
        bool whole = true;
        for (std::size_t at = first; at <= last; ++at) {
          if (attached(at)) continue;
          whole = false;
          to_keep_.push_back(ring_[at]);
        }
        if (whole) continue;
        if (slab_.is_upper(p) != slab_.is_upper(q)) {
          count(rules_, Rule::run_at_cross_edge);
        } else {
          count(rules_, slab_.edge_kind(p, q) == EdgeKind::contour ? Rule::run_at_contour_edge
                                                                   : Rule::run_at_external_edge);
        }
        continue;
      }

      // The ring starts at an attached tet: no gap wraps around unless it ends at n.
      struct Gap {
        std::size_t first, last;
        TetId smallest;
      };
      std::vector<Gap> gaps;
      for (std::size_t at = 0; at < n; ++at) {
        if (attached(at)) continue;
        if (at == 0 || attached(at - 1)) gaps.push_back({at, at, ring_[at]});
        gaps.back().last = at;
        gaps.back().smallest = std::min(gaps.back().smallest, ring_[at]);
      }
      if (gaps.size() < 2) continue;
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
  }
  const ClassId c = classes_.of(p);
  for (const TetId t : to_keep_) keep(t, c);
  return !to_keep_.empty();
}

// Fills the complements of the primary sheet in the star that touch no hull facet.
bool Completion::fill_holes(VertexId p) {
  std::vector<std::uint8_t> visited = primary_;
  to_keep_.clear();
  for (std::size_t start = 0; start < spokes_.size(); ++start) {
    if (visited[start] != 0) continue;
    std::vector<TetId> hole;
    bool open = false;
    visited[start] = 1;
    stack_.assign(1, static_cast<std::uint32_t>(start));
    while (!stack_.empty()) {
      const Spoke& spoke = spokes_[stack_.back()];
      stack_.pop_back();
      hole.push_back(spoke.tet);
      for (int i = 0; i < 4; ++i) {
        if (i == spoke.corner) continue;
        const std::int32_t k = spoke.next[static_cast<std::size_t>(i)];
        if (k == kHull) {
          open = true;
        } else if (visited[static_cast<std::size_t>(k)] == 0) {
          visited[static_cast<std::size_t>(k)] = 1;
          stack_.push_back(static_cast<std::uint32_t>(k));
        }
      }
    }
    if (open) continue;
    count(rules_, Rule::hole_in_link);
    to_keep_.insert(to_keep_.end(), hole.begin(), hole.end());
  }
  const ClassId c = classes_.of(p);
  for (const TetId t : to_keep_) keep(t, c);
  return !to_keep_.empty();
}

}  // namespace tetloft
