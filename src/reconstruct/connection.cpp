// Connecting the parts of a class: merge and connect (see completion.hpp).
#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include "reconstruct/completion.hpp"

namespace tetloft {

bool Completion::Merge::better_than(const Merge& other) const {
  if (attached != other.attached) return attached;
  return std::tie(length, vertex, sheet) < std::tie(other.length, other.vertex, other.sheet);
}

// Regions united through attached corners: all tets attached at a vertex hang together, and
// so do the attached corners of one tet for one class.
UnionFind Completion::parts() const {
  UnionFind sets(classes_.region_count());
  for (std::size_t k = 0; k < slab_.mesh().tet_slots(); ++k) {
    const TetId t(k);
    const unsigned attached = complex_.attached[t];
    if (std::popcount(attached) < 2) continue;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        if (!has_corner(attached, i) || !has_corner(attached, j)) continue;
        const VertexId u = slab_.mesh().vertex(t, i);
        const VertexId v = slab_.mesh().vertex(t, j);
        if (classes_.of(u) == classes_.of(v)) {
          sets.unite(classes_.region(u).index(), classes_.region(v).index());
        }
      }
    }
  }
  return sets;
}

bool Completion::connect_class(ClassId c, const UnionFind& parts) {
  if (const std::optional<Merge> merge = best_merge(c, parts)) {
    count(rules_, Rule::merge_sheets);
    for (const TetId t : merge->path) keep(t, c);
    return true;
  }
  if (const std::optional<TetId> t = connecting_tet(c, parts)) {
    count(rules_, Rule::connect_parts);
    keep(*t, c);
    return true;
  }
  return false;
}

std::optional<Completion::Merge> Completion::best_merge(ClassId c, const UnionFind& parts) {
  std::optional<Merge> best;
  for (std::size_t v = 0; v < slab_.vertex_count(); ++v) {
    if (classes_.of(VertexId(v)) == c) offer_merges(VertexId(v), c, parts, best);
  }
  return best;
}

// For each detached sheet at p that leads to another part: the shortest path to it.
void Completion::offer_merges(VertexId p, ClassId c, const UnionFind& parts,
                              std::optional<Merge>& best) {
  bool detached = false;
  for (const Slab::StarEntry& entry : slab_.star(p)) {
    detached = detached || (complex_.keeps(entry.tet, entry.corner) &&
                            !complex_.is_attached(entry.tet, entry.corner));
  }
  if (!detached) return;
  gather_star(p);
  find_primary_sheet();
  const std::size_t home = parts.find(classes_.region(p).index());

  // Breadth-first from the primary sheet over all spokes: distance and predecessor.
  constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> distance(spokes_.size(), kUnreached);
  std::vector<std::uint32_t> from(spokes_.size(), kUnreached);
  std::vector<std::uint32_t> order;
  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    if (primary_[k] == 0) continue;
    distance[k] = 0;
    order.push_back(static_cast<std::uint32_t>(k));
  }
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::uint32_t k = order[at];
    // A detached sheet is where a path ends, never what it leads through.
    if (distance[k] > 0 && spoke_kept(k)) continue;
    for (int i = 0; i < 4; ++i) {
      if (i == spokes_[k].corner) continue;
      const std::int32_t next = spokes_[k].next[static_cast<std::size_t>(i)];
      if (next == kHull) continue;
      const auto n = static_cast<std::size_t>(next);
      if (distance[n] != kUnreached) continue;
      distance[n] = distance[k] + 1;
      from[n] = k;
      order.push_back(static_cast<std::uint32_t>(n));
    }
  }

  std::vector<std::uint8_t> visited = primary_;
  for (std::size_t start = 0; start < spokes_.size(); ++start) {
    if (visited[start] != 0 || !spoke_kept(start)) continue;
    Merge merge;
    merge.vertex = p;
    merge.sheet = spokes_[start].tet;
    bool leads_away = false;
    std::size_t nearest = start;
    visited[start] = 1;
    stack_.assign(1, static_cast<std::uint32_t>(start));
    while (!stack_.empty()) {
      const std::size_t k = stack_.back();
      stack_.pop_back();
      const Spoke& spoke = spokes_[k];
      if (std::pair(distance[k], spoke.tet) < std::pair(distance[nearest], spokes_[nearest].tet)) {
        nearest = k;
      }
      for (int i = 0; i < 4; ++i) {
        if (i == spoke.corner) continue;
        const VertexId u = slab_.mesh().vertex(spoke.tet, i);
        if (classes_.of(u) == c && parts.find(classes_.region(u).index()) != home) {
          leads_away = true;
          merge.attached = merge.attached || complex_.is_attached(spoke.tet, i);
        }
        const std::int32_t next = spoke.next[static_cast<std::size_t>(i)];
        if (next == kHull) continue;
        const auto n = static_cast<std::size_t>(next);
        if (visited[n] != 0 || !spoke_kept(n)) continue;
        visited[n] = 1;
        stack_.push_back(static_cast<std::uint32_t>(n));
      }
    }
    if (!leads_away || distance[nearest] == kUnreached) continue;
    for (std::size_t k = from[nearest]; primary_[k] == 0; k = from[k]) {
      merge.path.push_back(spokes_[k].tet);
    }
    merge.length = merge.path.size();
    if (!best || merge.better_than(*best)) best = merge;
  }
}

// The lowest tet not kept yet at the shortest own–own edge of D between two parts.
std::optional<TetId> Completion::connecting_tet(ClassId c, const UnionFind& parts) const {
  std::optional<TetId> best;
  double best_length = 0;
  for (std::size_t k = 0; k < slab_.mesh().tet_slots(); ++k) {
    const TetId t(k);
    const std::uint8_t own = own_corners(slab_, classes_, t, c);
    if (std::popcount(own) < 2 || (complex_.kept[t] & own) != 0) continue;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        if (!has_corner(own, i) || !has_corner(own, j)) continue;
        const VertexId u = slab_.mesh().vertex(t, i);
        const VertexId v = slab_.mesh().vertex(t, j);
        if (parts.same(classes_.region(u).index(), classes_.region(v).index())) continue;
        const Point3 a = slab_.point(u);
        const Point3 b = slab_.point(v);
        const double length =
            (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
        if (!best || length < best_length) {
          best = t;
          best_length = length;
        }
      }
    }
  }
  return best;
}

}  // namespace tetloft
