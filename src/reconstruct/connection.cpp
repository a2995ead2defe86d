// Connecting the parts of a class: merge and connect (see completion.hpp).
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "reconstruct/completion.hpp"

namespace tetloft {

bool Completion::Merge::better_than(const Merge& other) const {
  if (attached != other.attached) return attached;
  return std::tie(length, vertex, sheet) < std::tie(other.length, other.vertex, other.sheet);
}

void Completion::note_change(VertexId v) {
  if (!note_changes_ || changed_[v] != 0) return;
  changed_[v] = 1;
  changes_.push_back(v);
}

void Completion::attach(TetId t, int corner) {
  if (complex_.is_attached(t, corner)) return;
  complex_.attached[t] = static_cast<std::uint8_t>(complex_.attached[t] | (1U << corner));
  const VertexId p = slab_.mesh().vertex(t, corner);
  for (int i = 0; i < 4; ++i) {
    const VertexId u = slab_.mesh().vertex(t, i);
    if (classes_.of(u) != classes_.of(p)) continue;
    note_change(u);
    if (complex_.is_attached(t, i)) {
      parts_.unite(classes_.region(u).index(), classes_.region(p).index());
    }
  }
}

std::vector<Unconnectable> Completion::connect_classes() {
  std::vector<VertexId> vertices;
  for (std::size_t v = 0; v < slab_.vertex_count(); ++v) vertices.emplace_back(v);
  std::stable_sort(vertices.begin(), vertices.end(),
                   [&](VertexId u, VertexId v) { return classes_.of(u) < classes_.of(v); });

  std::vector<Unconnectable> left;
  note_changes_ = true;
  std::size_t first = 0;
  for (std::size_t k = 0; k < classes_.class_count(); ++k) {
    const ClassId c(k);
    std::size_t last = first;
    while (last < vertices.size() && classes_.of(vertices[last]) == c) ++last;
    Connecting connecting;
    connecting.id = c;
    connecting.vertices = std::span(vertices).subspan(first, last - first);
    first = last;
    if (active_[c] == 0 || classes_.is_lone(c)) continue;
    changes_.assign(connecting.vertices.begin(), connecting.vertices.end());
    for (const VertexId v : changes_) changed_[v] = 1;
    const auto& regions = classes_.regions(c);
    // Regions before `next` are in one part with the first.
    for (std::size_t next = 1; next < regions.size();) {
      if (parts_.same(regions[next].index(), regions.front().index())) {
        ++next;
      } else if (!connect_once(connecting)) {
        left.push_back({c, regions});
        break;
      }
    }
    for (const VertexId v : changes_) changed_[v] = 0;
  }
  note_changes_ = false;
  return left;
}

bool Completion::connect_once(Connecting& connecting) {
  if (const std::optional<Merge> merge = best_merge(connecting)) {
    count(rules_, Rule::merge_sheets);
    for (const TetId t : merge->path) keep(t, connecting.id);
  } else if (const std::optional<TetId> t = connecting_tet(connecting)) {
    count(rules_, Rule::connect_parts);
    keep(*t, connecting.id);
  } else {
    return false;
  }
  settle_queue();
  return true;
}

// Where the complex stays as it is, uniting parts makes offers only worse or void. So the best
// of those remembered that still holds is the best of all.
std::optional<Completion::Merge> Completion::best_merge(Connecting& connecting) {
  std::vector<Merge>& heap = connecting.offers;
  const auto worse = [](const Merge& a, const Merge& b) { return b.better_than(a); };
  const auto push = [&](std::optional<Merge>&& merge) {
    if (!merge) return;
    merge->path.clear();
    heap.push_back(std::move(*merge));
    std::push_heap(heap.begin(), heap.end(), worse);
  };
  for (const VertexId v : changes_) {
    changed_[v] = 0;
    push(offered_merge(v, connecting.id));
  }
  changes_.clear();
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), worse);
    const Merge remembered = std::move(heap.back());
    heap.pop_back();
    std::optional<Merge> merge = offered_merge(remembered.vertex, connecting.id);
    if (merge && !remembered.better_than(*merge)) return merge;
    push(std::move(merge));
  }
  return std::nullopt;
}

// The best of the detached sheets at p that lead to another part, with the shortest path to it.
std::optional<Completion::Merge> Completion::offered_merge(VertexId p, ClassId c) {
  std::optional<Merge> best;
  bool detached = false;
  for (const Slab::StarEntry& entry : slab_.star(p)) {
    detached = detached || (complex_.keeps(entry.tet, entry.corner) &&
                            !complex_.is_attached(entry.tet, entry.corner));
  }
  if (!detached) return best;
  gather_star(p);
  find_primary_sheet();
  const std::size_t home = parts_.find(classes_.region(p).index());

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
        if (classes_.of(u) == c && parts_.find(classes_.region(u).index()) != home) {
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
  return best;
}

// The lowest tet not kept yet at the shortest own–own edge of D between two parts.
std::optional<TetId> Completion::connecting_tet(Connecting& connecting) const {
  if (!connecting.knows_bridges) {
    connecting.bridges = bridges_of(connecting);
    connecting.knows_bridges = true;
  }
  for (; connecting.next_bridge < connecting.bridges.size(); ++connecting.next_bridge) {
    const Bridge& bridge = connecting.bridges[connecting.next_bridge];
    const std::uint8_t own = own_corners(slab_, classes_, bridge.tet, connecting.id);
    if ((complex_.kept[bridge.tet] & own) != 0) continue;
    if (parts_.same(bridge.between[0].index(), bridge.between[1].index())) continue;
    return bridge.tet;
  }
  return std::nullopt;
}

std::vector<Completion::Bridge> Completion::bridges_of(const Connecting& connecting) const {
  std::vector<Bridge> bridges;
  double largest = 0;
  for (const VertexId u : connecting.vertices) {
    for (const Slab::StarEntry& entry : slab_.star(u)) {
      const std::uint8_t own = own_corners(slab_, classes_, entry.tet, connecting.id);
      if ((complex_.kept[entry.tet] & own) != 0) continue;
      for (int j = entry.corner + 1; j < 4; ++j) {
        if (!has_corner(own, j)) continue;
        const VertexId v = slab_.mesh().vertex(entry.tet, j);
        if (parts_.same(classes_.region(u).index(), classes_.region(v).index())) continue;
        const Point3 a = slab_.point(u);
        const Point3 b = slab_.point(v);
        Bridge bridge{{a.x - b.x, a.y - b.y, a.z - b.z},
                      0,
                      entry.tet,
                      {classes_.region(u), classes_.region(v)}};
        for (const double d : bridge.extent) largest = std::max(largest, std::abs(d));
        bridges.push_back(bridge);
      }
    }
  }
  // Squares neither over- nor underflow where it matters, whatever the scale.
  const int unit = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  for (Bridge& bridge : bridges) {
    for (const double d : bridge.extent) {
      const double scaled = std::scalbn(d, -unit);
      bridge.length += scaled * scaled;
    }
  }
  std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) {
    return std::tie(a.length, a.tet) < std::tie(b.length, b.tet);
  });
  return bridges;
}

}  // namespace tetloft
