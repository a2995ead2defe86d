#include "delaunay2/canonical.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/sort_few.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// A real triangle. The second vertex tells it apart from all others with the same lowest one.
struct Named {
  PlaneVertexId second;
  std::uint32_t corner;  // as Met has it
};

void sort_by_second(std::span<Named> same_lowest) {
  sort_few(same_lowest, [](const Named& a, const Named& b) { return a.second < b.second; });
}

/// A real triangle as it is met: its lowest vertex and the next by name, and where the lowest is.
struct Met {
  PlaneVertexId lowest;
  PlaneVertexId second;
  std::uint32_t corner;  // 4 t + i for corner i of triangle t
};

constexpr std::array<std::uint32_t, 5> kCorner{0, 1, 2, 0, 1};

Met met(const Incremental2& plane, TriangleId t, const IdVector<SiteId, PlaneVertexId>& name_of) {
  const std::array<SiteId, 3>& v = plane.vertices(t);
  const std::array<PlaneVertexId, 3> name{name_of[v[0]], name_of[v[1]], name_of[v[2]]};
  // Any corner as often as the others: without branches, which would be foretold wrongly.
  const std::uint32_t last = name[2] < std::min(name[0], name[1]) ? 1U : 0U;
  const std::uint32_t lowest = 2 * last + ((name[1] < name[0] ? 1U : 0U) & (1 - last));
  return {name[lowest], name[kCorner[lowest + 1]], 4 * t.value() + lowest};
}

}  // namespace

// Triangles are visited in the order of `plane`, where neighbours are near in memory: what is
// scattered is only written.
Triangulation2 canonical_triangulation(const Incremental2& plane,
                                       const IdVector<SiteId, PlaneVertexId>& name_of,
                                       std::vector<Point2> points) {
  const std::size_t count = plane.triangle_count();

  // Counting sort by lowest vertex.
  std::vector<Met> real;
  real.reserve(count);
  std::vector<std::uint32_t> end(points.size());  // of the triangles of each lowest vertex
  for (std::uint32_t t = 0; t < count; ++t) {
    if (plane.is_ghost(TriangleId(t))) continue;
    real.push_back(met(plane, TriangleId(t), name_of));
    ++end[real.back().lowest.index()];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t begin = sum;
    sum += e;
    e = begin;
  }
  std::vector<Named> sorted(real.size());
  for (const Met& m : real) sorted[end[m.lowest.index()]++] = {m.second, m.corner};

  std::vector<TriangleId> number(count);  // ghost triangles keep an invalid one
  std::uint32_t begin = 0;
  for (const std::uint32_t e : end) {
    sort_by_second(std::span(sorted).subspan(begin, e - begin));
    for (; begin < e; ++begin) number[sorted[begin].corner / 4] = TriangleId(begin);
  }

  Triangulation2 result;
  result.points = IdVector<PlaneVertexId, Point2>(std::move(points));
  result.triangles.resize(real.size());
  result.neighbours.resize(real.size());
  for (const Met& m : real) {
    const TriangleId t(m.corner / 4);
    const std::array<SiteId, 3>& v = plane.vertices(t);
    const TriangleId n = number[t.index()];
    const std::uint32_t lowest = m.corner & 3U;
    const std::uint32_t third = kCorner[lowest + 2];
    result.triangles[n] = {m.lowest, m.second, name_of[v[third]]};
    std::array<TriangleId, 3>& neighbours = result.neighbours[n];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId across = plane.opposite(Incremental2::half_edge(t, kCorner[lowest + k]));
      neighbours[k] = number[Incremental2::triangle(across).index()];
    }
  }
  return result;
}

}  // namespace tetloft::internal::delaunay2_detail
