#include "comparison/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/union_find.hpp"

namespace tetloft::bench {

using namespace internal;

namespace {

// From boundary half-face `start`, at its edge uv, through the tets around that edge to the next
// boundary half-face.
HalfFaceId across(const TetMesh& mesh, HalfFaceId start, VertexId u, VertexId v) {
  HalfFaceId at = start;
  for (;;) {
    const TetId t = TetMesh::tet_of(at);
    // The other face of t at edge uv is opposite the vertex that the first one has beside u, v.
    int other = 0;
    for (const VertexId w : mesh.face_vertices(at)) {
      if (w != u && w != v) other = mesh.index_in(t, w);
    }
    const HalfFaceId turned = TetMesh::half_face(t, other);
    const HalfFaceId next = mesh.opposite(turned);
    if (!next.valid()) return turned;
    at = next;
  }
}

std::size_t position(const TriangleVertices& triangle, VertexId v) {
  return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), v) -
                                  triangle.begin());
}

double six_volume(const Point3& o, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 p{a.x - o.x, a.y - o.y, a.z - o.z};
  const Point3 q{b.x - o.x, b.y - o.y, b.z - o.z};
  const Point3 r{c.x - o.x, c.y - o.y, c.z - o.z};
  return (p.y * q.z - p.z * q.y) * r.x + (p.z * q.x - p.x * q.z) * r.y +
         (p.x * q.y - p.y * q.x) * r.z;
}

// By surface component, the volume that it encloses.
std::vector<double> volumes(const TriangleMesh& mesh, const std::vector<std::uint32_t>& component,
                            std::size_t count) {
  std::vector<double> volume(count, 0);
  if (mesh.triangles.empty()) return volume;
  const Point3 o = mesh.points[mesh.triangles[0][0]];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    volume[component[i]] += six_volume(o, mesh.points[a], mesh.points[b], mesh.points[c]) / 6;
  }
  return volume;
}

}  // namespace

TriangleMesh boundary_of(const TetMesh& mesh, const IdVector<VertexId, Point3>& points) {
  const std::vector<HalfFaceId> faces = mesh.boundary();
  std::vector<TriangleVertices> triangles;
  // index[h]: the triangle of boundary half-face h.
  std::vector<std::size_t> index(4 * mesh.tet_slots(), SIZE_MAX);
  for (const HalfFaceId h : faces) {
    index[h.index()] = triangles.size();
    triangles.push_back(mesh.face_vertices(h));
  }
  // Corners 3 i + k that are one vertex of the surface.
  UnionFind corners(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId u = triangles[i][k], v = triangles[i][(k + 1) % 3];
      const std::size_t j = index[across(mesh, faces[i], u, v).index()];
      corners.unite(3 * i + k, 3 * j + position(triangles[j], u));
      corners.unite(3 * i + (k + 1) % 3, 3 * j + position(triangles[j], v));
    }
  }
  TriangleMesh result;
  std::vector<VertexId> vertex(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (corners.find(c) == c) vertex[c] = result.points.push_back(points[triangles[c / 3][c % 3]]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    result.triangles.push_back({vertex[corners.find(3 * i)], vertex[corners.find(3 * i + 1)],
                                vertex[corners.find(3 * i + 2)]});
  }
  return result;
}

double enclosed_volume(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> one(mesh.triangles.size(), 0);
  return volumes(mesh, one, 1)[0];
}

SurfaceFaults faults_of(const TriangleMesh& mesh) {
  SurfaceFaults faults;
  // Directed edges, each with its corner 3 i + k at the edge's start.
  std::vector<std::pair<std::array<VertexId, 2>, std::size_t>> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = mesh.triangles[i];
      edges.push_back({{t[k], t[(k + 1) % 3]}, 3 * i + k});
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto range = [&](VertexId a, VertexId b) {
    const std::array<VertexId, 2> key{a, b};
    return std::equal_range(
        edges.begin(), edges.end(), std::pair{key, std::size_t{0}},
        [](const auto& left, const auto& right) { return left.first < right.first; });
  };
  // Corners at a vertex whose triangles share an edge: one class for each piece of its link.
  UnionFind corners(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges[e].first;
    const auto same = range(a, b);
    const auto reverse = range(b, a);
    const bool good = same.second - same.first == 1 && reverse.second - reverse.first == 1;
    const bool first = &*same.first == &edges[e] && (a < b || reverse.first == reverse.second);
    if (!good && first) ++faults.edges;
    if (!good) continue;
    const std::size_t here = edges[e].second, there = reverse.first->second;
    corners.unite(here, there / 3 * 3 + (there + 1) % 3);
  }
  // All edges good: links are cycles, one for each class of corners.
  std::vector<std::size_t> classes(mesh.points.size(), 0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (corners.find(c) == c) ++classes[mesh.triangles[c / 3][c % 3].index()];
  }
  for (const std::size_t n : classes) faults.vertices += n > 1 ? 1U : 0U;
  return faults;
}

Topology topology_of(const TriangleMesh& mesh) {
  const SurfaceComponents surfaces = surface_components(mesh.triangles);
  Topology result;
  for (const SurfaceTopology& surface : surfaces.topology) result.genus += surface.genus();
  for (const double volume : volumes(mesh, surfaces.component, surfaces.topology.size())) {
    ++(volume > 0 ? result.components : result.cavities);
  }
  return result;
}

}  // namespace tetloft::bench
