#include "delaunay2/canonical.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetloft::delaunay2_detail {

namespace {

/// A triangle of the plane, by its half-edge opposite the vertex that is lowest by name.
/// The second vertex tells it apart from all others with the same lowest one.
struct Named {
  VertexId second;
  HalfEdgeId base;
};

std::array<HalfEdgeId, 3> half_edges_from(HalfEdgeId base) {
  const auto first = base.value() / 3 * 3;
  const auto i = base.value() % 3;
  return {base, HalfEdgeId(first + (i + 1) % 3), HalfEdgeId(first + (i + 2) % 3)};
}

}  // namespace

Triangulation2 canonical_triangulation(const Incremental2& plane, std::span<const VertexId> name_of,
                                       std::vector<Point2> points) {
  const auto name = [&](HalfEdgeId h) { return name_of[plane.apex(h).index()]; };

  // Counting sort by lowest vertex.
  std::vector<HalfEdgeId> bases;
  std::vector<std::uint32_t> bucket(points.size() + 1);
  bases.reserve(plane.triangle_count());
  for (std::uint32_t t = 0; t < plane.triangle_count(); ++t) {
    if (plane.is_ghost(TriangleId(t))) continue;
    HalfEdgeId base(3 * t);
    if (name(HalfEdgeId(3 * t + 1)) < name(base)) base = HalfEdgeId(3 * t + 1);
    if (name(HalfEdgeId(3 * t + 2)) < name(base)) base = HalfEdgeId(3 * t + 2);
    bases.push_back(base);
    ++bucket[name(base).index() + 1];
  }
  for (std::size_t v = 1; v < bucket.size(); ++v) bucket[v] += bucket[v - 1];
  std::vector<Named> sorted(bases.size());
  std::vector<std::uint32_t> place(bucket.begin(), bucket.end() - 1);
  for (const HalfEdgeId base : bases) {
    sorted[place[name(base).index()]++] = {name(half_edges_from(base)[1]), base};
  }
  for (std::size_t v = 0; v + 1 < bucket.size(); ++v) {
    std::sort(sorted.begin() + bucket[v], sorted.begin() + bucket[v + 1],
              [](const Named& a, const Named& b) { return a.second < b.second; });
  }

  // Ghost triangles keep an invalid number.
  std::vector<TriangleId> number(plane.triangle_count());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    number[sorted[i].base.index() / 3] = TriangleId(i);
  }
  Triangulation2 result;
  result.points = IdVector<VertexId, Point2>(std::move(points));
  result.triangles.resize(sorted.size());
  result.neighbours.resize(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto half_edges = half_edges_from(sorted[i].base);
    for (std::size_t k = 0; k < 3; ++k) {
      result.triangles[TriangleId(i)][k] = name(half_edges[k]);
      result.neighbours[TriangleId(i)][k] = number[plane.opposite(half_edges[k]).index() / 3];
    }
  }
  return result;
}

}  // namespace tetloft::delaunay2_detail
