// Connecting the parts of a class: merge and connect (see completion.hpp).
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "completion/completion.hpp"

namespace tetloft::internal {

bool Completion::Merge::better_than(const Merge& other) const {
  if (attached != other.attached) return attached;
  return std::tie(length, vertex, sheet) < std::tie(other.length, other.vertex, other.sheet);
}

void Completion::note_change(SlabVertexId v) {
  if (!note_changes_ || changed_[v] != 0) return;
  changed_[v] = 1;
  changes_.push_back(v);
}

void Completion::attach(TetId t, int corner) {
  if (complex_.is_attached(t, corner)) return;
  complex_.attached[t] = static_cast<std::uint8_t>(complex_.attached[t] | (1U << corner));
  if (note_changes_) unite_attached(t, corner);
}

// The region of an attached corner with those of other corners attached.
void Completion::unite_attached(TetId t, int corner) {
  const SlabVertexId p = slab_.vertex(t, corner);
  const ClassId c = classes_.of(p);
  const SlabRegionId region = classes_.region(p);
  for (int i = 0; i < 4; ++i) {
    const SlabVertexId u = slab_.vertex(t, i);
    if (classes_.of(u) != c) continue;
    note_change(u);
    if (!complex_.is_attached(t, i) || classes_.region(u) == region) continue;
    parts_.unite(classes_.region(u).index(), region.index());
  }
}

bool Completion::unite_parts() {
  IdVector<ClassId, std::size_t> parts;
  std::size_t divided = 0;  // classes of several parts
  for (const ClassId c : IdRange<ClassId>(classes_.class_count())) {
    parts.push_back(classes_.regions(c).size());
    if (active_[c] != 0 && parts[c] > 1) ++divided;
  }
  for (const TetId t : slab_.tets()) {
    if (divided == 0) return true;
    for (int i = 0; i < 4; ++i) {
      if (!complex_.is_attached(t, i)) continue;
      const SlabRegionId a = classes_.region(slab_.vertex(t, i));
      const ClassId c = classes_.of_region(a);
      if (parts[c] == 1) continue;
      for (int j = i + 1; j < 4; ++j) {
        if (!complex_.is_attached(t, j)) continue;
        const SlabRegionId b = classes_.region(slab_.vertex(t, j));
        if (a == b || classes_.of_region(b) != c) continue;
        if (parts_.unite(a.index(), b.index()) && --parts[c] == 1) --divided;
      }
    }
  }
  return divided == 0;
}

std::vector<LeftApart> Completion::connect_classes() {
  if (unite_parts()) return {};
  std::vector<SlabVertexId> vertices;
  for (const SlabVertexId v : slab_.vertices()) vertices.push_back(v);
  std::stable_sort(vertices.begin(), vertices.end(),
                   [&](SlabVertexId u, SlabVertexId v) { return classes_.of(u) < classes_.of(v); });

  std::vector<LeftApart> left;
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
    for (const SlabVertexId v : changes_) changed_[v] = 1;
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
    for (const SlabVertexId v : changes_) changed_[v] = 0;
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
  for (const SlabVertexId v : changes_) {
    changed_[v] = 0;
    push(offered_merge(v));
  }
  changes_.clear();
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), worse);
    const Merge remembered = std::move(heap.back());
    heap.pop_back();
    std::optional<Merge> merge = offered_merge(remembered.vertex);
    if (merge && !remembered.better_than(*merge)) return merge;
    push(std::move(merge));
  }
  return std::nullopt;
}

// The best of the detached sheets at p that lead to another part, with the shortest path to it.
std::optional<Completion::Merge> Completion::offered_merge(SlabVertexId p) {
  std::optional<Merge> best;
  const CornerRange star = slab_.corners(p);
  const bool detached = std::any_of(star.begin(), star.end(), [&](HalfFaceId c) {
    const TetId t = TetMesh::tet_of(c);
    const int corner = TetMesh::face_of(c);
    return complex_.keeps(t, corner) && !complex_.is_attached(t, corner);
  });
  if (!detached) return best;
  gather_star(p);
  find_primary_sheet(p);
  const Ways ways = ways_from_primary();
  std::vector<std::uint8_t> visited = primary_;
  for (std::size_t start = 0; start < spokes_.size(); ++start) {
    if (visited[start] != 0 || !spoke_kept(start)) continue;
    std::optional<Merge> merge = merge_of_sheet(p, start, ways, visited);
    if (merge && (!best || merge->better_than(*best))) best = std::move(merge);
  }
  return best;
}

// Breadth-first over all spokes.
Completion::Ways Completion::ways_from_primary() const {
  Ways ways{std::vector<std::uint32_t>(spokes_.size(), kUnreached),
            std::vector<std::uint32_t>(spokes_.size(), kUnreached)};
  std::vector<std::uint32_t> order;
  for (std::size_t k = 0; k < spokes_.size(); ++k) {
    if (primary_[k] == 0) continue;
    ways.distance[k] = 0;
    order.push_back(static_cast<std::uint32_t>(k));
  }
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::uint32_t k = order[at];
    // A detached sheet is where a path ends, never what it leads through.
    if (ways.distance[k] > 0 && spoke_kept(k)) continue;
    for (int i = 0; i < 4; ++i) {
      if (i == spokes_[k].corner) continue;
      const std::int32_t next = spokes_[k].next[static_cast<std::size_t>(i)];
      if (next == kHull) continue;
      const auto n = static_cast<std::size_t>(next);
      if (ways.distance[n] != kUnreached) continue;
      ways.distance[n] = ways.distance[k] + 1;
      ways.from[n] = k;
      order.push_back(static_cast<std::uint32_t>(n));
    }
  }
  return ways;
}

// Visits the detached sheet of spoke `start`; nothing if it does not lead to another part, or no
// way leads to it.
std::optional<Completion::Merge> Completion::merge_of_sheet(SlabVertexId p, std::size_t start,
                                                            const Ways& ways,
                                                            std::vector<std::uint8_t>& visited) {
  const ClassId c = classes_.of(p);
  const std::size_t home = parts_.find(classes_.region(p).index());
  Merge merge;
  merge.vertex = p;
  merge.sheet = spokes_[start].tet;
  bool leads_away = false;
  std::size_t nearest = start;
  const auto key = [&](std::size_t k) { return std::pair(ways.distance[k], spokes_[k].tet); };
  visited[start] = 1;
  stack_.assign(1, static_cast<std::uint32_t>(start));
  while (!stack_.empty()) {
    const std::size_t k = stack_.back();
    stack_.pop_back();
    const Spoke& spoke = spokes_[k];
    if (key(k) < key(nearest)) nearest = k;
    for (int i = 0; i < 4; ++i) {
      if (i == spoke.corner) continue;
      const SlabVertexId u = slab_.vertex(spoke.tet, i);
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
  if (!leads_away || ways.distance[nearest] == kUnreached) return std::nullopt;
  for (std::size_t k = ways.from[nearest]; primary_[k] == 0; k = ways.from[k]) {
    merge.path.push_back(spokes_[k].tet);
  }
  merge.length = merge.path.size();
  return merge;
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
  for (const SlabVertexId u : connecting.vertices) {
    for (const HalfFaceId corner : slab_.corners(u)) {
      const TetId t = TetMesh::tet_of(corner);
      const std::uint8_t own = own_corners(slab_, classes_, t, connecting.id);
      if ((complex_.kept[t] & own) != 0) continue;
      for (int j = TetMesh::face_of(corner) + 1; j < 4; ++j) {
        if (!has_corner(own, j)) continue;
        const SlabVertexId v = slab_.vertex(t, j);
        if (parts_.same(classes_.region(u).index(), classes_.region(v).index())) continue;
        const Point3 a = slab_.point(u);
        const Point3 b = slab_.point(v);
        Bridge bridge{
            {a.x - b.x, a.y - b.y, a.z - b.z}, 0, t, {classes_.region(u), classes_.region(v)}};
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

}  // namespace tetloft::internal
