// Stars, links and rings against plain set operations, singular ones included.
#include <set>

#include "unit/mesh/link_oracle.hpp"
#include "unit/mesh/meshes.hpp"

namespace tetloft::mesh_test {
namespace {

std::vector<TetId> containing(const Soup& soup, const Simplex& simplex) {
  std::vector<TetId> result;
  for (std::size_t t = 0; t < soup.size(); ++t) {
    const Simplex all(soup[t].begin(), soup[t].end());
    if (std::includes(all.begin(), all.end(), simplex.begin(), simplex.end())) {
      result.push_back(TetId(t));
    }
  }
  return result;
}

template <class Simplices>
Complex as_sets(const Simplices& simplices) {
  Complex result;
  for (const auto& s : simplices) result.insert(Simplex(s.begin(), s.end()));
  return result;
}

class RandomParts : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    Prng random(static_cast<std::uint64_t>(GetParam()));
    soup_ = random_part(grid_, random.between(0.2, 1), random);
    mesh_ = make(grid_.vertices(), soup_);
  }
  Grid grid_{2, 2, 2};
  Soup soup_;
  TetMesh mesh_;
};

TEST_P(RandomParts, StarsAndLinksOfVerticesAgreeWithSets) {
  for (std::size_t i = 0; i < grid_.vertices(); ++i) {
    const VertexId v(i);
    EXPECT_EQ(mesh_.star(v), containing(soup_, {v}));
    EXPECT_EQ(as_sets(mesh_.link(v)), link_of(soup_, {v}));
    std::size_t corners = 0;
    if (const HalfFaceId first = mesh_.first_corner(v); first.valid()) {
      HalfFaceId c = first;
      do {
        EXPECT_EQ(mesh_.vertex(TetMesh::tet_of(c), TetMesh::face_of(c)), v);
        ++corners;
        c = mesh_.next_corner(c);
      } while (c != first);
    }
    EXPECT_EQ(corners, mesh_.star(v).size());
  }
}

TEST_P(RandomParts, StarsAndLinksOfEdgesAgreeWithSets) {
  for (std::size_t i = 0; i < grid_.vertices(); ++i) {
    for (std::size_t j = 0; j < grid_.vertices(); ++j) {
      if (i == j) continue;
      const VertexId a(i);
      const VertexId b(j);
      EXPECT_EQ(mesh_.star(a, b), containing(soup_, {a, b}));
      EXPECT_EQ(as_sets(mesh_.link(a, b)), link_of(soup_, {a, b}));
    }
  }
}

TEST_P(RandomParts, StarsAndLinksOfFacesAgreeWithSets) {
  for (std::size_t h = 0; h < 4 * mesh_.tet_slots(); ++h) {
    const HalfFaceId half(h);
    const TriangleVertices face = mesh_.face_vertices(half);
    std::vector<TetId> star = mesh_.star(half);
    EXPECT_EQ(star.front(), TetMesh::tet_of(half));
    std::sort(star.begin(), star.end());
    const Simplex set(face.begin(), face.end());
    EXPECT_EQ(star, containing(soup_, set));
    Complex apexes;
    for (const VertexId v : mesh_.link(half)) apexes.insert({v});
    EXPECT_EQ(apexes, link_of(soup_, set));
  }
}

TEST_P(RandomParts, RingsStepThroughFacesCounterClockwiseAboutTheirEdge) {
  for (std::size_t s = 0; s < mesh_.tet_slots(); ++s) {
    for (const std::array<int, 2>& e : kEdgeVertex) {
      const TetId start(s);
      VertexId a = mesh_.vertex(start, e[0]);
      VertexId b = mesh_.vertex(start, e[1]);
      if (s % 2 == 1) std::swap(a, b);
      const std::vector<TetId> ring = mesh_.ring(a, b, start);
      // The third vertex of the face through which the ring goes on, or came from.
      const auto far_vertex = [&](TetId t, bool onward) {
        for (int i = 0; i < 4; ++i) {
          const TriangleVertices f = mesh_.face_vertices(TetMesh::half_face(t, i));
          for (std::size_t k = 0; k < 3; ++k) {
            // The face that holds a → b in its outward order is the one turned towards.
            if (f[k] == a && f[(k + 1) % 3] == b && onward) return f[(k + 2) % 3];
            if (f[k] == b && f[(k + 1) % 3] == a && !onward) return f[(k + 2) % 3];
          }
        }
        return VertexId();
      };
      EXPECT_EQ(std::set<TetId>(ring.begin(), ring.end()).size(), ring.size());
      EXPECT_EQ(std::count(ring.begin(), ring.end(), start), 1);
      for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
        EXPECT_EQ(far_vertex(ring[k], true), far_vertex(ring[k + 1], false));
      }
      const bool closed = far_vertex(ring.back(), true) == far_vertex(ring.front(), false);
      if (closed) {
        EXPECT_EQ(ring.front(), start);
      } else {
        const auto on_boundary = [&](TetId t, bool onward) {
          return containing(soup_, {a, b, far_vertex(t, onward)}).size() == 1;
        };
        EXPECT_TRUE(on_boundary(ring.front(), false));
        EXPECT_TRUE(on_boundary(ring.back(), true));
      }
    }
  }
}

TEST_P(RandomParts, LinkTrianglesAreOutwardFacesOfTheirTets) {
  for (std::size_t i = 0; i < grid_.vertices(); ++i) {
    const VertexId v(i);
    const std::vector<TetId> star = mesh_.star(v);
    const std::vector<TriangleVertices> link = mesh_.link(v);
    ASSERT_EQ(link.size(), star.size());
    for (std::size_t k = 0; k < star.size(); ++k) {
      const HalfFaceId opposite_v = TetMesh::half_face(star[k], mesh_.index_in(star[k], v));
      EXPECT_EQ(link[k], mesh_.face_vertices(opposite_v));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(StarLink, RandomParts, testing::Range(100, 108));

TEST(StarLink, RingTurnsByTheRightHandRule) {
  // Edge 0 → 1 along z; 2, 3, 4 follow each other counter-clockwise seen from above.
  const TetMesh mesh = make(5, {tet(0, 1, 4, 2), tet(0, 1, 2, 3), tet(0, 1, 3, 4)});
  const VertexId a(0);
  const VertexId b(1);
  EXPECT_EQ(mesh.ring(a, b, TetId(1)), (std::vector<TetId>{TetId(1), TetId(2), TetId(0)}));
  EXPECT_EQ(mesh.ring(b, a, TetId(1)), (std::vector<TetId>{TetId(1), TetId(0), TetId(2)}));
}

TEST(StarLink, OfAVertexInNoTetAreEmpty) {
  const TetMesh mesh = make(5, {tet(0, 1, 2, 3)});
  EXPECT_FALSE(mesh.any_tet(VertexId(4)).valid());
  EXPECT_TRUE(mesh.star(VertexId(4)).empty());
  EXPECT_TRUE(mesh.star(VertexId(4), VertexId(0)).empty());
  EXPECT_TRUE(mesh.link(VertexId(4)).empty());
  EXPECT_EQ(mesh.index_in(TetId(0), VertexId(4)), -1);
}

}  // namespace
}  // namespace tetloft::mesh_test
