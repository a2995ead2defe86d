#include "delaunay2/sight.hpp"

#include <algorithm>
#include <tuple>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

using Ends = std::array<SiteId, 2>;

/// Does a b pass through u?
bool passes_through(const Point2& a, const Point2& u, const Point2& b) {
  const bool up = canonical_less(a, b);
  return orient2d(a, u, b) == Sign::zero && canonical_less(up ? a : b, u) &&
         canonical_less(u, up ? b : a);
}

/// The half-edge opposite a in the triangle that a b enters at a, or that begins at the vertex
/// it passes through along the first edge.
HalfEdgeId first_crossed(const Incremental2& plane, SiteId a, SiteId b) {
  const Point2& from = plane.point(a);
  const Point2& to = plane.point(b);
  const HalfEdgeId first = plane.out(a);
  HalfEdgeId h = first;
  do {
    const SiteId u = plane.destination(h);
    const SiteId w = plane.apex(h);
    // On the convex hull there may be no triangle to the left of it.
    if (u != Incremental2::kGhost && passes_through(from, plane.point(u), to)) {
      return Incremental2::next(h);
    }
    if (u != Incremental2::kGhost && w != Incremental2::kGhost &&
        orient2d(from, plane.point(u), to) != Sign::negative &&
        orient2d(from, plane.point(w), to) == Sign::negative) {
      return Incremental2::next(h);
    }
    h = plane.rotate(h);
  } while (h != first);
  TETLOFT_CHECK(false);
  return {};
}

/// The edges that a b crosses, from the right of it to its left; a vertex on it comes as an
/// edge of equal ends, the last.
std::vector<Ends> crossed_edges(const Incremental2& plane, SiteId a, SiteId b) {
  const Point2& from = plane.point(a);
  const Point2& to = plane.point(b);
  std::vector<Ends> crossed;
  HalfEdgeId h = first_crossed(plane, a, b);
  if (orient2d(from, to, plane.point(plane.origin(h))) == Sign::zero) {
    return {{plane.origin(h), plane.origin(h)}};
  }
  for (;;) {
    crossed.push_back({plane.origin(h), plane.destination(h)});
    const HalfEdgeId other = plane.opposite(h);
    const SiteId v = plane.apex(other);
    if (v == b) return crossed;
    TETLOFT_CHECK(v != Incremental2::kGhost);
    const Sign side = orient2d(from, to, plane.point(v));
    if (side == Sign::zero) {
      crossed.push_back({v, v});
      return crossed;
    }
    // `other` runs from left to right of a b.
    h = side == Sign::positive ? Incremental2::next(other) : Incremental2::previous(other);
  }
}

struct Crossing {
  Ends edge;  // the lower vertex first
  std::size_t segment;
  std::array<Sign, 2> side;  // of the ends of the edge
};

/// Of two segments that cross an edge and not each other: does s cross it nearer to its end
/// `edge[end]`? One of the two lies on one side of the line of the other.
bool is_nearer(const Incremental2& plane, std::span<const Ends> segments, const Crossing& s,
               const Crossing& t, std::size_t end) {
  // Is `other` on the side of that end: positive; beyond: negative; on both sides: zero?
  const auto place = [&](const Crossing& line, const Crossing& other) {
    const Point2& a = plane.point(segments[line.segment][0]);
    const Point2& b = plane.point(segments[line.segment][1]);
    const Sign first = orient2d(a, b, plane.point(segments[other.segment][0]));
    const Sign second = orient2d(a, b, plane.point(segments[other.segment][1]));
    if (first == -second) return Sign::zero;
    const Sign side = first == Sign::zero ? second : first;
    return side == line.side[end] ? Sign::positive : Sign::negative;
  };
  const Sign place_of_s = place(t, s);
  return place_of_s != Sign::zero ? place_of_s == Sign::positive : place(s, t) == Sign::negative;
}

}  // namespace

Sight look(const Incremental2& plane, std::span<const std::array<SiteId, 2>> segments) {
  std::vector<Crossing> crossings;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (const Ends& edge : crossed_edges(plane, segments[s][0], segments[s][1])) {
      // It comes with its end to the right first.
      if (edge[0] < edge[1]) {
        crossings.push_back({edge, s, {Sign::negative, Sign::positive}});
      } else {
        crossings.push_back({{edge[1], edge[0]}, s, {Sign::positive, Sign::negative}});
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.edge, a.segment) < std::tie(b.edge, b.segment);
  });
  Sight sight{std::vector<std::vector<SiteId>>(segments.size()), crossings.size()};
  for (std::size_t first = 0; first < crossings.size();) {
    const Ends edge = crossings[first].edge;
    std::size_t last = first;
    while (last < crossings.size() && crossings[last].edge == edge) ++last;
    for (std::size_t end = 0; end < 2; ++end) {
      std::size_t nearest = first;
      for (std::size_t k = first + 1; k < last; ++k) {
        if (is_nearer(plane, segments, crossings[k], crossings[nearest], end)) nearest = k;
      }
      sight.vertices[crossings[nearest].segment].push_back(edge[end]);
    }
    first = last;
  }
  for (std::vector<SiteId>& vertices : sight.vertices) sort_distinct(vertices);
  return sight;
}

std::vector<SiteId> vertices_around(const Incremental2& plane,
                                    const std::array<SiteId, 2>& segment) {
  std::vector<SiteId> vertices;
  for (const Ends& edge : crossed_edges(plane, segment[0], segment[1])) {
    vertices.insert(vertices.end(), edge.begin(), edge.end());
  }
  sort_distinct(vertices);
  return vertices;
}

}  // namespace tetloft::internal::delaunay2_detail
