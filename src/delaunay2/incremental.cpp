#include "delaunay2/incremental.hpp"

#include <tetloft/predicates.hpp>

#include "core/check.hpp"
#include "predicates/filter.hpp"

namespace tetloft::delaunay2_detail {

namespace {

// The predicates with their filters in line: most calls end there, and walks and zones are little
// else.

Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
  const int s = predicates::orient2d_filter(a, b, c);
  return s != 0 ? static_cast<Sign>(s) : orient2d(a, b, c);
}

Sign circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const int s = predicates::incircle_filter(a, b, c, d);
  return s != 0 ? static_cast<Sign>(s) : incircle_perturbed(a, b, c, d);
}

}  // namespace

Incremental2::Incremental2(const Point2& a, const Point2& b, const Point2& c,
                           std::size_t expected) {
  point_.reserve(expected + 1);
  out_.reserve(expected + 1);
  vertex_.reserve(6 * expected);
  opposite_.reserve(6 * expected);
  point_ = {Point2{}, a, b, c};
  out_.resize(4);
  const VertexId v[] = {VertexId(1), VertexId(2), VertexId(3)};
  for (int t = 0; t < 4; ++t) add_triangle();
  set_triangle(TriangleId(0), v[0], v[1], v[2]);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const TriangleId ghost(i + 1);
    set_triangle(ghost, kGhost, v[(i + 2) % 3], v[(i + 1) % 3]);
    join(half_edge(TriangleId(0), i), half_edge(ghost, 0));
    join(half_edge(ghost, 1), half_edge(TriangleId((i + 2) % 3 + 1), 2));
  }
}

VertexId Incremental2::insert(const Point2& p, VertexId hint) {
  const TriangleId at = locate(p, hint);
  if (const VertexId same = vertex_at(p, at); same.valid()) return same;
  TETLOFT_CHECK(point_.size() < kMostVertices);
  const VertexId v(point_.size());
  point_.push_back(p);
  out_.emplace_back();
  collect_conflict_zone(p, at);
  star_cavity(v);
  return v;
}

bool Incremental2::is_ghost(TriangleId t) const {
  const std::size_t h = 3 * t.index();
  return vertex_[h] == kGhost || vertex_[h + 1] == kGhost || vertex_[h + 2] == kGhost;
}

/// A triangle that contains p, its boundary included, or a ghost triangle whose hull edge
/// has p strictly outside. Either is in conflict with p, unless p is one of its vertices.
TriangleId Incremental2::locate(const Point2& p, VertexId hint) const {
  HalfEdgeId entry = out_[hint.index()];
  // The ghost triangle across a ghost triangle's hull edge is a real one.
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdgeId h = half_edge(triangle(entry), i);
    if (apex(h) == kGhost) {
      entry = opposite(h);
      break;
    }
  }
  const auto is_outside = [&](HalfEdgeId h) {
    return orientation(point(origin(h)), point(destination(h)), p) == Sign::negative;
  };
  HalfEdgeId exit = is_outside(entry) ? entry : HalfEdgeId();
  for (;;) {
    if (!exit.valid() && is_outside(next(entry))) exit = next(entry);
    if (!exit.valid() && is_outside(previous(entry))) exit = previous(entry);
    if (!exit.valid()) return triangle(entry);
    entry = opposite(exit);
    exit = HalfEdgeId();
    if (is_ghost(triangle(entry))) return triangle(entry);
  }
}

VertexId Incremental2::vertex_at(const Point2& p, TriangleId t) const {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const VertexId v = apex(half_edge(t, i));
    if (v != kGhost && point(v) == p) return v;
  }
  return {};
}

bool Incremental2::in_conflict(TriangleId t, const Point2& p) const {
  const VertexId* v = &vertex_[3 * t.index()];
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (v[i] != kGhost) continue;
    // The circle of a ghost triangle is the half-plane outside its hull edge, closed by the
    // edge without its ends: there it agrees with the circle of the triangle inside.
    const Point2& a = point(v[(i + 1) % 3]);
    const Point2& b = point(v[(i + 2) % 3]);
    const Sign side = orientation(a, b, p);
    if (side != Sign::zero) return side == Sign::positive;
    return canonical_less(a, b) ? canonical_less(a, p) && canonical_less(p, b)
                                : canonical_less(b, p) && canonical_less(p, a);
  }
  return circle(point(v[0]), point(v[1]), point(v[2]), p) == Sign::positive;
}

/// Depth first from `first`, counter-clockwise: replacing an edge by the other two of the
/// triangle behind it keeps the boundary in order.
void Incremental2::collect_conflict_zone(const Point2& p, TriangleId first) {
  zone_.assign(1, first);
  horizon_.clear();
  stack_ = {half_edge(first, 2), half_edge(first, 1), half_edge(first, 0)};
  while (!stack_.empty()) {
    const HalfEdgeId h = stack_.back();
    stack_.pop_back();
    const HalfEdgeId outer = opposite(h);
    if (label(h).valid()) touched_.push_back(label(h));
    if (in_conflict(triangle(outer), p)) {
      zone_.push_back(triangle(outer));
      TETLOFT_CHECK(zone_.size() < triangle_count());
      stack_.push_back(previous(outer));
      stack_.push_back(next(outer));
    } else {
      horizon_.push_back({origin(h), destination(h), outer, label(h)});
    }
  }
  TETLOFT_CHECK(horizon_.size() == zone_.size() + 2);
}

void Incremental2::star_cavity(VertexId v) {
  zone_.push_back(add_triangle());
  zone_.push_back(add_triangle());
  for (std::size_t i = 0; i < zone_.size(); ++i) {
    const HorizonEdge& edge = horizon_[i];
    set_triangle(zone_[i], v, edge.from, edge.to);
    join(half_edge(zone_[i], 0), edge.outer);
    const TriangleId following = zone_[i + 1 < zone_.size() ? i + 1 : 0];
    join(half_edge(zone_[i], 1), half_edge(following, 2));
    if (label_.empty()) continue;
    label_[3 * zone_[i].index()] = edge.label;
    label_[3 * zone_[i].index() + 1] = LabelId();
    label_[3 * zone_[i].index() + 2] = LabelId();
  }
}

TriangleId Incremental2::add_triangle() {
  const TriangleId t(triangle_count());
  vertex_.resize(vertex_.size() + 3);
  opposite_.resize(opposite_.size() + 3);
  if (!label_.empty()) label_.resize(label_.size() + 3);
  return t;
}

void Incremental2::set_triangle(TriangleId t, VertexId a, VertexId b, VertexId c) {
  const std::size_t h = 3 * t.index();
  vertex_[h] = a;
  vertex_[h + 1] = b;
  vertex_[h + 2] = c;
  out_[a.index()] = HalfEdgeId(h + 2);
  out_[b.index()] = HalfEdgeId(h);
  out_[c.index()] = HalfEdgeId(h + 1);
}

void Incremental2::join(HalfEdgeId a, HalfEdgeId b) {
  opposite_[a.index()] = b;
  opposite_[b.index()] = a;
}

HalfEdgeId Incremental2::find_edge(VertexId a, VertexId b) const {
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
  if (label_.empty()) label_.resize(vertex_.size());
  label_[h.index()] = label;
  label_[opposite(h).index()] = label;
}

std::vector<LabelId> Incremental2::take_touched() {
  std::vector<LabelId> touched;
  touched.swap(touched_);
  return touched;
}

}  // namespace tetloft::delaunay2_detail
