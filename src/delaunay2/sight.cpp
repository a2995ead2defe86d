#include "delaunay2/sight.hpp"

#include <algorithm>
#include <tuple>

#include <tetloft/predicates.hpp>

#include "core/sort_distinct.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

using Ends = std::array<SiteId, 2>;

/// The edges that a b crosses, from the right of it to its left; a vertex on it comes as an
/// edge of equal ends, the last.
std::vector<Ends> crossed_edges(const Incremental2& plane, SiteId a, SiteId b) {
  std::vector<Ends> crossed;
  const SiteId met = plane.follow(a, b, [&](HalfEdgeId h) {
    crossed.push_back({plane.origin(h), plane.destination(h)});
  });
  if (met != b) crossed.push_back({met, met});
  return crossed;
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
