#include "support.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <tetloft/predicates.hpp>

namespace tetloft::test {

namespace {

// Local copies of the convention, written down independently of kFaceVertex: face i in
// the order whose right-hand radiusal points out of a positive tet.
constexpr int kOutward[4][3] = {{1, 2, 3}, {2, 0, 3}, {3, 0, 1}, {1, 0, 2}};

std::array<VertexId, 3> outward_face(const TetVertices& t, int i) {
  const auto at = [&](int k) { return t[static_cast<std::size_t>(kOutward[i][k])]; };
  return {at(0), at(1), at(2)};
}

// Rotated to start at the lowest id: equal for equal oriented triangles.
std::array<VertexId, 3> rotated(std::array<VertexId, 3> f) {
  std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return f;
}

std::vector<std::size_t> canonical_ranks(std::span<const Point3> points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return canonical_less(points[a], points[b]);
  });
  std::vector<std::size_t> rank(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  return rank;
}

const Point3& at(std::span<const Point3> points, VertexId v) { return points[v.index()]; }

Sign orientation(std::span<const Point3> points, const TetVertices& t) {
  return orient3d(at(points, t[0]), at(points, t[1]), at(points, t[2]), at(points, t[3]));
}

bool strictly_in_sphere(std::span<const Point3> points, const TetVertices& t, VertexId v) {
  return insphere_perturbed(at(points, t[0]), at(points, t[1]), at(points, t[2]), at(points, t[3]),
                            at(points, v)) == Sign::positive;
}

std::string text(const TetVertices& t) {
  std::string s = "(";
  for (const VertexId v : t) s += std::to_string(v.value()) + " ";
  s.back() = ')';
  return s;
}

}  // namespace

Delaunay3 triangulate(std::span<const Point3> points) {
  Result<Delaunay3> result = delaunay3(points);
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result).value();
}

std::vector<TetVertices> brute_force_tets(std::span<const Point3> points) {
  // By rank, duplicates left out.
  std::vector<VertexId> by_rank;
  {
    std::vector<std::size_t> rank = canonical_ranks(points);
    std::vector<VertexId> all(points.size());
    for (std::size_t i = 0; i < rank.size(); ++i) all[rank[i]] = VertexId(i);
    for (const VertexId v : all) {
      if (by_rank.empty() || at(points, by_rank.back()) != at(points, v)) by_rank.push_back(v);
    }
  }
  std::vector<TetVertices> tets;
  const std::size_t n = by_rank.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          TetVertices t{by_rank[a], by_rank[b], by_rank[c], by_rank[d]};
          const Sign sign = orientation(points, t);
          if (sign == Sign::zero) continue;
          if (sign == Sign::negative) std::swap(t[2], t[3]);
          const bool empty = std::none_of(by_rank.begin(), by_rank.end(), [&](VertexId v) {
            return std::find(t.begin(), t.end(), v) == t.end() && strictly_in_sphere(points, t, v);
          });
          if (empty) tets.push_back(t);
        }
      }
    }
  }
  return tets;
}

std::vector<TetVertices> tets_of(const TetMesh& mesh) {
  std::vector<TetVertices> tets;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) tets.push_back(mesh.vertices(TetId(t)));
  return tets;
}

testing::AssertionResult is_canonical(const Delaunay3& d, std::span<const Point3> points) {
  const std::vector<std::size_t> rank = canonical_ranks(points);
  std::array<std::size_t, 4> before{};
  for (const TetVertices& t : tets_of(d.mesh)) {
    if (orientation(points, t) != Sign::positive) {
      return testing::AssertionFailure() << text(t) << " is not positive";
    }
    std::array<std::size_t, 4> listed{};
    for (std::size_t k = 0; k < 4; ++k) listed[k] = rank[t[k].index()];
    std::array<std::size_t, 4> sorted = listed;
    std::sort(sorted.begin(), sorted.end());
    if (listed != sorted) std::swap(listed[2], listed[3]);
    if (listed != sorted) return testing::AssertionFailure() << text(t) << " is not canonical";
    if (!(before < sorted)) return testing::AssertionFailure() << text(t) << " is out of order";
    before = sorted;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult fills_convex_hull(const Delaunay3& d, std::span<const Point3> points) {
  std::set<std::array<VertexId, 2>> edges;
  std::set<VertexId> vertices;
  std::size_t triangles = 0;
  for (std::size_t t = 0; t < d.mesh.tet_slots(); ++t) {
    for (int i = 0; i < 4; ++i) {
      const auto face = outward_face(d.mesh.vertices(TetId(t)), i);
      const HalfFaceId h = TetMesh::half_face(TetId(t), i);
      const HalfFaceId g = d.mesh.opposite(h);
      if (g.valid()) {
        if (TetMesh::tet_of(g).index() >= d.mesh.tet_slots() || d.mesh.opposite(g) != h) {
          return testing::AssertionFailure() << "half-face " << h.value() << " is not returned";
        }
        auto back = outward_face(d.mesh.vertices(TetMesh::tet_of(g)), TetMesh::face_of(g));
        std::swap(back[0], back[1]);
        if (rotated(face) != rotated(back)) {
          return testing::AssertionFailure() << "half-face " << h.value() << " does not fit";
        }
        continue;
      }
      ++triangles;
      for (std::size_t k = 0; k < 3; ++k) {
        vertices.insert(face[k]);
        // Directed: a closed oriented surface has every edge once in each direction.
        if (!edges.insert({face[k], face[(k + 1) % 3]}).second) {
          return testing::AssertionFailure() << "a hull edge has two facets on one side";
        }
      }
      for (const Point3& p : points) {
        if (orient3d(at(points, face[0]), at(points, face[1]), at(points, face[2]), p) ==
            Sign::positive) {
          return testing::AssertionFailure() << "a point lies beyond a hull facet";
        }
      }
    }
  }
  for (const auto& e : edges) {
    if (!edges.contains({e[1], e[0]})) return testing::AssertionFailure() << "an open hull edge";
  }
  if (2 * vertices.size() + 2 * triangles != edges.size() + 4) {
    return testing::AssertionFailure() << "the hull is no sphere";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_locally_delaunay(const Delaunay3& d, std::span<const Point3> points) {
  for (std::size_t h = 0; h < 4 * d.mesh.tet_slots(); ++h) {
    const HalfFaceId g = d.mesh.opposite(HalfFaceId(h));
    if (!g.valid()) continue;
    const TetVertices& t = d.mesh.vertices(TetId(h / 4));
    const VertexId far = d.mesh.vertex(TetMesh::tet_of(g), TetMesh::face_of(g));
    if (strictly_in_sphere(points, t, far)) {
      return testing::AssertionFailure() << far.value() << " is in the sphere of " << text(t);
    }
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult uses_all_points(const Delaunay3& d) {
  std::vector<bool> used(d.representative.size(), false);
  for (const TetVertices& t : tets_of(d.mesh)) {
    for (const VertexId v : t) used[v.index()] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] != (d.representative[VertexId(i)] == VertexId(i))) {
      return testing::AssertionFailure()
             << "vertex " << i << (used[i] ? " is" : " is not") << " in a tet";
    }
  }
  return testing::AssertionSuccess();
}

void expect_delaunay(std::span<const Point3> points) {
  const Delaunay3 d = triangulate(points);
  EXPECT_EQ(d.dimension, 3);
  EXPECT_EQ(d.mesh.vertex_count(), points.size());
  EXPECT_TRUE(is_canonical(d, points));
  EXPECT_TRUE(fills_convex_hull(d, points));
  EXPECT_TRUE(is_locally_delaunay(d, points));
  EXPECT_TRUE(uses_all_points(d));
  for (const MeshViolation& violation : d.mesh.validate()) {
    ADD_FAILURE() << "condition " << violation.condition << ": " << violation.message;
  }
}

void expect_brute_force(std::span<const Point3> points) {
  expect_delaunay(points);
  EXPECT_EQ(tets_of(triangulate(points).mesh), brute_force_tets(points));
}

double six_volumes(const Delaunay3& d, std::span<const Point3> points) {
  double sum = 0;
  for (const TetVertices& t : tets_of(d.mesh)) {
    const Point3& a = at(points, t[0]);
    double e[3][3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = at(points, t[k + 1]);
      e[k][0] = p.x - a.x;
      e[k][1] = p.y - a.y;
      e[k][2] = p.z - a.z;
    }
    sum += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  }
  return sum;
}

Points lattice(int nx, int ny, int nz) {
  Points points;
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  return points;
}

Points uniform(std::size_t n, Prng& prng) {
  Points points(n);
  for (Point3& p : points) p = {prng.unit(), prng.unit(), prng.unit()};
  return points;
}

Points grid_subset(std::size_t n, int side, Prng& prng) {
  Points points = lattice(side, side, side);
  prng.shuffle(points);
  points.resize(std::min(n, points.size()));
  return points;
}

Points integer_sphere(int radius) {
  Points points;
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      for (int z = -radius; z <= radius; ++z) {
        if (x * x + y * y + z * z == radius * radius) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  return points;
}

}  // namespace tetloft::test
