#include "delaunay2/corners.hpp"

#include <algorithm>
#include <cstdint>

#include <tetloft/predicates.hpp>

#include "delaunay2/diametral.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// One end of a segment at some vertex: 2 × segment + end.
using SegmentEnd = std::uint32_t;

/// Sorts directions around `centre` counter-clockwise, from straight up on.
struct AroundLess {
  const Point2& centre;
  bool operator()(const Point2& a, const Point2& b) const {
    const bool a_right = canonical_less(centre, a);
    const bool b_right = canonical_less(centre, b);
    if (a_right != b_right) return a_right;
    return orient2d(centre, a, b) == Sign::positive;
  }
};

}  // namespace

std::vector<std::array<bool, 2>> acute_ends(std::span<const Point2> points,
                                            std::span<const Segment> segments) {
  // Segment ends by vertex: those at v are ends[first[v]] … ends[first[v + 1] − 1].
  std::vector<std::uint32_t> first(points.size() + 2);
  for (const Segment& segment : segments) {
    for (const PlaneVertexId v : segment) ++first[v.index() + 2];
  }
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<SegmentEnd> ends(2 * segments.size());
  for (SegmentEnd e = 0; e < ends.size(); ++e)
    ends[first[segments[e / 2][e % 2].index() + 1]++] = e;

  const auto far = [&](SegmentEnd e) -> const Point2& {
    return points[segments[e / 2][1 - e % 2].index()];
  };
  std::vector<std::array<bool, 2>> acute(segments.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::span here(ends.data() + first[v], first[v + 1] - first[v]);
    if (here.size() < 2) continue;
    if (here.size() == 2 && angle_sign(far(here[0]), points[v], far(here[1])) != Sign::positive) {
      continue;
    }
    const AroundLess less{points[v]};
    std::sort(here.begin(), here.end(),
              [&](SegmentEnd a, SegmentEnd b) { return less(far(a), far(b)); });
    // The smallest angle of a direction is with one of its neighbours around the vertex.
    for (std::size_t i = 0; i < here.size(); ++i) {
      const SegmentEnd a = here[i];
      const SegmentEnd b = here[(i + 1) % here.size()];
      if (angle_sign(far(a), points[v], far(b)) != Sign::positive) continue;
      acute[a / 2][a % 2] = true;
      acute[b / 2][b % 2] = true;
    }
  }
  return acute;
}

}  // namespace tetloft::internal::delaunay2_detail
