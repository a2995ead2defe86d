// Edges that are walls, in an incremental triangulation.
//
// A segment that is to be an edge crosses a strip of triangles; the vertices of each side form a
// chain. A vertex of a chain is a corner where it turns towards the segment between its neighbours
// there. The vertex farthest from the segment is one (of several that far the first), so as long as
// something is crossed there is a corner y, say between x and z. The ends of its crossed edges r1 …
// rj lie beyond the segment, hence beyond x z as seen from y: on the path x r1 … rj z, all of which
// y sees within less than a half turn, one of them is convex, and flipping y ri cuts it off. After
// j flips x z is an edge, y is in the strip no more, and chains have one vertex less: this ends
// after at most as many flips as there were pairs of both chains' vertices. Then flips of illegal
// edges that are no walls end in the constrained triangulation, unique as the perturbed one is.
// (Lawson 1977; Anglada, "An improved incremental algorithm for constructing restricted Delaunay
// triangulations", 1997; Lee and Lin, "Generalized Delaunay triangulation for planar graphs",
// 1986.)
#include <array>

#include "core/guard.hpp"
#include "delaunay2/incremental.hpp"

namespace tetloft::internal::delaunay2_detail {

/// Which side of the segment from a to b another vertex is on. That b is on it needs no exact
/// arithmetic.
Sign Incremental2::side_of_segment(SiteId a, SiteId b, SiteId v) const {
  return v == b ? Sign::zero : turn(a, b, v);
}

HalfEdgeId Incremental2::first_crossed(SiteId a, SiteId b, SiteId& along) const {
  const bool ahead = canonical_less(point(a), point(b));
  const auto side_of = [&](SiteId v) {
    return v == kGhost ? Sign::zero : side_of_segment(a, b, v);
  };
  const HalfEdgeId first = out(a);
  HalfEdgeId h = first;
  Sign side = side_of(destination(h));
  do {
    const SiteId p = destination(h);
    if (side == Sign::zero && p != kGhost && canonical_less(point(a), point(p)) == ahead) {
      along = p;
      return {};
    }
    const HalfEdgeId leaves = next(h);
    h = rotate(h);
    const bool was_right = side == Sign::negative;
    side = side_of(destination(h));
    if (was_right && side == Sign::positive) return leaves;
  } while (h != first);
  TETLOFT_CHECK(false);
  return {};
}

Incremental2::Passage Incremental2::passage(SiteId a, SiteId b) const {
  Passage result;
  result.reached = follow(a, b, [&](HalfEdgeId h) {
    if (!result.wall.valid() && is_wall(h)) result.wall = h;
  });
  return result;
}

/// The first corner of a chain, for what is crossed on the way from a to its neighbour to be b.
Incremental2::Corner Incremental2::corner_between(SiteId a, SiteId b) const {
  SiteId along;
  HalfEdgeId h = first_crossed(a, b, along);
  TETLOFT_CHECK(!along.valid());
  SiteId right = origin(h), before_right = a;
  SiteId left = destination(h), before_left = a;
  for (;;) {
    const HalfEdgeId across = opposite(h);
    const SiteId w = apex(across);
    const Sign side = side_of_segment(a, b, w);
    if (side != Sign::negative) {
      if (turn(before_left, left, w) == Sign::negative) return {left, before_left, w};
      before_left = left;
      left = w;
    }
    if (side != Sign::positive) {
      if (turn(before_right, right, w) == Sign::positive) return {right, w, before_right};
      before_right = right;
      right = w;
    }
    TETLOFT_CHECK(w != b);
    h = side == Sign::positive ? next(across) : previous(across);
  }
}

/// Counter-clockwise around the corner, from one neighbour on its chain to the other.
void Incremental2::cut_off(const Corner& corner) {
  HalfEdgeId h = find_edge(corner.vertex, corner.from);
  for (;;) {
    const HalfEdgeId crossed = rotate(h);
    const SiteId r = destination(crossed);
    if (r == corner.to) {
      TETLOFT_CHECK(destination(h) == corner.from);
      return;
    }
    if (turn(destination(h), r, destination(rotate(crossed))) == Sign::positive) {
      const TriangleId t = triangle(crossed);
      flip_with_sides(crossed);
      push(half_edge(t, 0));
      h = out(corner.vertex);  // to the one before r
      if (destination(h) != corner.from) h = rotate_back(h);
    } else {
      h = crossed;
    }
  }
}

void Incremental2::make_wall(SiteId a, SiteId b, LabelId label) {
  if (label_.empty()) label_.resize(4 * triangles_.size());
  stack_.clear();
  stack_is_short_ = false;
  HalfEdgeId edge = find_edge(a, b);
  while (!edge.valid()) {
    cut_off(corner_between(a, b));
    edge = find_edge(a, b);
  }
  set_label(edge, label);
  flip_illegal_edges();
}

void Incremental2::remove_wall(SiteId a, SiteId b) {
  const HalfEdgeId edge = find_edge(a, b);
  TETLOFT_CHECK(edge.valid());
  stack_.clear();
  stack_is_short_ = false;
  set_label(edge, LabelId());
  push(edge);
  flip_illegal_edges();
}

HalfEdgeId Incremental2::wall_at(const Point2& p, TriangleId t) const {
  if (!walls_ || label_.empty() || is_ghost(t) || vertex_at(p, t).valid()) return {};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdgeId h = half_edge(t, i);
    if (label(h).valid() && orient2d(point(origin(h)), point(destination(h)), p) == Sign::zero) {
      return h;
    }
  }
  return {};
}

}  // namespace tetloft::internal::delaunay2_detail
