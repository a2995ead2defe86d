// Points inserted by several threads, each in its part of space, give the same mesh as in order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <stop_token>
#include <string>

#include "core/guard.hpp"
#include "delaunay3/affine_basis.hpp"
#include "delaunay3/canonical_mesh.hpp"
#include "delaunay3/incremental.hpp"
#include "delaunay3/partition.hpp"
#include "delaunay3/spatial_order.hpp"
#include "support.hpp"

namespace tetloft::test {
namespace {

using delaunay3_detail::Cuts;
using delaunay3_detail::Delaunay3Builder;
using delaunay3_detail::Partition;
using delaunay3_detail::Sharing;

struct Shared {
  TetMesh mesh;
  std::size_t within_parts = 0;
};

// Of distinct points in canonical order.
Shared shared(const Points& points, const Sharing& sharing, const Execution& execution = {},
              std::size_t tets_of_point = 7) {
  std::vector<std::uint32_t> order = delaunay3_detail::insertion_order(points);
  Points inserted;
  for (const std::uint32_t place : order) inserted.push_back(points[place]);
  const delaunay3_detail::AffineBasis basis = delaunay3_detail::affine_basis(inserted);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto at = static_cast<std::ptrdiff_t>(basis.place[k]);
    const auto to = static_cast<std::ptrdiff_t>(k);
    std::rotate(order.begin() + to, order.begin() + at, order.begin() + at + 1);
  }
  Delaunay3Builder builder(points, order, sharing, tets_of_point);
  WatchedWork work(execution, points.size() / Delaunay3Builder::kPointsOfStep);
  if (!builder.insert_all(work, 1U << 24)) throw std::runtime_error("too many tets");
  std::vector<VertexId> names;
  for (std::size_t i = 0; i < points.size(); ++i) names.emplace_back(i);
  return {delaunay3_detail::canonical_mesh(
              builder.slots(), {.rank_of = order, .input_of = names, .input_count = points.size()},
              sharing.threads),
          builder.inserted_within_parts()};
}

Points canonical(Points points) {
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// The least points to a thread that make parts of sets as small as these.
constexpr std::size_t kFew = 12;

// The engine on one thread makes what the oracles of other tests confirm.
void expect_same(const std::string& name, Points points, bool has_parts = true) {
  points = canonical(std::move(points));
  const Shared alone = shared(points, {.threads = 1, .least_points = kFew});
  EXPECT_EQ(alone.within_parts, 0U);
  for (const unsigned threads : {2U, 3U, 8U}) {
    SCOPED_TRACE(name + " on " + std::to_string(threads));
    const Shared several = shared(points, {.threads = threads, .least_points = kFew});
    EXPECT_TRUE(std::ranges::equal(several.mesh.tets(), alone.mesh.tets()));
    EXPECT_TRUE(std::ranges::equal(several.mesh.opposites(), alone.mesh.opposites()));
    // Some points do lie near the cuts, as parts so small are all border.
    EXPECT_LT(several.within_parts, points.size());
    EXPECT_GE(several.within_parts, has_parts ? 20U : 0U);
  }
}

Points clustered(std::size_t n, std::size_t clusters, Prng& prng) {
  const Points centres = uniform(clusters, prng);
  Points points = uniform(n, prng);
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& c = centres[i % clusters];
    points[i] = {c.x + 1e-3 * points[i].x, c.y + 1e-3 * points[i].y, c.z + 1e-3 * points[i].z};
  }
  return points;
}

Points on_sphere(std::size_t n, Prng& prng) {
  Points points = uniform(n, prng);
  for (Point3& p : points) {
    const double z = 2 * p.z - 1;
    const double r = std::sqrt(1 - z * z);
    p = {r * std::cos(2 * std::numbers::pi * p.x), r * std::sin(2 * std::numbers::pi * p.x), z};
  }
  return points;
}

TEST(SharedInsertion, OfUniformPoints) {
  Prng prng(71);
  for (const std::size_t n : {1500U, 3000U, 6000U}) expect_same("uniform", uniform(n, prng));
}

TEST(SharedInsertion, OfClusters) {
  Prng prng(72);
  expect_same("clusters", clustered(3000, 40, prng));
  expect_same("one cluster far away", [&] {
    Points points = clustered(2000, 1, prng);
    points.push_back({-1e6, 3e5, 1e7});
    return points;
  }());
}

TEST(SharedInsertion, OfCosphericalPoints) {
  Prng prng(73);
  expect_same("lattice", lattice(12, 13, 11));
  expect_same("subset of a lattice", grid_subset(1500, 16, prng));
  expect_same("sphere of integers", integer_sphere(29), false);
  expect_same("sphere", on_sphere(1500, prng), false);
}

TEST(SharedInsertion, OfPlanesAndLines) {
  Prng prng(74);
  Points planes = uniform(1600, prng);
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].z = static_cast<double>(i % 2);
  expect_same("two planes", planes);
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].z = static_cast<double>(i % 5);
  expect_same("five planes", planes, false);
  expect_same("flat lattice", lattice(40, 30, 2));
  Points lines;
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 4; ++k) lines.push_back({i * 1.0, k * k * 50.0, k * 30.0});
  }
  for (const Point3& p : uniform(20, prng)) lines.push_back({300 * p.x, 300 * p.y, 90 * p.z});
  expect_same("parallel lines", lines, false);
  Points curve;
  for (int i = 0; i < 500; ++i) curve.push_back({i * 1.0, i * i * 1.0, i * i * i * 1.0});
  expect_same("moment curve", curve, false);
}

TEST(SharedInsertion, OfTinySets) {
  Prng prng(75);
  for (std::size_t n = 4; n < 140; ++n) expect_same("uniform", uniform(n, prng), false);
  expect_same("cube", lattice(2, 2, 2), false);
}

// Every number of points to a part, down to fewer than can be inserted without others.
TEST(SharedInsertion, WithPartsOfAnySize) {
  Prng prng(76);
  const Points points = canonical(uniform(600, prng));
  const TetMesh alone = shared(points, {}).mesh;
  for (std::size_t least = 1; least < 80; ++least) {
    const TetMesh mesh = shared(points, {.threads = 4, .least_points = least}).mesh;
    EXPECT_TRUE(std::ranges::equal(mesh.tets(), alone.tets()));
  }
}

// Sets of many tets outgrow the room that threads are given, and go on after it was enlarged.
TEST(SharedInsertion, GoesOnWhereThereIsNoRoom) {
  Prng prng(77);
  const Points points = canonical(uniform(9000, prng));
  const TetMesh alone = shared(points, {}).mesh;
  const Shared tight =
      shared(points, {.threads = 3, .least_points = kFew, .room_of_point = 1}, {}, 1);
  EXPECT_GT(tight.within_parts, points.size() / 2);
  EXPECT_TRUE(std::ranges::equal(tight.mesh.tets(), alone.tets()));
}

TEST(SharedInsertion, TellsEachStepOnceAndStops) {
  Prng prng(78);
  const Points points = canonical(uniform(20000, prng));
  std::size_t told = 0;
  const auto count = [&](std::size_t done, std::size_t) { EXPECT_EQ(done, ++told); };
  static_cast<void>(shared(points, {.threads = 3}, {.threads = 3, .progress = count}));
  EXPECT_EQ(told, points.size() / Delaunay3Builder::kPointsOfStep);

  std::stop_source source;
  const auto stop = [&](std::size_t done, std::size_t) {
    if (done == 9) source.request_stop();
  };
  const Execution stopped{.threads = 3, .stop = source.get_token(), .progress = stop};
  EXPECT_THROW(static_cast<void>(shared(points, {.threads = 3}, stopped)), Cancelled);
  const auto fail = [](std::size_t done, std::size_t) {
    if (done == 9) throw std::runtime_error("no more");
  };
  EXPECT_THROW(static_cast<void>(shared(points, {.threads = 3}, {.threads = 3, .progress = fail})),
               Cancelled);
}

TEST(Partition, HasAboutAsManyPointsInEachPart) {
  Prng prng(79);
  const Points points = uniform(5000, prng);
  for (std::size_t parts = 1; parts < 20; ++parts) {
    Points sample(points.begin(), points.begin() + 2000);
    const Partition partition(sample, parts, Cuts::even);
    ASSERT_EQ(partition.parts(), parts);
    std::vector<std::size_t> count(parts);
    for (const Point3& p : points) ++count.at(partition.part_of(p));
    for (const std::size_t c : count) {
      EXPECT_GT(c, points.size() / parts / 2);
      EXPECT_LT(c, 2 * points.size() / parts);
    }
  }
}

// As after a pass that was cut at x = 4: many of the points left are near there.
TEST(Partition, SparseCutsAvoidWherePointsAreDense) {
  Prng prng(81);
  Points points = uniform(2000, prng);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].x = i % 3 != 0 ? 8 * points[i].x : 3.95 + 0.1 * points[i].x;
  }
  Points sample = points;
  EXPECT_NE(Partition(sample, 2, Cuts::even).part_of({3.95, 0.5, 0.5}),
            Partition(sample, 2, Cuts::even).part_of({4.05, 0.5, 0.5}));
  const Partition sparse(sample, 2, Cuts::sparse);
  EXPECT_EQ(sparse.part_of({3.95, 0.5, 0.5}), sparse.part_of({4.05, 0.5, 0.5}));
  std::size_t below = 0;
  for (const Point3& p : points) below += sparse.part_of(p) == 0 ? 1U : 0U;
  EXPECT_GT(below, points.size() / 5);
  EXPECT_LT(below, points.size() * 4 / 5);
}

TEST(Partition, DoesNotCutBetweenFewPlanes) {
  Prng prng(80);
  Points points = uniform(1000, prng);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z = i % 2 == 0 ? 0 : 1e9;
  const Partition partition(points, 8, Cuts::even);
  EXPECT_EQ(partition.parts(), 8U);
  for (const Point3& p : points) {
    EXPECT_EQ(partition.part_of(p), partition.part_of({p.x, p.y, 1e9 - p.z}));
  }
  for (Point3& p : points) p = {0, 1, p.z};
  EXPECT_EQ(Partition(points, 8, Cuts::even).parts(), 1U);
}

}  // namespace
}  // namespace tetloft::test
