// D of a slab: no vertex in a circumsphere, and the two engines agree.
#include "slab/delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include <tetloft/predicates.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

std::vector<Point3> points_of(const SlabCase& c) {
  std::vector<Point3> points;
  for (const ConformingSection* section : {&c.lower, &c.upper}) {
    for (std::size_t v = 0; v < section->vertex_count(); ++v) {
      points.push_back(section->point3(PlaneVertexId(v)));
    }
  }
  return points;
}

TEST(SlabDelaunay, NoVertexLiesInACircumsphere) {
  std::size_t tests = 0;
  for (const NamedSlab& s : generated_slabs(110, 1)) {
    SCOPED_TRACE(s.name);
    const std::vector<Point3> points = points_of(*s.built);
    if (points.size() > 60) continue;
    const TetMesh d = slab_delaunay(SlabId(0), s.built->lower, s.built->upper,
                                    DelaunayEngine::automatic, kDefaultWorkLimit)
                          .value()
                          .mesh;
    ASSERT_EQ(d.vertex_count(), points.size());
    for (std::size_t t = 0; t < d.tet_slots(); ++t) {
      const TetVertices& v = d.vertices(TetId(t));
      const auto corner = [&](std::size_t i) { return points[v.at(i).index()]; };
      ASSERT_EQ(orient3d(corner(0), corner(1), corner(2), corner(3)), Sign::positive);
      for (const Point3& p : points) {
        EXPECT_NE(insphere(corner(0), corner(1), corner(2), corner(3), p), Sign::positive);
        ++tests;
      }
    }
  }
  EXPECT_GT(tests, 10000U);
}

TEST(SlabDelaunay, IsTheSameByEitherEngine) {
  for (const NamedSlab& s : generated_slabs(111, 1)) {
    SCOPED_TRACE(s.name);
    const auto by = [&](DelaunayEngine engine) {
      const TetMesh d =
          slab_delaunay(SlabId(0), s.built->lower, s.built->upper, engine, kDefaultWorkLimit)
              .value()
              .mesh;
      std::vector<TetVertices> tets;
      for (std::size_t t = 0; t < d.tet_slots(); ++t) tets.push_back(d.vertices(TetId(t)));
      return tets;
    };
    EXPECT_EQ(by(DelaunayEngine::slab), by(DelaunayEngine::incremental));
  }
}

TEST(SlabDelaunay, TooManyTetsAreRefusedNamingSlabAndTheSectionOfMoreVertices) {
  Contour polygon = box(0, 0, 4, 4);
  polygon.vertices.insert(polygon.vertices.begin() + 1, {2, -1});
  for (const bool below : {false, true}) {
    const auto c = slab_case(below ? stack_of_boxes({{polygon}, {box(0, 0, 4, 4)}})
                                   : stack_of_boxes({{box(0, 0, 4, 4)}, {polygon}}),
                             0);
    for (const DelaunayEngine engine : {DelaunayEngine::slab, DelaunayEngine::incremental}) {
      const Result<SlabDelaunay> refused =
          slab_delaunay(SlabId(5), c->lower, c->upper, engine, 1e-9);
      ASSERT_FALSE(refused.ok());
      EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
      EXPECT_EQ(refused.error().where.slab, 5U);
      ASSERT_TRUE(refused.error().where.point);
      EXPECT_EQ(refused.error().where.point->z, below ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
