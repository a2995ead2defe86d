// Many points, their Delaunay triangulation, and a walk through its tets to where a point lies.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <tetloft/delaunay3.hpp>
#include <tetloft/predicates.hpp>

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  std::vector<tetloft::Point3> points(n);
  std::uint64_t state = 1;
  const auto next = [&state] {  // of [0, 1), by a multiplicative generator
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53;
  };
  for (tetloft::Point3& point : points) point = {next(), next(), next()};

  const auto delaunay = tetloft::delaunay3(points);
  if (!delaunay) {
    std::fprintf(stderr, "%s\n", to_string(delaunay.error()).c_str());
    return 1;
  }
  const tetloft::TetMesh& mesh = delaunay->mesh;

  // From tet to tet across a face that has the goal on its other side. In a Delaunay triangulation
  // such a walk ends.
  const tetloft::Point3 goal{0.5, 0.5, 0.5};
  const auto beyond = [&](tetloft::HalfFaceId face) {  // normals of faces point outwards
    const auto [a, b, c] = mesh.face_vertices(face);
    return tetloft::orient3d(points[a.index()], points[b.index()], points[c.index()], goal) ==
           tetloft::Sign::positive;
  };
  std::size_t steps = 0;
  tetloft::TetId at(0);
  for (bool moved = true; moved; ++steps) {
    moved = false;
    for (int i = 0; i < 4 && !moved; ++i) {
      const tetloft::HalfFaceId face = tetloft::TetMesh::half_face(at, i);
      if (mesh.opposite(face).valid() && beyond(face)) {
        at = tetloft::TetMesh::tet_of(mesh.opposite(face));
        moved = true;
      }
    }
  }
  std::printf("%zu tets; %zu steps to tet %u\n", mesh.tet_count(), steps - 1, at.value());

  std::size_t neighbours = 0;
  for (const tetloft::VertexId v : mesh.vertices(at)) neighbours += mesh.star(v).size();
  std::printf("%zu tets in the stars of its vertices\n", neighbours);
  return 0;
}
