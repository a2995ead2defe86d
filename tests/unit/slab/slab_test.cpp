// Types of tets, type-1 tets of triangles, rings and stars, against definitions read off
// the triangles.
#include "slab/slab.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <tetloft/predicates.hpp>

#include "contact/contact.hpp"
#include "slab/delaunay.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The kind of an in-plane edge, from the triangles on it alone.
EdgeKind kind_by_triangles(const ConformingSection& section, PlaneVertexId u, PlaneVertexId v) {
  std::size_t inside = 0;
  std::size_t outside = 0;
  for (std::size_t k = 0; k < section.triangulation.triangles.size(); ++k) {
    const PlaneTriangleVertices& t = section.triangulation.triangles[TriangleId(k)];
    if (std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) != 2) continue;
    ++(section.internal[TriangleId(k)] != 0 ? inside : outside);
  }
  if (inside == 2) return EdgeKind::internal;
  return inside == 0 ? EdgeKind::external : EdgeKind::contour;
}

TetKind kind_by_definition(const SlabCase& c, TetId t) {
  std::vector<PlaneVertexId> low;
  std::vector<PlaneVertexId> high;
  for (const SlabVertexId v : c.slab->vertices(t)) {
    if (v.index() < c.lower.vertex_count()) {
      low.emplace_back(v.value());
    } else {
      high.emplace_back(v.index() - c.lower.vertex_count());
    }
  }
  if (low.size() != 2) {
    const ConformingSection& section = low.size() == 3 ? c.lower : c.upper;
    const auto& corner = low.size() == 3 ? low : high;
    const TriangleId on = section.find_triangle(corner.at(0), corner.at(1), corner.at(2));
    return section.internal[on] != 0 ? TetKind::t1_internal : TetKind::t1_external;
  }
  const std::multiset<EdgeKind> kinds{kind_by_triangles(c.lower, low.at(0), low.at(1)),
                                      kind_by_triangles(c.upper, high.at(0), high.at(1))};
  static const std::map<std::multiset<EdgeKind>, TetKind> kKinds{
      {{EdgeKind::internal, EdgeKind::internal}, TetKind::ii},
      {{EdgeKind::internal, EdgeKind::external}, TetKind::ie},
      {{EdgeKind::internal, EdgeKind::contour}, TetKind::ic},
      {{EdgeKind::external, EdgeKind::external}, TetKind::ee},
      {{EdgeKind::external, EdgeKind::contour}, TetKind::ec},
      {{EdgeKind::contour, EdgeKind::contour}, TetKind::cc}};
  return kKinds.at(kinds);
}

TEST(Slab, TypesOfTetsFollowTheirInPlaneTrianglesAndEdges) {
  std::set<TetKind> met;
  for (const NamedSlab& s : generated_slabs(100, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      ASSERT_EQ(slab.kind(TetId(k)), kind_by_definition(*s.built, TetId(k))) << k;
      met.insert(slab.kind(TetId(k)));
    }
  }
  EXPECT_EQ(met.size(), 8U) << "all types but prisms";
}

TEST(Slab, EveryInPlaneTriangleHasExactlyOneTypeOneTet) {
  for (const NamedSlab& s : generated_slabs(101, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::map<std::set<SlabVertexId>, int> tets_on;
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      for (const bool upper : {false, true}) {
        std::set<SlabVertexId> corners;
        for (const SlabVertexId v : slab.vertices(TetId(k))) {
          if (slab.is_upper(v) == upper) corners.insert(v);
        }
        if (corners.size() == 3) ++tets_on[corners];
      }
    }
    const std::size_t triangles = s.built->lower.triangulation.triangles.size() +
                                  s.built->upper.triangulation.triangles.size();
    EXPECT_EQ(tets_on.size(), triangles);
    for (const auto& [corners, count] : tets_on) EXPECT_EQ(count, 1);
  }
}

TEST(Slab, StarsHoldTheTetsOfTheMeshById) {
  for (const NamedSlab& s : generated_slabs(102, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::size_t corners = 0;
    // By a search of all tets.
    std::vector<std::vector<TetId>> expected(slab.vertex_count());
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      for (const SlabVertexId v : slab.vertices(TetId(k))) expected[v.index()].push_back(TetId(k));
    }
    for (std::size_t v = 0; v < slab.vertex_count(); ++v) {
      std::vector<TetId> tets;
      for (const HalfFaceId corner : slab.corners(SlabVertexId(v))) {
        const TetId t = TetMesh::tet_of(corner);
        EXPECT_EQ(slab.vertex(t, TetMesh::face_of(corner)), SlabVertexId(v));
        tets.push_back(t);
      }
      ASSERT_EQ(tets, expected[v]);
      corners += tets.size();
    }
    EXPECT_EQ(corners, 4 * slab.tet_count());
  }
}

// Equal up to direction; cycles have the same start.
bool same_ring(std::vector<TetId> ring, const std::vector<TetId>& expected, bool cycle) {
  if (ring == expected) return true;
  std::reverse(ring.begin() + (cycle ? 1 : 0), ring.end());
  return ring == expected;
}

TEST(Slab, RingsAgreeWithThoseOfTheMesh) {
  std::size_t cycles = 0;
  std::size_t paths = 0;
  for (const NamedSlab& s : generated_slabs(103, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::vector<TetId> ring;
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      const TetId t(k);
      for (const auto& [i, j] : kEdgeVertex) {
        const VertexId p = slab.mesh().vertex(t, i);
        const VertexId q = slab.mesh().vertex(t, j);
        const bool cycle = slab.ring(slab.vertex(t, i), slab.vertex(t, j), t, ring);
        ++(cycle ? cycles : paths);
        ASSERT_TRUE(same_ring(ring, slab.mesh().ring(p, q, t), cycle));
        ASSERT_EQ(cycle, slab.mesh().classify_link(p, q) == LinkKind::sphere);
      }
    }
  }
  EXPECT_GT(cycles, 0U);
  EXPECT_GT(paths, 0U);
}

TEST(Slab, FindsATetAtEveryInPlaneEdge) {
  for (const NamedSlab& s : generated_slabs(104, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    for (const bool upper : {false, true}) {
      const ConformingSection& section = upper ? s.built->upper : s.built->lower;
      const std::size_t offset = upper ? s.built->lower.vertex_count() : 0;
      for (std::size_t e = 0; e < section.edges.size(); ++e) {
        const TetId t = slab.tet_at_edge(upper, EdgeId(e));
        const auto& edge = section.edges[EdgeId(e)];
        EXPECT_GE(slab.mesh().index_in(t, VertexId(edge.a.index() + offset)), 0);
        EXPECT_GE(slab.mesh().index_in(t, VertexId(edge.b.index() + offset)), 0);
      }
    }
  }
}

// By tet, as the overlay hands it over or a search finds it: the same as by vertices.
TEST(Slab, KnowsTheEdgesAndTheTriangleOfEachTet) {
  for (const DelaunayEngine engine : {DelaunayEngine::slab, DelaunayEngine::incremental}) {
    for (const NamedSlab& s : generated_slabs(106, 1)) {
      SCOPED_TRACE(s.name);
      const Slab slab(
          s.built->lower, s.built->upper,
          slab_delaunay(SlabId(0), s.built->lower, s.built->upper, engine, kDefaultWorkLimit)
              .value());
      for (const TetId t : slab.tets()) {
        std::size_t in_plane = 0;
        for (const auto& [i, j] : kEdgeVertex) {
          if (!slab.same_plane(t, i, j)) continue;
          ++in_plane;
          ASSERT_EQ(slab.edge(t, i, j), slab.edge(slab.vertex(t, i), slab.vertex(t, j)));
        }
        if (in_plane != 3) continue;
        const bool upper = slab.has_triangle(t, true);
        ASSERT_NE(upper, slab.has_triangle(t, false));
        EXPECT_EQ(slab.tet_on(upper, slab.triangle(t)), t);
        for (const PlaneVertexId v :
             slab.section(upper).triangulation.triangles[slab.triangle(t)]) {
          const SlabVertexId corner = slab.numbering().in_slab(upper, v);
          EXPECT_GE(slab.mesh().index_in(t, VertexId(corner.value())), 0);
        }
      }
    }
  }
}

// The lemma by which embedding leaves out pairs of boundary triangles.
TEST(Slab, NoTwoFacesOfItsTriangulationAreInContact) {
  std::size_t slabs = 0;
  for (const NamedSlab& s : generated_slabs(105, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::vector<Point3> points;
    for (std::size_t v = 0; v < slab.vertex_count(); ++v)
      points.push_back(slab.point(SlabVertexId(v)));
    std::set<TriangleVertices> faces;
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      const auto& v = slab.mesh().vertices(TetId(k));
      ASSERT_EQ(orient3d(points[v[0].index()], points[v[1].index()], points[v[2].index()],
                         points[v[3].index()]),
                Sign::positive);
      for (std::size_t i = 0; i < 4; ++i) {
        TriangleVertices face{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]};
        std::sort(face.begin(), face.end());
        faces.insert(face);
      }
    }
    const std::vector<TriangleVertices> triangles(faces.begin(), faces.end());
    EXPECT_TRUE(find_contacts(points, triangles).empty());
    ++slabs;
  }
  EXPECT_GT(slabs, 0U);
}

}  // namespace
}  // namespace tetloft::testing
