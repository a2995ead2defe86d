#include <tetloft/model.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/prng.hpp"
#include "model/volume.hpp"

namespace tetloft {

using namespace internal;
namespace {

VertexId v(int i) { return VertexId(i); }

// A positive tet over the unit axes.
Model one_tet() {
  Model model;
  model.points = IdVector<VertexId, Point3>(
      std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  model.tets.push_back({v(0), v(1), v(2), v(3)});
  return model;
}

// Twice the vector area's dot product with the vector to an outer reference point.
double outward(const Model& model, const TriangleVertices& t, const Point3& inside) {
  const Point3& a = model.points[t[0]];
  const Point3& b = model.points[t[1]];
  const Point3& c = model.points[t[2]];
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 w{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x};
  return n.x * (a.x - inside.x) + n.y * (a.y - inside.y) + n.z * (a.z - inside.z);
}

TEST(HalfFaces, HaveTheModelsIdsAndItsBoundary) {
  Model model = one_tet();
  model.tets.push_back({v(1), v(2), v(3), v(4)});
  const Result<TetMesh> mesh = half_faces(model);
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->vertices(TetId(1)), model.tets[TetId(1)]);
  EXPECT_EQ(mesh->star(v(1), v(2)), (std::vector<TetId>{TetId(0), TetId(1)}));
  std::vector<TriangleVertices> boundary;
  for (const HalfFaceId h : mesh->boundary()) boundary.push_back(mesh->face_vertices(h));
  EXPECT_EQ(boundary, boundary_surface(model).triangles);
}

TEST(HalfFaces, OfAModelThatHasNoneAreRefused) {
  Model model = one_tet();
  model.tets.push_back(model.tets[TetId(0)]);
  EXPECT_EQ(half_faces(model).error().code, ErrorCode::invalid_input);
}

TEST(BoundarySurface, OfNothingIsEmpty) {
  EXPECT_TRUE(boundary_surface(Model{}).triangles.empty());
}

TEST(BoundarySurface, OfOneTetIsItsFourFacesOutward) {
  const Model model = one_tet();
  const Surface surface = boundary_surface(model);
  ASSERT_EQ(surface.triangles.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(outward(model, surface.triangles[i], {0.1, 0.1, 0.1}), 0) << i;
    EXPECT_EQ(surface.tet[i], TetId(0));
    for (const VertexId w : surface.triangles[i]) EXPECT_NE(w, v(static_cast<int>(i)));
  }
}

TEST(BoundarySurface, LeavesOutFacesOfTwoTets) {
  Model model = one_tet();
  model.tets.push_back({v(1), v(2), v(3), v(4)});
  const Surface surface = boundary_surface(model);
  ASSERT_EQ(surface.triangles.size(), 6U);
  const std::set<VertexId> shared{v(1), v(2), v(3)};
  for (const TriangleVertices& t : surface.triangles)
    EXPECT_NE((std::set<VertexId>{t[0], t[1], t[2]}), shared);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(surface.tet[i], TetId(i / 3));
}

TEST(Volume, OfTheUnitCornerIsASixth) { EXPECT_DOUBLE_EQ(volume(one_tet()), 1.0 / 6); }

TEST(Volume, ChangesSignWithOrientation) {
  Model model = one_tet();
  std::swap(model.tets[TetId(0)][0], model.tets[TetId(0)][1]);
  EXPECT_DOUBLE_EQ(volume(model), -1.0 / 6);
}

TEST(Volume, KeepsSmallTetsBesideALargeOne) {
  Model model;
  for (int i = 0; i < 1025; ++i) {
    const double s = i == 0 ? 0x1p20 : 0x1p-1;
    const double x = i == 0 ? 0 : 0x1p21 + i;
    const int first = 4 * i;
    model.points.push_back({x, 0, 0});
    model.points.push_back({x + s, 0, 0});
    model.points.push_back({x, s, 0});
    model.points.push_back({x, 0, s});
    model.tets.push_back({v(first), v(first + 1), v(first + 2), v(first + 3)});
  }
  EXPECT_DOUBLE_EQ(volume(model), 0x1p60 / 6 + 1024 * 0x1p-3 / 6);
}

long double volume_in_long_double(const Model& model, const TetVertices& tet) {
  std::array<std::array<long double, 3>, 3> from_first{};
  const Point3& o = model.points[tet[0]];
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = model.points[tet.at(i + 1)];
    from_first.at(i) = {static_cast<long double>(p.x) - o.x, static_cast<long double>(p.y) - o.y,
                        static_cast<long double>(p.z) - o.z};
  }
  const auto& [a, b, c] = from_first;
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

TEST(Volume, IsTheSameOnAnyNumberOfThreads) {
  Prng prng(77);
  Model model;
  for (int i = 0; i < 1000; ++i) {
    model.points.push_back({prng.unit() * 1e3, prng.unit(), prng.unit() * 1e-3});
  }
  long double expected = 0;
  for (int i = 0; i < 100'000; ++i) {
    TetVertices tet;
    for (VertexId& u : tet) u = VertexId(prng.below(1000));
    model.tets.push_back(tet);
    expected += volume_in_long_double(model, tet);
  }
  model.tets.push_back({v(0), v(1), v(2), VertexId()});  // adds nothing
  const double alone = volume_of(model, 1);
  EXPECT_NEAR(alone, static_cast<double>(expected), 1e-9 * std::abs(alone));
  for (const unsigned threads : {2U, 3U, 7U}) EXPECT_EQ(volume_of(model, threads), alone);
}

TEST(Names, AreDistinct) {
  std::set<std::string> kinds;
  for (int i = 0; i < kTetKinds; ++i) kinds.insert(name_of(static_cast<TetKind>(i)));
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kTetKinds));
  std::set<std::string> origins;
  for (int i = 0; i < kPointOrigins; ++i) origins.insert(name_of(static_cast<PointOrigin>(i)));
  EXPECT_EQ(origins.size(), static_cast<std::size_t>(kPointOrigins));
}

}  // namespace
}  // namespace tetloft
