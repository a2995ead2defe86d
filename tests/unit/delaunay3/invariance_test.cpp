// The triangulation depends on the set of points only, and exact transformations of the
// points that keep their canonical order keep it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support.hpp"

namespace tetloft::test {
namespace {

// Names the vertices of the triangulation of `points` by `name`, and checks that it is
// `expected`.
void expect_same_under_names(const Points& points, const std::vector<std::size_t>& name,
                             const std::vector<TetVertices>& expected) {
  std::vector<TetVertices> tets = tets_of(triangulate(points).mesh);
  for (TetVertices& t : tets) {
    for (VertexId& v : t) v = VertexId(name[v.index()]);
  }
  EXPECT_EQ(tets, expected);
}

void expect_order_independent(const Points& points, std::uint64_t seed) {
  const std::vector<TetVertices> expected = tets_of(triangulate(points).mesh);
  Prng prng(seed);
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << " round " << round);
    std::vector<std::size_t> name(points.size());
    for (std::size_t i = 0; i < name.size(); ++i) name[i] = i;
    prng.shuffle(name);
    Points permuted;
    for (const std::size_t i : name) permuted.push_back(points[i]);
    expect_same_under_names(permuted, name, expected);
  }
}

TEST(Delaunay3Invariance, LatticeUnderInputOrder) {
  expect_order_independent(lattice(5, 4, 4), 21);
}

TEST(Delaunay3Invariance, TwoPlanesUnderInputOrder) {
  expect_order_independent(lattice(8, 8, 2), 22);
}

TEST(Delaunay3Invariance, SphereUnderInputOrder) {
  expect_order_independent(integer_sphere(9), 23);
}

TEST(Delaunay3Invariance, RandomPointsUnderInputOrder) {
  Prng prng(24);
  expect_order_independent(uniform(300, prng), 24);
}

// The order of insertion is drawn from the set of points. Points added far away and left
// out again change it completely, and the tets away from them not at all.
TEST(Delaunay3Invariance, LatticeUnderInsertionOrder) {
  const Points points = lattice(4, 4, 4);
  std::vector<TetVertices> expected = tets_of(triangulate(points).mesh);
  for (int extra = 1; extra <= 24; ++extra) {
    Points more = points;
    for (int i = 0; i < extra; ++i) more.push_back({1.25 + 50 * i, -1e4, 1.5 + 7 * i});
    std::vector<TetVertices> tets = tets_of(triangulate(more).mesh);
    std::erase_if(tets, [&](const TetVertices& t) {
      return std::any_of(t.begin(), t.end(),
                         [&](VertexId v) { return v.index() >= points.size(); });
    });
    EXPECT_EQ(tets, expected);
  }
}

TEST(Delaunay3Invariance, PowerOfTwoScalingAndIntegerTranslation) {
  const Points points = lattice(4, 5, 3);
  const std::vector<TetVertices> expected = tets_of(triangulate(points).mesh);
  for (const double scale : {0x1p-30, 0x1p20}) {
    Points moved = points;
    for (Point3& p : moved) p = {scale * (p.x + 3), scale * (p.y - 17), scale * (p.z + 1)};
    EXPECT_EQ(tets_of(triangulate(moved).mesh), expected);
  }
}

TEST(Delaunay3Invariance, DistanceOfTwoPlanesDoesNotMatter) {
  Prng prng(25);
  Points points;
  for (int i = 0; i < 200; ++i) {
    points.push_back({static_cast<double>(prng.below(20)), static_cast<double>(prng.below(20)),
                      static_cast<double>(prng.below(2))});
  }
  const std::vector<TetVertices> expected = tets_of(triangulate(points).mesh);
  for (const double gap : {0x1p-60, 0.1, 1e9}) {
    Points moved = points;
    for (Point3& p : moved) p.z *= gap;
    EXPECT_EQ(tets_of(triangulate(moved).mesh), expected);
  }
}

TEST(Delaunay3Invariance, RunsRepeat) {
  Prng prng(26);
  const Points points = uniform(500, prng);
  const Delaunay3 a = triangulate(points);
  const Delaunay3 b = triangulate(points);
  EXPECT_EQ(tets_of(a.mesh), tets_of(b.mesh));
}

}  // namespace
}  // namespace tetloft::test
