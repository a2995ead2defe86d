#include "sections/region_sides.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::sections {

namespace {

constexpr std::size_t kNoCycle = static_cast<std::size_t>(-1);

std::size_t twin(std::size_t edge) { return edge ^ 1U; }

// Directions around a node start at −x and turn counter-clockwise.
int sector(const Point2& p, const Point2& to) {
  if (to.y == p.y) return to.x < p.x ? 0 : 2;
  return to.y < p.y ? 1 : 3;
}

IdVector<ContourId, std::uint32_t> each_alone(std::size_t contours) {
  IdVector<ContourId, std::uint32_t> group(contours);
  for (std::size_t c = 0; c < contours; ++c) group[ContourId(c)] = static_cast<std::uint32_t>(c);
  return group;
}

}  // namespace

RegionSides::RegionSides(const Arrangement& arrangement, const Section& section,
                         const std::vector<bool>& in_arrangement, FillRule rule)
    : arrangement_(arrangement),
      rule_(rule),
      contours_(section.contours.size()),
      crossed_tree_({}),
      contour_sides_(section.contours.size()) {
  collect_pieces();
  sort_leaving();
  trace_cycles();
  find_parts();
  collect_crossed(section, in_arrangement);
  IdVector<ContourId, std::uint32_t> group = each_alone(contours_);
  group_overlapping(group);
  FillState state(rule_, group);
  std::vector<bool> in_region(first_of_cycle_.size(), false);
  for_each_cycle(state, [&](std::size_t cycle) { in_region[cycle] = state.in_region(); });
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    pieces_[i].left = in_region[cycle_[2 * i]];
    pieces_[i].right = in_region[cycle_[2 * i + 1]];
  }
  find_contour_sides(section, in_arrangement, group);
}

void RegionSides::collect_pieces() {
  const std::vector<ArrangementPiece>& all = arrangement_.pieces();
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t last = arrangement_.end_of_equal(i);
    pieces_.push_back({all[i].a, all[i].b, i, last});
    i = last;
  }
}

void RegionSides::sort_leaving() {
  leaving_.resize(arrangement_.node_count());
  for (std::size_t e = 0; e < 2 * pieces_.size(); ++e) leaving_[start(e)].push_back(e);
  for (std::size_t k = 0; k < leaving_.size(); ++k) {
    const Point2& p = arrangement_.at(NodeId(k));
    std::vector<std::size_t>& edges = leaving_[NodeId(k)];
    std::sort(edges.begin(), edges.end(), [&](std::size_t e, std::size_t f) {
      if (e == f) return false;
      const Point2& u = arrangement_.at(end(e));
      const Point2& v = arrangement_.at(end(f));
      if (sector(p, u) != sector(p, v)) return sector(p, u) < sector(p, v);
      return orient2d(p, u, v) == Sign::positive;
    });
  }
}

// A face on the left is followed by turning clockwise at every node, from the edge one came by.
void RegionSides::trace_cycles() {
  next_.resize(2 * pieces_.size());
  for (const std::vector<std::size_t>& edges : leaving_) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      next_[twin(edges[k])] = edges[(k + edges.size() - 1) % edges.size()];
    }
  }
  cycle_.assign(next_.size(), kNoCycle);
  for (std::size_t e = 0; e < next_.size(); ++e) {
    if (cycle_[e] != kNoCycle) continue;
    for (std::size_t f = e; cycle_[f] == kNoCycle; f = next_[f]) cycle_[f] = first_of_cycle_.size();
    first_of_cycle_.push_back(e);
  }
}

// The lowest node of a part has the face around the part in direction −x: behind its last edge.
void RegionSides::find_parts() {
  UnionFind nodes(arrangement_.node_count());
  for (const SidedPiece& piece : pieces_) nodes.unite(piece.a.index(), piece.b.index());
  std::map<std::size_t, NodeId> lowest;
  for (const SidedPiece& piece : pieces_) {
    NodeId& low = lowest.try_emplace(nodes.find(piece.a.index()), piece.a).first->second;
    if (canonical_less(arrangement_.at(piece.a), arrangement_.at(low))) low = piece.a;
  }
  std::map<std::size_t, std::uint32_t> number;
  for (const auto& [part, low] : lowest) {
    number[part] = static_cast<std::uint32_t>(start_of_part_.size());
    start_of_part_.push_back(leaving_[low].back());
  }
  part_.resize(arrangement_.node_count());
  for (const SidedPiece& piece : pieces_) {
    part_[piece.a] = part_[piece.b] = number[nodes.find(piece.a.index())];
  }
}

void RegionSides::collect_crossed(const Section& section, const std::vector<bool>& in_arrangement) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    crossed_.push_back(
        {arrangement_.at(pieces_[i].a), arrangement_.at(pieces_[i].b), ContourId(), i});
  }
  for (const ContourId c : section.contours.ids()) {
    if (in_arrangement[c.index()]) continue;
    const std::vector<Point2>& v = section.contours[c].vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      crossed_.push_back({v[k], v[(k + 1) % v.size()], c, 0});
    }
  }
  std::vector<Box2> boxes;
  for (const Crossed& edge : crossed_) boxes.push_back(box_of(edge.a, edge.b));
  crossed_tree_ = BoxTree2(boxes);
}

// What p is inside of, by the edges that a ray from it in direction −x crosses, times `sign`.
template <class Skip>
void RegionSides::add_ray(FillState& state, const Point2& p, int sign, Skip skip) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  crossed_tree_.query({-kInfinity, p.y, p.x, p.y}, [&](std::size_t k) {
    const Crossed& edge = crossed_[k];
    if ((edge.a.y <= p.y) == (edge.b.y <= p.y) || skip(edge)) return;
    const bool upward = edge.a.y < edge.b.y;
    const Sign left = upward ? Sign::negative : Sign::positive;
    if (orient2d(edge.a, edge.b, p) != left) return;
    const int times = upward ? -sign : sign;
    if (edge.contour.valid()) {
      state.add(edge.contour, times);
      return;
    }
    for (std::size_t i = pieces_[edge.piece].first; i < pieces_[edge.piece].last; ++i) {
      const ArrangementPiece& piece = arrangement_.pieces()[i];
      state.add(piece.contour, times * piece.times);
    }
  });
}

// From the left of the edge to its right.
void RegionSides::cross(FillState& state, std::size_t edge) const {
  const SidedPiece& piece = pieces_[edge / 2];
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    const ArrangementPiece& one = arrangement_.pieces()[i];
    state.add(one.contour, edge % 2 == 0 ? -one.times : one.times);
  }
}

// Visits the cycles of a part, the first being that left of `start`, with the state there.
template <class Visit>
void RegionSides::walk_part(FillState& state, std::size_t start, std::vector<bool>& visited,
                            Visit visit) const {
  struct Step {
    std::size_t entered;  // the edge that was crossed, seen from here
    std::size_t at;       // the next edge to look across
    bool done;
  };
  std::vector<Step> path{{start, start, false}};
  visited[cycle_[start]] = true;
  visit(cycle_[start]);
  while (!path.empty()) {
    Step& here = path.back();
    if (here.done) {
      const std::size_t entered = here.entered;
      path.pop_back();
      if (!path.empty()) cross(state, entered);
      continue;
    }
    const std::size_t edge = here.at;
    here.at = next_[edge];
    here.done = here.at == here.entered;
    const std::size_t beyond = twin(edge);
    if (visited[cycle_[beyond]]) continue;
    visited[cycle_[beyond]] = true;
    cross(state, edge);
    path.push_back({beyond, beyond, false});
    visit(cycle_[beyond]);
  }
}

template <class Visit>
void RegionSides::for_each_cycle(FillState& state, Visit visit) const {
  std::vector<bool> visited(first_of_cycle_.size(), false);
  for (const std::size_t edge : start_of_part_) {
    const NodeId low = start(edge);
    const auto own = [&](const Crossed& crossed) {
      return !crossed.contour.valid() && part_[pieces_[crossed.piece].a] == part_[low];
    };
    add_ray(state, arrangement_.at(low), 1, own);
    walk_part(state, edge, visited, visit);
    add_ray(state, arrangement_.at(low), -1, own);
  }
}

// For each contour, how many of its pieces lie on, and inside of, which others.
void RegionSides::group_overlapping(IdVector<ContourId, std::uint32_t>& group) {
  using Pair = std::pair<ContourId, ContourId>;
  std::map<Pair, std::size_t> on;
  std::map<Pair, std::size_t> within;
  std::vector<std::size_t> all(contours_, 0);
  FillState state(rule_, group);
  const std::vector<ArrangementPiece>& pieces = arrangement_.pieces();
  const auto look_at = [&](const SidedPiece& piece) {
    for (std::size_t i = piece.first; i < piece.last; ++i) {
      const ContourId c = pieces[i].contour;
      ++all[c.index()];
      for (std::size_t k = piece.first; k < piece.last; ++k) ++on[{c, pieces[k].contour}];
      for (const ContourId other : state.around()) ++within[{c, other}];
    }
    // On the left an owner may be around, too: that is no inside.
    for (std::size_t i = piece.first; i < piece.last; ++i) {
      for (std::size_t k = piece.first; k < piece.last; ++k) {
        if (state.inside(pieces[k].contour)) --within[{pieces[i].contour, pieces[k].contour}];
      }
    }
  };
  for_each_cycle(state, [&](std::size_t cycle) {
    const std::size_t first = first_of_cycle_[cycle];
    std::size_t edge = first;
    do {
      if (edge % 2 == 0) look_at(pieces_[edge / 2]);
      edge = next_[edge];
    } while (edge != first);
  });
  UnionFind united(contours_);
  for (const auto& [pair, count] : within) {
    const auto shared = on.find(pair);
    const std::size_t free = all[pair.first.index()] - (shared == on.end() ? 0 : shared->second);
    if (count == 0 || count == free) continue;
    united.unite(pair.first.index(), pair.second.index());
    overlapping_.emplace_back(std::min(pair.first, pair.second), std::max(pair.first, pair.second));
  }
  std::sort(overlapping_.begin(), overlapping_.end());
  overlapping_.erase(std::unique(overlapping_.begin(), overlapping_.end()), overlapping_.end());
  for (const ContourId c : group.ids()) {
    group[c] = static_cast<std::uint32_t>(united.find(c.index()));
  }
}

void RegionSides::find_contour_sides(const Section& section,
                                     const std::vector<bool>& in_arrangement,
                                     const IdVector<ContourId, std::uint32_t>& group) {
  FillState state(rule_, group);
  for (const ContourId c : section.contours.ids()) {
    if (in_arrangement[c.index()]) continue;
    const Contour& contour = section.contours[c];
    const Point2 low =
        *std::min_element(contour.vertices.begin(), contour.vertices.end(),
                          [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
    const auto own = [&](const Crossed& crossed) { return crossed.contour == c; };
    const int times = area_sign(contour) == Sign::negative ? -1 : 1;
    add_ray(state, low, 1, own);
    contour_sides_[c].outside = state.in_region();
    state.add(c, times);
    contour_sides_[c].inside = state.in_region();
    state.add(c, -times);
    add_ray(state, low, -1, own);
  }
}

}  // namespace tetloft::internal::sections
