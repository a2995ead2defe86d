// 3D Delaunay: every tet's perturbed sphere is empty, the tets fill the hull, the order of points
// plays no part, and on two planes both engines give the same. The predicates are the library's:
// by definition they would be a thousand times slower, and have a target of their own.
#include <algorithm>
#include <vector>

#include <tetloft/delaunay.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

void check_triangulation(const Delaunay3& d, const std::vector<Point3>& points) {
  const TetMesh& mesh = d.mesh;
  require(mesh.validate().empty(), "the mesh is not valid");
  std::vector<bool> used(points.size());
  for (std::size_t k = 0; k < mesh.tet_slots(); ++k) {
    const TetVertices& v = mesh.vertices(TetId(k));
    std::array<Point3, 4> p{};
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = points[v[i].index()];
      used[v[i].index()] = true;
    }
    require(orient3d(p[0], p[1], p[2], p[3]) == Sign::positive, "a tet is not positive");
    for (const Point3& q : points) {
      if (std::find(p.begin(), p.end(), q) != p.end()) continue;
      require(insphere_perturbed(p[0], p[1], p[2], p[3], q) == Sign::negative,
              "a sphere is not empty");
    }
  }
  // Tets with empty spheres do not overlap; without a point beyond their boundary they fill the
  // hull.
  for (const HalfFaceId h : mesh.boundary()) {
    const TriangleVertices f = mesh.face_vertices(h);
    for (const Point3& q : points) {
      require(orient3d(points[f[0].index()], points[f[1].index()], points[f[2].index()], q) !=
                  Sign::positive,
              "a point lies beyond the hull");
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool first = d.representative[VertexId(v)] == VertexId(v);
    require(used[v] == (d.dimension == 3 && first), "a point is not used, or a duplicate is");
  }
}

void check_order(const Delaunay3& d, const std::vector<Point3>& points) {
  const std::vector<Point3> turned(points.rbegin(), points.rend());
  const auto again = delaunay3(turned);
  require(again.ok(), "the order of points decides whether they are taken");
  require(again->mesh.tet_slots() == d.mesh.tet_slots(), "the order of points plays in");
  for (std::size_t k = 0; k < d.mesh.tet_slots(); ++k) {
    for (int i = 0; i < 4; ++i) {
      require(points[d.mesh.vertex(TetId(k), i).index()] ==
                  turned[again->mesh.vertex(TetId(k), i).index()],
              "the order of points plays in");
    }
  }
}

void check_engines(const Delaunay3& d, const std::vector<Point3>& points) {
  if (d.engine != DelaunayEngine::slab) return;
  const auto other = delaunay3(points, {.engine = DelaunayEngine::incremental});
  require(other.ok() && other->mesh.tet_slots() == d.mesh.tet_slots(), "engines differ");
  for (std::size_t k = 0; k < d.mesh.tet_slots(); ++k) {
    require(other->mesh.vertices(TetId(k)) == d.mesh.vertices(TetId(k)), "engines differ");
    for (int i = 0; i < 4; ++i) {
      require(other->mesh.neighbour(TetId(k), i) == d.mesh.neighbour(TetId(k), i),
              "engines differ in neighbours");
    }
  }
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  const bool two_planes = bytes.below(2) == 1;
  Coordinates coordinates(bytes);
  std::vector<Point3> points;
  for (std::size_t n = 4 + bytes.below(14); n > 0; --n) {
    Point3 p{coordinates.next(), 0, 0};
    p.y = coordinates.next();
    p.z = two_planes ? static_cast<double>(bytes.below(2)) : coordinates.next();
    points.push_back(p);
  }
  const auto d = delaunay3(points);
  if (!d) {
    require_clean(d.error());
    require(false, "finite points are refused");
  }
  check_triangulation(*d, points);
  check_order(*d, points);
  check_engines(*d, points);
  return 0;
}
