#include "delaunay2/incremental.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/guard.hpp"
#include "core/provide_room.hpp"

namespace tetloft::internal::delaunay2_detail {

Incremental2::Incremental2(const Point2& a, const Point2& b, const Point2& c, std::size_t expected,
                           const predicates::PlaneFilter& filter)
    : filter_(filter), last_(0) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  point_.reserve(expected + 1);
  out_.reserve(expected + 1);
  triangles_.reserve(2 * expected);
  point_ = {Point2{nan, nan}, a, b, c};
  const SiteId v[] = {SiteId(1), SiteId(2), SiteId(3)};
  // Vertex i of triangle 0 has ghost triangle i + 1 across.
  triangles_.resize(4);
  triangles_[0].apex = {v[0], v[1], v[2]};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t following = (i + 1) % 3;
    const std::uint32_t preceding = (i + 2) % 3;
    triangles_[0].opposite[i] = half_edge(TriangleId(i + 1), 0);
    triangles_[i + 1] = {{kGhost, v[preceding], v[following]},
                         {half_edge(TriangleId(0), i), half_edge(TriangleId(preceding + 1), 2),
                          half_edge(TriangleId(following + 1), 1)}};
  }
  out_ = {half_edge(TriangleId(1), 2), half_edge(TriangleId(0), 2), half_edge(TriangleId(0), 0),
          half_edge(TriangleId(0), 1)};
  for (const Point2& p : {a, b, c}) filter_.admit(p);
}

SiteId Incremental2::insert(const Point2& p, TriangleId hint) {
  filter_.admit(p);
  const TriangleId at = locate(filter_, p, hint);
  if (const SiteId same = vertex_at(p, at); same.valid()) return same;
  const HalfEdgeId wall = wall_at(p, at);
  LabelId divided;
  std::array<SiteId, 2> ends;
  if (wall.valid()) {
    divided = label(wall);
    ends = {origin(wall), destination(wall)};
  }
  collect_conflict(filter_, p, at, wall, conflict_, stack_);
  if (!label_.empty() && !walls_) note_touched();
  provide_memory();
  const SiteId v = take_site(p);
  star_cavity(v);
  if (divided.valid()) {
    for (const SiteId end : ends) set_label(find_edge(v, end), divided);
  }
  return v;
}

/// For one vertex: what follows cannot fail.
void Incremental2::provide_memory() {
  TETLOFT_CHECK(point_.size() < kMostVertices);
  provide_room(point_, 1);
  provide_room(out_, 1);
  provide_room(triangles_, 2);
  provide_room(conflict_.zone, 2);
  if (!label_.empty()) provide_room(label_, 8);
}

SiteId Incremental2::take_site(const Point2& p) {
  if (free_.empty()) {
    point_.push_back(p);
    out_.emplace_back();
    return SiteId(point_.size() - 1);
  }
  const SiteId v = free_.back();
  free_.pop_back();
  point_[v.index()] = p;
  return v;
}

inline bool Incremental2::is_right_of(const Filter& filter, const Point2& p, SiteId from,
                                      SiteId to) const {
  const int s = filter.orient2d(point(from), point(to), p);
  if (s != 0) [[likely]]
    return s < 0;
  return decide_right_of(filter, p, from, to);
}

/// Where the filter does not answer. No point is to the right of an edge at the ghost: walks end
/// in ghost triangles.
bool Incremental2::decide_right_of(const Filter& filter, const Point2& p, SiteId from,
                                   SiteId to) const {
  if (filter.is_exact() || from == kGhost || to == kGhost) return false;
  return orient2d(point(from), point(to), p) == Sign::negative;
}

/// A triangle that contains p, its boundary included, or a ghost triangle whose hull edge
/// has p strictly outside. Either is in conflict with p, unless p is one of its vertices.
TriangleId Incremental2::locate(const Filter& filter, const Point2& p, TriangleId hint) const {
  HalfEdgeId entry = half_edge(hint, 0);
  // The ghost triangle across a ghost triangle's hull edge is a real one.
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (vertices(hint)[i] == kGhost) entry = opposite(half_edge(hint, i));
  }
  if (is_right_of(filter, p, origin(entry), destination(entry))) entry = opposite(entry);
  if (walls_ && !label_.empty()) return walk_among_walls(filter, p, entry);
  for (;;) {
    // p is not to the right of the entry.
    const Triangle& t = at(entry);
    const HalfEdgeId second = next(entry);
    const HalfEdgeId third = previous(entry);
    const SiteId from = t.apex[second.value() & 3U];
    const SiteId to = t.apex[third.value() & 3U];
    const SiteId apex = t.apex[entry.value() & 3U];
    if (is_right_of(filter, p, to, apex)) {
      entry = t.opposite[second.value() & 3U];
    } else if (is_right_of(filter, p, apex, from)) {
      entry = t.opposite[third.value() & 3U];
    } else {
      return triangle(entry);
    }
  }
}

/// With walls any triangulation may come up, and in some a walk that always tries the same edge
/// first goes in circles. One that draws the edge ends with probability one (Devillers, Pion and
/// Teillaud 2002).
TriangleId Incremental2::walk_among_walls(const Filter& filter, const Point2& p,
                                          HalfEdgeId entry) const {
  for (std::uint32_t state = 1;;) {
    state = state * 1664525U + 1013904223U;
    std::array<HalfEdgeId, 2> ways{next(entry), previous(entry)};
    if (state >> 31 != 0) std::swap(ways[0], ways[1]);
    const auto leads_on = [&](HalfEdgeId h) {
      return is_right_of(filter, p, origin(h), destination(h));
    };
    const auto way = std::find_if(ways.begin(), ways.end(), leads_on);
    if (way == ways.end()) return triangle(entry);
    entry = opposite(*way);
  }
}

SiteId Incremental2::vertex_at(const Point2& p, TriangleId t) const {
  for (const SiteId v : vertices(t)) {
    if (point(v) == p) return v;  // the ghost's NaN equals nothing
  }
  return {};
}

inline bool Incremental2::in_conflict(const Filter& filter, TriangleId t, const Point2& p) const {
  const std::array<SiteId, 3>& v = vertices(t);
  const int s = filter.incircle(point(v[0]), point(v[1]), point(v[2]), p);
  if (s != 0) [[likely]]
    return s > 0;
  return decide_conflict(filter, t, p);
}

/// Where the filter does not answer.
bool Incremental2::decide_conflict(const Filter& filter, TriangleId t, const Point2& p) const {
  const std::array<SiteId, 3>& v = vertices(t);
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (v[i] != kGhost) continue;
    // The circle of a ghost triangle is the half-plane outside its hull edge, closed by the
    // edge without its ends: there it agrees with the circle of the triangle inside.
    const Point2& a = point(v[(i + 1) % 3]);
    const Point2& b = point(v[(i + 2) % 3]);
    const int certain = filter.orient2d(a, b, p);
    const Sign side =
        certain != 0 || filter.is_exact() ? static_cast<Sign>(certain) : orient2d(a, b, p);
    if (side != Sign::zero) return side == Sign::positive;
    return canonical_less(a, b) ? canonical_less(a, p) && canonical_less(p, b)
                                : canonical_less(b, p) && canonical_less(p, a);
  }
  const Point2 &a = point(v[0]), &b = point(v[1]), &c = point(v[2]);
  return (filter.is_exact() ? predicates::perturbed_incircle_of_cocircular(a, b, c, p)
                            : incircle_perturbed(a, b, c, p)) == Sign::positive;
}

/// Depth first from `first`, counter-clockwise: replacing an edge by the other two of the
/// triangle behind it keeps the boundary in order. Walls end the zone, but for `open`, which has p
/// inside: p sees both its sides.
void Incremental2::collect_conflict(const Filter& filter, const Point2& p, TriangleId first,
                                    HalfEdgeId open, Conflict& conflict,
                                    std::vector<HalfEdgeId>& stack) const {
  const HalfEdgeId open_behind = open.valid() ? opposite(open) : open;
  conflict.zone.assign(1, first);
  conflict.horizon.clear();
  stack.assign({half_edge(first, 2), half_edge(first, 1), half_edge(first, 0)});
  while (!stack.empty()) {
    const HalfEdgeId h = stack.back();
    stack.pop_back();
    const HalfEdgeId outer = opposite(h);
    const LabelId met = label(h);
    const bool closed = walls_ && met.valid() && h != open && h != open_behind;
    if (!closed && in_conflict(filter, triangle(outer), p)) {
      conflict.zone.push_back(triangle(outer));
      TETLOFT_CHECK(conflict.zone.size() < triangle_count());
      stack.push_back(previous(outer));
      stack.push_back(next(outer));
    } else {
      conflict.horizon.push_back({origin(h), destination(h), outer, met});
    }
  }
  TETLOFT_CHECK(conflict.horizon.size() == conflict.zone.size() + 2);
}

Incremental2::Conflict Incremental2::conflict(const Point2& p, TriangleId t) const {
  Filter filter = filter_;
  filter.admit(p);
  Conflict result;
  std::vector<HalfEdgeId> stack;
  collect_conflict(filter, p, t, wall_at(p, t), result, stack);
  return result;
}

void Incremental2::note_touched() {
  for (const TriangleId t : conflict_.zone) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (const LabelId met = label(half_edge(t, i)); met.valid()) touched_.push_back(met);
    }
  }
}

void Incremental2::star_cavity(SiteId v) {
  std::vector<TriangleId>& zone = conflict_.zone;
  const std::size_t first = triangles_.size();
  zone.emplace_back(first);
  zone.emplace_back(first + 1);
  triangles_.resize(first + 2);
  if (!label_.empty()) label_.resize(4 * triangles_.size());
  TriangleId preceding = zone.back();
  for (std::size_t i = 0; i < zone.size(); ++i) {
    const HorizonEdge& edge = conflict_.horizon[i];
    const TriangleId t = zone[i];
    const TriangleId following = zone[i + 1 < zone.size() ? i + 1 : 0];
    triangles_[t.index()] = {{v, edge.from, edge.to},
                             {edge.outer, half_edge(following, 2), half_edge(preceding, 1)}};
    set_opposite(edge.outer, half_edge(t, 0));
    out_[edge.from.index()] = half_edge(t, 0);
    preceding = t;
    if (label_.empty()) continue;
    label_[half_edge(t, 0).index()] = edge.label;
    label_[half_edge(t, 1).index()] = LabelId();
    label_[half_edge(t, 2).index()] = LabelId();
  }
  last_ = preceding;
  out_[v.index()] = half_edge(preceding, 2);
}

HalfEdgeId Incremental2::find_edge(SiteId a, SiteId b) const {
  const HalfEdgeId first_a = out_[a.index()];
  const HalfEdgeId first_b = out_[b.index()];
  HalfEdgeId at_a = first_a;
  HalfEdgeId at_b = first_b;
  do {
    if (destination(at_a) == b) return at_a;
    if (destination(at_b) == a) return opposite(at_b);
    at_a = rotate(at_a);
    at_b = rotate(at_b);
  } while (at_a != first_a && at_b != first_b);
  return {};
}

void Incremental2::set_label(HalfEdgeId h, LabelId label) {
  if (label_.empty()) label_.resize(4 * triangles_.size());
  label_[h.index()] = label;
  label_[opposite(h).index()] = label;
}

std::vector<LabelId> Incremental2::take_touched() {
  std::vector<LabelId> touched;
  touched.swap(touched_);
  return touched;
}

}  // namespace tetloft::internal::delaunay2_detail
