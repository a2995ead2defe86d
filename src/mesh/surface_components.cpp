// Components of a triangulated surface and their Euler characteristics.
#include <tetloft/tet_mesh.hpp>

#include <algorithm>

#include "core/buckets.hpp"
#include "core/entry.hpp"
#include "core/union_find.hpp"

namespace tetloft {

using namespace internal;

namespace {

/// Side k of a triangle joins its vertices k and k + 1 (mod 3).
struct Side {
  std::uint32_t upper = 0;  // the higher of the two vertices
  std::uint32_t triangle = 0;
};

// Unites triangles across shared edges; owned[i]: how many edges are counted at triangle i, the
// first that has them.
std::vector<std::uint8_t> connect_by_edges(std::span<const TriangleVertices> triangles,
                                           std::size_t vertex_end, UnionFind& connected) {
  // The lower and the higher end of side `s`.
  const auto side_ends = [&](std::size_t s) -> std::pair<std::uint32_t, std::uint32_t> {
    const TriangleVertices& t = triangles[s / 3];
    const std::uint32_t a = t[s % 3].value();
    const std::uint32_t b = t[(s + 1) % 3].value();
    return {std::min(a, b), std::max(a, b)};
  };
  std::vector<std::uint8_t> owned(triangles.size(), 0);
  const Buckets sides(vertex_end, 3 * triangles.size(),
                      [&](std::size_t s) { return side_ends(s).first; });
  std::vector<Side> bucket;
  for (std::size_t v = 0; v < vertex_end; ++v) {
    bucket.clear();
    for (const std::uint32_t s : sides[v]) bucket.push_back({side_ends(s).second, s / 3});
    std::sort(bucket.begin(), bucket.end(), [](const Side& a, const Side& b) {
      return a.upper != b.upper ? a.upper < b.upper : a.triangle < b.triangle;
    });
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      if (i > 0 && bucket[i].upper == bucket[i - 1].upper) {
        connected.unite(bucket[i].triangle, bucket[i - 1].triangle);
      } else {
        ++owned[bucket[i].triangle];
      }
    }
  }
  return owned;
}

// A vertex counts once in each component it belongs to.
void count_vertices(std::span<const TriangleVertices> triangles, std::size_t vertex_end,
                    SurfaceComponents& result) {
  // seen[c] is the last vertex + 1 counted for component c.
  std::vector<std::size_t> seen(result.topology.size(), 0);
  const Buckets corners(vertex_end, 3 * triangles.size(),
                        [&](std::size_t c) { return triangles[c / 3][c % 3].index(); });
  for (std::size_t v = 0; v < vertex_end; ++v) {
    for (const std::uint32_t c : corners[v]) {
      const std::uint32_t component = result.component[c / 3];
      if (seen[component] == v + 1) continue;
      seen[component] = v + 1;
      ++result.topology[component].vertices;
    }
  }
}

}  // namespace

SurfaceComponents surface_components(std::span<const TriangleVertices> triangles) {
  const std::size_t n = triangles.size();
  require_fit(n < (std::size_t{1} << 32) / 3, "2^32 / 3 triangles or more");
  std::size_t vertex_end = 0;
  for (const TriangleVertices& t : triangles) {
    require_named(t[0].valid() && t[1].valid() && t[2].valid(),
                  "a triangle without three vertices");
    for (const VertexId v : t) vertex_end = std::max(vertex_end, v.index() + 1);
  }
  UnionFind connected(n);
  const std::vector<std::uint8_t> owned = connect_by_edges(triangles, vertex_end, connected);

  // The representative of a component is its first triangle.
  SurfaceComponents result;
  result.component.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t root = connected.find(i);
    if (root == i) {
      result.component[i] = static_cast<std::uint32_t>(result.topology.size());
      result.topology.emplace_back();
    } else {
      result.component[i] = result.component[root];
    }
    SurfaceTopology& topology = result.topology[result.component[i]];
    ++topology.triangles;
    topology.edges += owned[i];
  }
  count_vertices(triangles, vertex_end, result);
  return result;
}

}  // namespace tetloft
