// A vertex taken out of an incremental triangulation, by flips.
//
// The star of a vertex is a polygon that it sees all of. Its corners are cut off one by one, each
// by a flip, until the vertex has three neighbours left and goes; on the hull, until its neighbours
// run along the new hull, and the ghost takes its place. Any triangulation of the polygon becomes
// the unique one when edges are flipped as long as the circle of one side holds the apex of the
// other: each flip lowers the lifted surface, in the perturbed lifting too. (Lawson, "Software for
// C1 surface interpolation", 1977; Devillers, "On deletion in Delaunay triangulations", SoCG 1999.)
#include <array>
#include <new>
#include <utility>

#include "core/guard.hpp"
#include "core/provide_room.hpp"
#include "delaunay2/incremental.hpp"

namespace tetloft::internal::delaunay2_detail {

void Incremental2::remove(SiteId v) {
  provide_room(free_, 1);
  // From here on nothing fails: a stack that memory ends for is made up for.
  stack_.clear();
  stack_is_short_ = false;
  const HalfEdgeId first = to_first_of_hull(v);
  std::array<TriangleId, 2> gone = first.valid() ? take_from_hull(first) : take_from_inside(v);
  // Where all edges are looked at, theirs are to be none that could be flipped.
  for (const TriangleId t : gone) triangles_[t.index()].apex.fill(kGhost);
  flip_illegal_edges();
  if (gone[0] < gone[1]) std::swap(gone[0], gone[1]);
  for (const TriangleId t : gone) delete_triangle(t);
  last_ = triangle(out_[kGhost.index()]);
  free_.push_back(v);
}

Sign Incremental2::turn(SiteId a, SiteId b, SiteId c) const {
  const int s = filter_.orient2d(point(a), point(b), point(c));
  if (s != 0 || filter_.is_exact()) return static_cast<Sign>(s);
  return orient2d(point(a), point(b), point(c));
}

/// The edge from v to the neighbour that comes after the ghost, counter-clockwise, or invalid.
HalfEdgeId Incremental2::to_first_of_hull(SiteId v) const {
  HalfEdgeId h = out_[v.index()];
  do {
    if (destination(h) == kGhost) return rotate(h);
    h = rotate(h);
  } while (h != out_[v.index()]);
  return {};
}

/// The other diagonal of the quadrilateral: a b c to the left of h = a b and b a d to its right
/// become a d c and b c d, in the same places.
void Incremental2::flip(HalfEdgeId h) {
  const HalfEdgeId g = opposite(h);
  const TriangleId t = triangle(h);
  const TriangleId s = triangle(g);
  const SiteId a = origin(h), b = destination(h), c = apex(h), d = apex(g);
  struct Side {
    HalfEdgeId outer;
    HalfEdgeId inner;  // to be
    LabelId label;
  };
  const auto side = [&](HalfEdgeId was, HalfEdgeId to_be) {
    return Side{opposite(was), to_be, label(was)};
  };
  const std::array<Side, 4> sides{
      side(previous(h), half_edge(t, 1)), side(next(g), half_edge(t, 2)),
      side(previous(g), half_edge(s, 1)), side(next(h), half_edge(s, 2))};
  triangles_[t.index()].apex = {a, d, c};
  triangles_[s.index()].apex = {b, c, d};
  set_opposite(half_edge(t, 0), half_edge(s, 0));
  set_opposite(half_edge(s, 0), half_edge(t, 0));
  for (const Side& k : sides) {
    set_opposite(k.inner, k.outer);
    set_opposite(k.outer, k.inner);
    if (!label_.empty()) label_[k.inner.index()] = k.label;
  }
  if (!label_.empty()) {
    label_[half_edge(t, 0).index()] = LabelId();
    label_[half_edge(s, 0).index()] = LabelId();
  }
  out_[a.index()] = half_edge(t, 2);
  out_[d.index()] = half_edge(t, 0);
  out_[c.index()] = half_edge(t, 1);
  out_[b.index()] = half_edge(s, 2);
}

/// Cuts off the corner that h leads to: the new edge is known by the triangle that its origin no
/// longer has.
void Incremental2::flip_for_good(HalfEdgeId h) {
  const TriangleId beyond = triangle(opposite(h));
  flip(h);
  push(half_edge(beyond, 0));
}

/// Returns two triangles that are no longer used. A corner is cut off where the polygon is convex
/// and v stays strictly inside: of five or more there is such a one, as of a triangulation of the
/// polygon at least two triangles are corners, and v is in both only if these are all. Of four v
/// may come to lie on the diagonal: then the flat triangle goes with it.
std::array<TriangleId, 2> Incremental2::take_from_inside(SiteId v) {
  std::size_t degree = 0;
  HalfEdgeId h = out_[v.index()];
  do {
    ++degree;
    h = rotate(h);
  } while (h != out_[v.index()]);
  for (std::size_t kept = 0; degree > 3;) {
    const SiteId a = destination(rotate_back(h));
    const SiteId b = destination(h);
    const SiteId c = destination(rotate(h));
    const auto is_inside = [&] {
      const Sign s = turn(a, c, v);
      return s == Sign::positive || (s == Sign::zero && degree == 4);
    };
    if (turn(a, b, c) == Sign::positive && is_inside()) {
      flip_for_good(h);
      h = out_[v.index()];  // to a, whose corner is another one now
      --degree;
      kept = 0;
    } else {
      h = rotate(h);
      TETLOFT_CHECK(++kept <= degree);
    }
  }
  const std::array<HalfEdgeId, 3> spokes{h, rotate(h), rotate(rotate(h))};
  std::array<SiteId, 3> corner;
  std::array<HalfEdgeId, 3> outer;
  std::array<LabelId, 3> labels;
  for (std::size_t i = 0; i < 3; ++i) {
    corner[i] = destination(spokes[i]);
    outer[i] = opposite(next(spokes[i]));
    labels[i] = label(next(spokes[i]));
  }
  const TriangleId t = triangle(spokes[0]);
  triangles_[t.index()].apex = corner;
  for (std::uint32_t i = 0; i < 3; ++i) {
    // From corner i to the next, opposite the one before.
    const HalfEdgeId inner = half_edge(t, (i + 2) % 3);
    set_opposite(inner, outer[i]);
    set_opposite(outer[i], inner);
    if (!label_.empty()) label_[inner.index()] = labels[i];
    out_[corner[i].index()] = inner;
  }
  return {triangle(spokes[1]), triangle(spokes[2])};
}

/// The same of a vertex of the hull. Its star is cut as long as there are corners: v is in none of
/// these, or on the diagonal of the last one.
std::array<TriangleId, 2> Incremental2::take_from_hull(HalfEdgeId first) {
  const SiteId v = origin(first);
  // Flips move half-edges about; the ghost triangle before the first edge stays.
  const TriangleId before = triangle(opposite(first));
  const HalfEdgeId before_outer = opposite(next(next(opposite(first))));
  HalfEdgeId h = rotate(first);
  while (destination(rotate(h)) != kGhost) {
    const SiteId a = destination(rotate_back(h));
    if (a != kGhost && turn(a, destination(h), destination(rotate(h))) == Sign::positive) {
      flip_for_good(h);
      h = out_[v.index()];
    } else {
      h = rotate(h);
    }
  }
  // h leads to the last neighbour; the triangle to its left is a ghost.
  const TriangleId after = triangle(h);
  const HalfEdgeId after_outer = opposite(next(h));
  HalfEdgeId last = opposite(h);  // towards v
  HalfEdgeId spoke = h;
  do {
    spoke = rotate_back(spoke);
    const TriangleId t = triangle(spoke);
    for (SiteId& u : triangles_[t.index()].apex) u = u == v ? kGhost : u;
    out_[destination(spoke).index()] = next(spoke);
  } while (triangle(opposite(spoke)) != before);
  set_opposite(last, after_outer);
  set_opposite(after_outer, last);
  out_[origin(last).index()] = last;
  set_opposite(spoke, before_outer);
  set_opposite(before_outer, spoke);
  out_[kGhost.index()] = spoke;
  return {before, after};
}

/// Edges that flips move about are to be looked at again.
void Incremental2::flip_with_sides(HalfEdgeId h) {
  const std::array<TriangleId, 2> both{triangle(h), triangle(opposite(h))};
  flip(h);
  for (const TriangleId t : both) {
    push(half_edge(t, 1));
    push(half_edge(t, 2));
  }
}

void Incremental2::push(HalfEdgeId h) {
  try {
    stack_.push_back(h);
  } catch (const std::bad_alloc&) {
    stack_is_short_ = true;
  }
}

bool Incremental2::is_illegal(HalfEdgeId h) const {
  const TriangleId t = triangle(h);
  const SiteId other = apex(opposite(h));
  if (other == kGhost || is_ghost(t) || is_wall(h)) return false;
  const std::array<SiteId, 3>& v = vertices(t);
  const int s = filter_.incircle(point(v[0]), point(v[1]), point(v[2]), point(other));
  return s != 0 ? s > 0 : decide_conflict(filter_, t, point(other));
}

void Incremental2::flip_illegal_edges() {
  const auto flip_where_illegal = [&](HalfEdgeId h) {
    if (is_illegal(h)) flip_with_sides(h);
  };
  const auto flip_all_of_stack = [&] {
    while (!stack_.empty()) {
      const HalfEdgeId h = stack_.back();
      stack_.pop_back();
      flip_where_illegal(h);
    }
  };
  flip_all_of_stack();
  // Edges that found no place on it: all are looked at until none is illegal, which takes no
  // memory, as a copy's stack may have no place at all.
  while (stack_is_short_) {
    stack_is_short_ = false;
    for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
      for (std::uint32_t i = 0; i < 3; ++i) flip_where_illegal(half_edge(TriangleId(k), i));
      flip_all_of_stack();
    }
  }
}

/// The last triangle takes its place.
void Incremental2::delete_triangle(TriangleId t) {
  const TriangleId last(triangles_.size() - 1);
  if (t != last) {
    triangles_[t.index()] = triangles_[last.index()];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId now = half_edge(t, i);
      set_opposite(opposite(now), now);
      if (!label_.empty()) label_[now.index()] = label_[half_edge(last, i).index()];
      const SiteId from = origin(now);
      if (triangle(out_[from.index()]) == last) out_[from.index()] = now;
    }
  }
  triangles_.pop_back();
  if (!label_.empty()) label_.resize(4 * triangles_.size());
}

}  // namespace tetloft::internal::delaunay2_detail
