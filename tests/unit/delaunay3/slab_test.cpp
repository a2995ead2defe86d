// The slab engine against the incremental one, which shares nothing with it but the exact
// predicates, and against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/watched_work.hpp"
#include "delaunay3/slab_overlay.hpp"
#include "support.hpp"

namespace tetloft::test {
namespace {

Delaunay3 triangulate_by(DelaunayEngine engine, const Points& points) {
  Result<Delaunay3> result = delaunay3(points, {.engine = engine});
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result.value());
}

std::vector<HalfFaceId> opposites_of(const TetMesh& mesh) {
  std::vector<HalfFaceId> opposite;
  for (std::size_t h = 0; h < 4 * mesh.tet_slots(); ++h) {
    opposite.push_back(mesh.opposite(HalfFaceId(h)));
  }
  return opposite;
}

// Returns whether the slab engine takes the points.
bool expect_engines_agree(const Points& points) {
  const Delaunay3 automatic = triangulate_by(DelaunayEngine::automatic, points);
  if (automatic.engine != DelaunayEngine::slab) return false;
  const Delaunay3 slab = triangulate_by(DelaunayEngine::slab, points);
  const Delaunay3 incremental = triangulate_by(DelaunayEngine::incremental, points);
  EXPECT_EQ(incremental.engine, DelaunayEngine::incremental);
  EXPECT_EQ(tets_of(slab.mesh), tets_of(incremental.mesh));
  EXPECT_EQ(opposites_of(slab.mesh), opposites_of(incremental.mesh));
  EXPECT_EQ(tets_of(slab.mesh), tets_of(automatic.mesh));
  EXPECT_EQ(slab.representative, incremental.representative);
  EXPECT_EQ(slab.dimension, 3);
  return true;
}

void append_plane(Points& points, const std::vector<Point2>& plane, double z) {
  for (const Point2& p : plane) points.push_back({p.x, p.y, z});
}

std::vector<Point2> pixels(std::size_t n, int side, Prng& prng) {
  std::vector<Point2> plane(n);
  for (Point2& p : plane) {
    p.x = static_cast<double>(prng.below(static_cast<std::uint64_t>(side))) / 2;
    p.y = static_cast<double>(prng.below(static_cast<std::uint64_t>(side))) / 2;
  }
  return plane;
}

TEST(SlabEngine, AgreesOnScatteredPoints) {
  Prng prng(51);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    Points points = uniform(8 + prng.below(200), prng);
    for (Point3& p : points) p.z = p.z < 0.5 ? -3 : 1e-4;
    EXPECT_TRUE(expect_engines_agree(points));
  }
}

TEST(SlabEngine, AgreesOnPixelGrids) {
  Prng prng(52);
  int taken = 0;
  for (int round = 0; round < 1500; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int side = 2 + static_cast<int>(prng.below(7));
    Points points;
    append_plane(points, pixels(3 + prng.below(30), side, prng), 0);
    append_plane(points, pixels(3 + prng.below(30), side, prng), 2);
    taken += expect_engines_agree(points) ? 1 : 0;
  }
  EXPECT_GT(taken, 1000);
}

TEST(SlabEngine, AgreesOnEqualSections) {
  Prng prng(53);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const std::vector<Point2> plane =
        pixels(4 + prng.below(40), 3 + static_cast<int>(prng.below(8)), prng);
    Points points;
    append_plane(points, plane, 0);
    append_plane(points, plane, 1);
    expect_engines_agree(points);
  }
  EXPECT_TRUE(expect_engines_agree(lattice(9, 7, 2)));
}

TEST(SlabEngine, AgreesOnPolygonsTurnedAndShifted) {
  // Regular polygons: cocircular up to rounding, and with parallel hull edges.
  for (const int corners : {3, 4, 6, 16, 64}) {
    for (const double turn : {0.0, 0.5, 0.3}) {
      for (const double shift : {0.0, 1e-15, 0.25, 3.0}) {
        Points points;
        for (int plane = 0; plane < 2; ++plane) {
          for (int i = 0; i < corners; ++i) {
            const double angle = (i + plane * turn) * 6.283185307179586 / corners;
            points.push_back({std::cos(angle) + plane * shift, std::sin(angle), 1.0 * plane});
          }
        }
        EXPECT_TRUE(expect_engines_agree(points)) << corners << ' ' << turn << ' ' << shift;
      }
    }
  }
}

TEST(SlabEngine, AgreesFarOutAndAtTheLimitsOfDoubles) {
  Prng prng(54);
  for (const double scale : {1e-300, 1e-150, 1e-60, 1e60, 1e120, 1e150, 1e300}) {
    for (int round = 0; round < 10; ++round) {
      SCOPED_TRACE(testing::Message() << "scale " << scale << " round " << round);
      Points points;
      append_plane(points, pixels(12, 6, prng), 0);
      append_plane(points, pixels(12, 6, prng), 1);
      if (round % 2 == 0) {
        for (Point3& p : points) p.x += 0.1 * prng.unit();
      }
      for (Point3& p : points) p = {p.x * scale, p.y * scale, p.z};
      expect_engines_agree(points);
    }
  }
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE(testing::Message() << "offset, round " << round);
    Points points;
    append_plane(points, pixels(20, 6, prng), 0);
    append_plane(points, pixels(20, 6, prng), 1);
    for (Point3& p : points) p = {p.x * 1e-6 + 1e9, p.y * 1e-6 - 1e9, p.z};
    expect_engines_agree(points);
  }
}

TEST(SlabEngine, AgreesOnNearlyEqualSections) {
  Prng prng(55);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const std::vector<Point2> plane = pixels(20, 6, prng);
    Points points;
    append_plane(points, plane, 0);
    for (const Point2& p : plane) {
      const double jitter = std::ldexp(prng.unit() - 0.5, -static_cast<int>(prng.below(54)));
      points.push_back({p.x + jitter, p.y - jitter / 3, 1});
    }
    expect_engines_agree(points);
  }
}

TEST(SlabEngine, AgreesOnManyPoints) {
  // Enough for diagrams that renumber their triangles.
  Prng prng(56);
  Points scattered = uniform(12000, prng);
  for (Point3& p : scattered) p.z = p.z < 0.5 ? 0 : 1;
  EXPECT_TRUE(expect_engines_agree(scattered));
  Points grid;
  append_plane(grid, pixels(7000, 150, prng), 0);
  append_plane(grid, pixels(7000, 150, prng), 1);
  EXPECT_TRUE(expect_engines_agree(grid));
}

TEST(SlabEngine, AgreesWithBruteForce) {
  Prng prng(57);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    Points points;
    append_plane(points, pixels(7, 4, prng), 0);
    append_plane(points, pixels(7, 4, prng), 1);
    expect_brute_force(points);
  }
}

TEST(SlabEngine, TakesNamedPointsInAnyOrder) {
  Prng prng(58);
  Points points;
  append_plane(points, pixels(30, 9, prng), 5);
  append_plane(points, pixels(30, 9, prng), -5);
  points.push_back(points.front());
  expect_delaunay(points);
  EXPECT_EQ(triangulate(points).engine, DelaunayEngine::slab);
  EXPECT_GE(triangulate(points).duplicates, 1U);
}

TEST(SlabEngine, RefusesWhatIsNotTwoPlanesWithTriangles) {
  const auto refused = [](const Points& points) {
    const Result<Delaunay3> result = delaunay3(points, {.engine = DelaunayEngine::slab});
    return !result && result.error().code == ErrorCode::invalid_input;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused(lattice(3, 3, 1)));
  EXPECT_TRUE(refused(lattice(3, 3, 3)));
  Points row = lattice(3, 3, 1);
  for (int i = 0; i < 4; ++i) row.push_back({1.0 * i, 2.0 * i, 1});
  EXPECT_TRUE(refused(row));
  EXPECT_EQ(triangulate(row).engine, DelaunayEngine::incremental);
  EXPECT_EQ(triangulate(lattice(3, 3, 3)).engine, DelaunayEngine::incremental);
}

TEST(SlabDelaunay3, IsDelaunay3OfBothPlanes) {
  Prng prng(59);
  const auto plane = [&] {
    Points points = uniform(50, prng);
    std::vector<Point2> sorted;
    for (const Point3& p : points) sorted.push_back({p.x, p.y});
    std::sort(sorted.begin(), sorted.end(),
              [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
    return sorted;
  };
  const std::vector<Point2> lower = plane();
  const std::vector<Point2> upper = plane();
  const auto mesh = slab_delaunay3(*delaunay2(lower), *delaunay2(upper));
  ASSERT_TRUE(mesh.ok());
  for (const double gap : {1e-9, 1.0, 1e9}) {
    Points points;
    append_plane(points, lower, 0);
    append_plane(points, upper, gap);
    const Delaunay3 d = triangulate_by(DelaunayEngine::incremental, points);
    EXPECT_EQ(tets_of(*mesh), tets_of(d.mesh));
    EXPECT_EQ(opposites_of(*mesh), opposites_of(d.mesh));
  }
}

Triangulation2 plane_of(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Result<Triangulation2> plane = delaunay2(points);
  if (!plane) throw std::runtime_error(to_string(plane.error()));
  return *std::move(plane);
}

// The vertices that a base has in its plane, as the slab numbers them, appended to `corners`.
void append_base(const Triangulation2& plane, delaunay3_detail::TriangleSideId side,
                 bool whole_triangle, std::size_t first, std::vector<VertexId>& corners) {
  if (!side.valid()) return;
  const PlaneTriangleVertices& v = plane.triangles[delaunay3_detail::triangle_of(side)];
  const std::size_t number = delaunay3_detail::side_number(side);
  for (std::size_t i = 0; i < 3; ++i) {
    if (whole_triangle || i != number) corners.emplace_back(first + v[i].index());
  }
}

// Edges have the places of their ends among those of all edges, sorted.
void expect_edges_in_order(const Triangulation2& plane,
                           const delaunay3_detail::EdgesOfSides& edges) {
  ASSERT_EQ(edges.size(), plane.triangles.size());
  std::map<std::array<PlaneVertexId, 2>, EdgeId> edge_of;
  for (const TriangleId t : plane.triangles.ids()) {
    const PlaneTriangleVertices& v = plane.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(v[(i + 1) % 3], v[(i + 2) % 3]);
      const auto known = edge_of.emplace(std::array{low, high}, edges[t][i]).first;
      ASSERT_EQ(known->second, edges[t][i]);
    }
  }
  std::size_t place = 0;
  for (const auto& [ends, edge] : edge_of) ASSERT_EQ(edge.index(), place++);
}

void expect_bases(const Triangulation2& lower, const Triangulation2& upper) {
  const Execution execution;
  const WatchedWork work(execution, 0);
  const auto slab = delaunay3_detail::slab_overlay_with_bases(lower, upper, work);
  ASSERT_TRUE(slab.has_value());
  ASSERT_EQ(slab->base.size(), slab->mesh.tet_slots());
  std::size_t type1_count = 0;
  for (const TetId t : slab->base.ids()) {
    const auto& [below, above] = slab->base[t];
    const bool type1 = below.valid() != above.valid();
    if (type1) ++type1_count;
    std::vector<VertexId> corners;
    append_base(lower, below, type1, 0, corners);
    append_base(upper, above, type1, lower.points.size(), corners);
    std::sort(corners.begin(), corners.end());
    TetVertices tet = slab->mesh.vertices(t);
    std::sort(tet.begin(), tet.end());
    ASSERT_TRUE(std::includes(tet.begin(), tet.end(), corners.begin(), corners.end())) << t.value();
    ASSERT_EQ(corners.size(), type1 ? 3U : 4U) << t.value();
  }
  EXPECT_EQ(type1_count, lower.triangles.size() + upper.triangles.size());
  expect_edges_in_order(lower, slab->edges[0]);
  expect_edges_in_order(upper, slab->edges[1]);
}

TEST(SlabOverlay, NamesTheTriangleOrTheEdgesOfEveryTet) {
  Prng prng(60);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    expect_bases(plane_of(pixels(20, 8, prng)), plane_of(pixels(20, 8, prng)));
  }
  // Enough for diagrams that renumber their triangles.
  expect_bases(plane_of(pixels(7000, 150, prng)), plane_of(pixels(7000, 150, prng)));
}

TEST(SlabDelaunay3, RefusesTrianglesOutOfOrder) {
  const Triangulation2 good = plane_of({{0, 0}, {0, 2}, {1, 1}, {2, 0}, {2, 2}});
  ASSERT_GE(good.triangles.size(), 2U);
  EXPECT_TRUE(slab_delaunay3(good, good).ok());
  // The first two exchange their numbers, everywhere.
  Triangulation2 exchanged = good;
  std::swap(exchanged.triangles[TriangleId(0)], exchanged.triangles[TriangleId(1)]);
  std::swap(exchanged.neighbours[TriangleId(0)], exchanged.neighbours[TriangleId(1)]);
  for (auto& neighbours : exchanged.neighbours) {
    for (TriangleId& n : neighbours) {
      if (n.valid() && n.index() < 2) n = TriangleId(1 - n.index());
    }
  }
  EXPECT_FALSE(slab_delaunay3(good, exchanged).ok());
}

TEST(SlabDelaunay3, RefusesPlanesThatAreNoInput) {
  const std::vector<Point2> sorted{{0, 0}, {0, 1}, {1, 0}};
  const std::vector<Point2> unsorted{{1, 0}, {0, 1}, {0, 0}};
  const auto good = delaunay2(sorted);
  const auto bad = delaunay2(unsorted);
  EXPECT_TRUE(slab_delaunay3(*good, *good).ok());
  const auto refusal = slab_delaunay3(*good, *bad);
  ASSERT_FALSE(refusal.ok());
  EXPECT_EQ(refusal.error().where.vertex, 1U);
  EXPECT_FALSE(slab_delaunay3(Triangulation2{}, *good).ok());
  Triangulation2 cut = *good;
  cut.neighbours.clear();
  EXPECT_FALSE(slab_delaunay3(cut, *good).ok());
  Triangulation2 turned = *good;
  std::rotate(turned.triangles[TriangleId(0)].begin(), turned.triangles[TriangleId(0)].begin() + 1,
              turned.triangles[TriangleId(0)].end());
  EXPECT_FALSE(slab_delaunay3(*good, turned).ok());
}

}  // namespace
}  // namespace tetloft::test
