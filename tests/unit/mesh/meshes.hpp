// Small and random tet meshes, and oracles about them by plain set operations.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/tet_mesh.hpp>

#include "core/prng.hpp"

namespace tetloft::mesh_test {

using namespace internal;

using Soup = std::vector<TetVertices>;

inline TetVertices tet(int a, int b, int c, int d) {
  return {VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
}

inline std::string messages(const TetMesh& mesh) {
  std::string text;
  for (const MeshViolation& v : mesh.validate()) {
    text += std::to_string(v.condition) + ": " + v.message + "\n";
  }
  return text;
}

#define EXPECT_VALID(mesh) EXPECT_EQ(::tetloft::mesh_test::messages(mesh), "")
#define ASSERT_VALID(mesh) ASSERT_EQ(::tetloft::mesh_test::messages(mesh), "")

inline TetMesh make(std::size_t vertices, const Soup& soup) {
  Result<TetMesh> mesh = TetMesh::from_tets(vertices, soup);
  EXPECT_TRUE(mesh.ok()) << (mesh.ok() ? "" : mesh.error().message);
  return mesh.ok() ? *mesh : TetMesh();
}

/// A grid of nx × ny × nz cubes, each cut into the six tets that run along its long
/// diagonal, one for each order of the axes (Freudenthal 1942); positive.
struct Grid {
  int nx, ny, nz;
  [[nodiscard]] int vertex(int x, int y, int z) const { return x + (nx + 1) * (y + (ny + 1) * z); }
  [[nodiscard]] std::size_t vertices() const {
    return static_cast<std::size_t>((nx + 1) * (ny + 1) * (nz + 1));
  }
  [[nodiscard]] Soup tets() const {
    Soup soup;
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) append_cube(x, y, z, soup);
      }
    }
    return soup;
  }
  void append_cube(int x, int y, int z, Soup& soup) const {
    std::array<int, 3> axes{0, 1, 2};
    do {
      std::array<int, 3> at{x, y, z};
      std::array<int, 4> v{vertex(x, y, z)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++at[static_cast<std::size_t>(axes[k])];
        v[k + 1] = vertex(at[0], at[1], at[2]);
      }
      const bool even = (axes[0] + 1) % 3 == axes[1];
      soup.push_back(even ? tet(v[0], v[1], v[2], v[3]) : tet(v[0], v[1], v[3], v[2]));
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
};

/// Tets of the grid, each kept with probability `keep`, in random order: full of singular
/// vertices and edges.
inline Soup random_part(const Grid& grid, double keep, Prng& random) {
  Soup part;
  for (const TetVertices& t : grid.tets()) {
    if (random.chance(keep)) part.push_back(t);
  }
  random.shuffle(part);
  return part;
}

}  // namespace tetloft::mesh_test
