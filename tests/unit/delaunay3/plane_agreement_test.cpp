// On two parallel planes the 3D triangulation induces the 2D one in each: what lets
// neighbouring slabs share a section's triangulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "support.hpp"

namespace tetloft::test {
namespace {

using Triangle = std::array<std::size_t, 3>;

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

// Expects that the triangles of the mesh with all vertices among `plane` are those of
// delaunay2 of these points.
void expect_plane_agrees(const Delaunay3& d, const std::vector<std::size_t>& plane,
                         const Points& points) {
  std::vector<Point2> flat;
  for (const std::size_t i : plane) flat.push_back({points[i].x, points[i].y});
  const Result<Triangulation2> expected = delaunay2(flat);
  ASSERT_TRUE(expected.ok());
  std::set<Triangle> in_2d;
  for (const PlaneTriangleVertices& t : expected->triangles) {
    in_2d.insert(sorted({plane[t[0].index()], plane[t[1].index()], plane[t[2].index()]}));
  }
  std::set<Triangle> in_3d;
  const double z = points[plane.front()].z;
  for (const TetVertices& t : tets_of(d.mesh)) {
    for (std::size_t apex = 0; apex < 4; ++apex) {
      Triangle face{};
      for (std::size_t k = 0; k < 3; ++k) face[k] = t[(apex + k + 1) % 4].index();
      if (std::all_of(face.begin(), face.end(), [&](std::size_t i) { return points[i].z == z; })) {
        // In two planes no tet lies beyond: each such face belongs to one tet.
        EXPECT_TRUE(in_3d.insert(sorted(face)).second);
      }
    }
  }
  EXPECT_EQ(in_3d, in_2d);
}

void expect_planes_agree(const Points& points) {
  const Delaunay3 d = triangulate(points);
  if (d.dimension < 3) return;
  std::set<double> heights;
  for (const Point3& p : points) heights.insert(p.z);
  for (const double z : heights) {
    std::vector<std::size_t> plane;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].z == z) plane.push_back(i);
    }
    expect_plane_agrees(d, plane, points);
  }
}

TEST(PlaneAgreement, RandomSections) {
  Prng prng(41);
  for (int round = 0; round < 20; ++round) {
    Points points = uniform(120, prng);
    for (Point3& p : points) p.z = p.z < 0.4 ? -1 : 2.5;
    expect_planes_agree(points);
  }
}

TEST(PlaneAgreement, PixelSections) {
  Prng prng(42);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int side = 2 + static_cast<int>(prng.below(6));
    const auto draw = [&] {
      return static_cast<double>(prng.below(static_cast<std::uint64_t>(side)));
    };
    Points points;
    for (std::size_t i = 0; i < 5 + prng.below(60); ++i) {
      points.push_back({draw(), draw(), prng.chance(0.5) ? 0.0 : 3.0});
    }
    expect_planes_agree(points);
  }
}

TEST(PlaneAgreement, EqualSections) {
  Points points = lattice(9, 7, 2);
  expect_planes_agree(points);
  const Points ring{{5, 0, 0},  {4, 3, 0},   {3, 4, 0},   {0, 5, 0},  {-3, 4, 0}, {-4, 3, 0},
                    {-5, 0, 0}, {-4, -3, 0}, {-3, -4, 0}, {0, -5, 0}, {3, -4, 0}, {4, -3, 0}};
  points = ring;
  for (const Point3& p : ring) points.push_back({p.x, p.y, 10});
  expect_planes_agree(points);
}

TEST(PlaneAgreement, CollinearSectionInducesNoTriangle) {
  Points points = lattice(4, 4, 1);
  for (int i = 0; i < 7; ++i) points.push_back({0.5 * i, 0.5 * i, 1});
  expect_planes_agree(points);
}

TEST(PlaneAgreement, PlanesTriangulatedOnTwoThreadsGiveTheSame) {
  Prng prng(21);
  Points points = uniform(400, prng);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z = i % 2 == 0 ? 0 : 1;
  const auto one = delaunay3(points, {.engine = DelaunayEngine::slab, .execution = {.threads = 1}});
  const auto two = delaunay3(points, {.engine = DelaunayEngine::slab, .execution = {.threads = 2}});
  ASSERT_TRUE(one.ok() && two.ok());
  EXPECT_EQ(tets_of(one->mesh), tets_of(two->mesh));
  EXPECT_GT(one->mesh.tet_count(), 400U);
}

}  // namespace
}  // namespace tetloft::test
