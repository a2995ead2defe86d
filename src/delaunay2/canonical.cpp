#include "delaunay2/canonical.hpp"

#include <array>
#include <cstdint>

#include "core/sort_few.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// A real triangle. The second vertex tells it apart from all others with the same lowest one.
struct Named {
  PlaneVertexId second;
  TriangleId triangle;
};

void sort_by_second(std::span<Named> same_lowest) {
  sort_few(same_lowest, [](const Named& a, const Named& b) { return a.second < b.second; });
}

/// The vertices of a triangle by name, and the corner of the lowest.
struct Names {
  std::array<PlaneVertexId, 3> name;
  std::uint32_t lowest;

  Names(const std::array<SiteId, 3>& v, const IdVector<SiteId, PlaneVertexId>& name_of)
      : name{name_of[v[0]], name_of[v[1]], name_of[v[2]]},
        lowest(name[0] < name[1] ? (name[0] < name[2] ? 0U : 2U) : (name[1] < name[2] ? 1U : 2U)) {}
};

constexpr std::array<std::uint32_t, 5> kCorner{0, 1, 2, 0, 1};

}  // namespace

// Triangles are visited in the order of `plane`, where neighbours are near in memory: what is
// scattered is only written.
Triangulation2 canonical_triangulation(const Incremental2& plane,
                                       const IdVector<SiteId, PlaneVertexId>& name_of,
                                       std::vector<Point2> points) {
  const std::size_t count = plane.triangle_count();

  // Counting sort by lowest vertex.
  std::vector<std::uint32_t> end(points.size());  // of the triangles of each lowest vertex
  std::size_t real = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (plane.is_ghost(TriangleId(t))) continue;
    const Names names(plane.vertices(TriangleId(t)), name_of);
    ++end[names.name[names.lowest].index()];
    ++real;
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t begin = sum;
    sum += e;
    e = begin;
  }
  std::vector<Named> sorted(real);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (plane.is_ghost(TriangleId(t))) continue;
    const Names names(plane.vertices(TriangleId(t)), name_of);
    sorted[end[names.name[names.lowest].index()]++] = {names.name[kCorner[names.lowest + 1]],
                                                       TriangleId(t)};
  }

  std::vector<TriangleId> number(count);  // ghost triangles keep an invalid one
  std::uint32_t begin = 0;
  for (const std::uint32_t e : end) {
    sort_by_second(std::span(sorted).subspan(begin, e - begin));
    for (; begin < e; ++begin) number[sorted[begin].triangle.index()] = TriangleId(begin);
  }

  Triangulation2 result;
  result.points = IdVector<PlaneVertexId, Point2>(std::move(points));
  result.triangles.resize(real);
  result.neighbours.resize(real);
  for (std::uint32_t t = 0; t < count; ++t) {
    const TriangleId n = number[t];
    if (!n.valid()) continue;
    const Names names(plane.vertices(TriangleId(t)), name_of);
    PlaneTriangleVertices& vertices = result.triangles[n];
    std::array<TriangleId, 3>& neighbours = result.neighbours[n];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t i = kCorner[names.lowest + k];
      const HalfEdgeId across = plane.opposite(Incremental2::half_edge(TriangleId(t), i));
      vertices[k] = names.name[i];
      neighbours[k] = number[Incremental2::triangle(across).index()];
    }
  }
  return result;
}

}  // namespace tetloft::internal::delaunay2_detail
