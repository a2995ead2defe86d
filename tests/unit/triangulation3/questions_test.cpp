// Where points lie, what is near, what an insertion would change; values and handles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <span>

#include <tetloft/delaunay3.hpp>
#include <tetloft/predicates.hpp>

#include "support.hpp"

namespace tetloft::test {
namespace {

// Squared distances of points with few bits are exact.
double squared(const Point3& a, const Point3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

Point3 few_bits(Prng& prng) {
  const auto c = [&] { return static_cast<double>(prng.below(64)) / 8; };
  return {c(), c(), c()};
}

std::vector<Point3> small_lattice() {
  std::vector<Point3> points;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      for (int z = 0; z < 6; ++z) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  return points;
}

// Sets of every dimension whose distances are exact in doubles.
std::vector<std::vector<Point3>> sets_of_few_bits() {
  std::vector<std::vector<Point3>> sets{small_lattice(), {{1, 2, 3}}, {}};
  Prng prng(5);
  for (int kind = 0; kind < 4; ++kind) {
    std::vector<Point3> points;
    for (int i = 0; i < 150; ++i) {
      Point3 p = few_bits(prng);
      if (kind == 1) p.z = 2;
      if (kind == 2) p = {p.x, 2 * p.x, 4 - p.x};
      if (kind == 3) p = {std::floor(p.x / 4), std::floor(p.y / 4), std::floor(p.z / 4)};
      points.push_back(p);
    }
    sets.push_back(points);
  }
  return sets;
}

TEST(Questions, ManyAtOnceHaveTheAnswersOfEachAlone) {
  const auto simplex_of = [](const Location3& at) { return at.tet; };
  for (const std::vector<Point3>& points : sets_of_few_bits()) {
    SCOPED_TRACE(testing::Message() << points.size() << " points");
    const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
    Prng prng(16);
    std::vector<Point3> queries;
    for (int i = 0; i < 2600; ++i) queries.push_back(few_bits(prng));
    expect_answers_of_each(t, queries, simplex_of);
  }
}

TEST(Questions, NearestVerticesAreThoseOfAllByDistanceThenIndex) {
  for (const std::vector<Point3>& points : sets_of_few_bits()) {
    SCOPED_TRACE(testing::Message() << points.size() << " points");
    const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
    Prng prng(6);
    for (int round = 0; round < 60; ++round) {
      Point3 p = few_bits(prng);
      if (round % 4 == 0) p = {p.x * 3 - 8, p.y - 20, p.z};
      if (round % 4 == 1) p = {std::floor(p.x) + 0.5, std::floor(p.y) + 0.5, std::floor(p.z) + 0.5};
      expect_nearest_of_all(t, p, squared, prng);
    }
  }
}

TEST(Questions, LocateNamesTheSmallestSimplex) {
  const std::vector<Point3> points = small_lattice();
  const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
  Prng prng(8);
  std::array<int, 5> seen{};
  for (int round = 0; round < 400; ++round) {
    const auto c = [&] { return static_cast<double>(prng.below(25)) / 4 - 0.5; };
    const Point3 p{c(), c(), c()};
    const Location3 at = value_of(t.locate(p));
    ++seen[static_cast<std::size_t>(at.kind)];
    const bool inside = std::min({p.x, p.y, p.z}) >= 0 && std::max({p.x, p.y, p.z}) <= 5;
    ASSERT_EQ(at.kind != LocationKind::outside, inside);
    if (!inside) {
      EXPECT_FALSE(at.tet.valid() || at.vertices[0].valid());
      continue;
    }
    const auto corners = t.vertices(at.tet);
    std::size_t used = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      // Replaced by p, the corner's tet is flat iff the corner has no part in p.
      auto moved = std::array{t.point(corners[0]), t.point(corners[1]), t.point(corners[2]),
                              t.point(corners[3])};
      moved[i] = p;
      const Sign s = orient3d(moved[0], moved[1], moved[2], moved[3]);
      EXPECT_NE(s, Sign::negative);
      const bool named =
          std::find(at.vertices.begin(), at.vertices.end(), corners[i]) != at.vertices.end();
      EXPECT_EQ(named, s == Sign::positive);
      used += named ? 1 : 0;
    }
    constexpr std::array<std::size_t, 5> kVertices{1, 2, 3, 4, 0};
    EXPECT_EQ(used, kVertices[static_cast<std::size_t>(at.kind)]);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 0);
}

TEST(Questions, LocateKnowsPlanesAndLines) {
  const std::vector<Point3> square{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
  DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(square));
  EXPECT_EQ(value_of(t.locate({1, 0.5, 1})).kind, LocationKind::facet);
  EXPECT_EQ(value_of(t.locate({2, 0, 1})).kind, LocationKind::edge);
  EXPECT_EQ(value_of(t.locate({4, 4, 1})).kind, LocationKind::vertex);
  EXPECT_EQ(value_of(t.locate({1, 1, 1.5})).kind, LocationKind::outside);
  EXPECT_EQ(value_of(t.locate({5, 1, 1})).kind, LocationKind::outside);
  succeed(t.remove(t.vertex_at(1)));
  succeed(t.remove(t.vertex_at(3)));
  EXPECT_EQ(t.dimension(), 1);
  EXPECT_EQ(value_of(t.locate({1, 1, 1})).kind, LocationKind::edge);
  EXPECT_EQ(value_of(t.locate({1, 1.5, 1})).kind, LocationKind::outside);
}

TEST(Questions, ConflictZoneIsWhatInsertionChanges) {
  for (const PointSource& source : point_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(9);
    DelaunayTriangulation3 t;
    for (int i = 0; i < 50; ++i) (void)value_of(t.insert(source.draw(prng)));
    for (int round = 0; round < 30; ++round) {
      Point3 p = source.draw(prng);
      if (round % 3 == 0) p = {p.x + 0.25, p.y + 0.5, p.z - 0.5};
      const ConflictZone3 zone = value_of(t.conflict_zone(p));
      DelaunayTriangulation3 with = t;
      const auto made = value_of(with.insert(p));
      if (!made.is_new || t.dimension() < 3) {
        EXPECT_TRUE(zone.tets.empty() && zone.horizon.empty());
        if (!made.is_new) continue;
        t = with;
        continue;
      }
      EXPECT_EQ(with.neighbours(made.vertex), zone.neighbours);
      EXPECT_EQ(with.star(made.vertex).size(), zone.horizon.size());
      EXPECT_EQ(with.tet_count(), t.tet_count() - zone.tets.size() + zone.horizon.size());
    }
  }
}

TEST(Questions, RingsTurnAroundTheirEdge) {
  const std::vector<Point3> points = small_lattice();
  const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
  std::size_t closed = 0;
  std::size_t tets = 0;
  for (const auto& [u, v] : t.edges()) {
    const EdgeRing ring = t.ring(u, v);
    closed += ring.closed ? 1 : 0;
    tets += ring.tets.size();
    for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < ring.tets.size(); ++i) {
      const TetId next = ring.tets[(i + 1) % ring.tets.size()];
      bool joined = false;
      for (std::uint32_t f = 0; f < 4; ++f) {
        const HalfFaceId across = t.opposite(HalfFaceId(4 * ring.tets[i].value() + f));
        joined = joined || (across.valid() && TetMesh::tet_of(across) == next);
      }
      ASSERT_TRUE(joined);
    }
  }
  EXPECT_GT(closed, 0U);
  EXPECT_LT(closed, t.edges().size());
  EXPECT_EQ(tets, 6 * t.tet_count());
  EXPECT_TRUE(t.ring(t.vertex_at(0), t.vertex_at(215)).tets.empty());
}

TEST(Questions, HullFacetsAndVerticesOnItAreThoseOfTheBox) {
  const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(small_lattice()));
  EXPECT_EQ(t.hull().size(), 6U * 2 * 25);
  for (const DelaunayVertex v : t.vertices()) {
    const Point3& p = t.point(v);
    EXPECT_EQ(t.is_on_hull(v), std::min({p.x, p.y, p.z}) == 0 || std::max({p.x, p.y, p.z}) == 5);
  }
}

TEST(Handles, OfRemovedVerticesNameNothing) {
  DelaunayTriangulation3 t;
  const DelaunayVertex a = value_of(t.insert({0, 0, 0})).vertex;
  const DelaunayVertex b = value_of(t.insert({1, 0, 0})).vertex;
  succeed(t.remove(a));
  EXPECT_FALSE(t.is_live(a));
  EXPECT_EQ(t.remove(a).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(t.move(a, {4, 4, 4}).error().code, ErrorCode::invalid_input);
  EXPECT_THROW((void)t.point(a), std::out_of_range);
  EXPECT_THROW((void)t.star(a), std::out_of_range);
  EXPECT_THROW((void)t.vertices(TetId(0)), std::out_of_range);
  EXPECT_THROW((void)t.vertex_at(99), std::out_of_range);
  const DelaunayVertex c = value_of(t.insert({2, 0, 0})).vertex;
  EXPECT_EQ(c.index, a.index);
  EXPECT_NE(c, a);
  EXPECT_TRUE(t.is_live(b));
  DelaunayVertexMap<int> map;
  map[a] = 7;
  map[c] = 9;
  EXPECT_EQ(map.find(a), nullptr);
  EXPECT_EQ(*map.find(c), 9);
  EXPECT_EQ(map.find(b), nullptr);
}

TEST(Handles, AreTheIndicesOfPointsAtFirst) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 0},
                                   {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
  EXPECT_EQ(t.vertex_slots(), 6U);
  EXPECT_EQ(t.vertex_count(), 4U);
  EXPECT_FALSE(t.vertex_at(2).valid() || t.vertex_at(5).valid());
  EXPECT_EQ(t.vertex_at(4), (DelaunayVertex{4, 0}));
}

TEST(Triangulation3, RefusesWhatIsNotFinite) {
  DelaunayTriangulation3 t;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(t.insert({inf, 0, 0}).error().code, ErrorCode::invalid_input);
  const std::vector<Point3> points{{0, 0, 0}, {0, std::nan(""), 0}};
  EXPECT_EQ(t.insert(points).error().where.vertex, 1U);
  EXPECT_EQ(DelaunayTriangulation3::of(points).error().where.vertex, 1U);
  EXPECT_FALSE(t.locate({0, inf, 0}).ok());
  EXPECT_FALSE(t.vertices_within({0, 0, 0}, -1).ok());
  EXPECT_EQ(t.vertex_count(), 0U);
}

TEST(Triangulation3, StopsWhenAskedAndStaysAsItWas) {
  Prng prng(3);
  std::vector<Point3> points;
  for (int i = 0; i < 5000; ++i) points.push_back({prng.unit(), prng.unit(), prng.unit()});
  DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(std::span(points).first(100)));
  std::stop_source stop;
  const Execution execution{.threads = 1,
                            .stop = stop.get_token(),
                            .progress = [&](std::size_t done, std::size_t /*all*/) {
                              if (done == 2) stop.request_stop();
                            }};
  EXPECT_EQ(t.insert(points, execution).error().code, ErrorCode::cancelled);
  EXPECT_EQ(t.vertex_count(), 100U);
  EXPECT_TRUE(equals_batch(t));
  EXPECT_EQ(value_of(t.insert({9, 9, 9})).vertex, (DelaunayVertex{100, 0}));
}

TEST(Triangulation3, CopiesMovesAndSwaps) {
  Prng prng(4);
  DelaunayTriangulation3 t;
  for (int i = 0; i < 40; ++i) {
    (void)value_of(t.insert({prng.unit(), prng.unit(), prng.unit()}));
  }
  DelaunayTriangulation3 copy = t;
  for (int i = 0; i < 20; ++i) succeed(copy.remove(copy.vertex_at(static_cast<std::size_t>(i))));
  EXPECT_TRUE(equals_batch(copy));
  EXPECT_TRUE(equals_batch(t));
  EXPECT_EQ(t.vertex_count(), 40U);
  swap(t, copy);
  EXPECT_EQ(t.vertex_count(), 20U);
  DelaunayTriangulation3 moved = std::move(t);
  EXPECT_EQ(moved.vertex_count(), 20U);
  EXPECT_TRUE(equals_batch(moved));
  t = copy;
  EXPECT_EQ(t.vertex_count(), 40U);
  t.clear();
  EXPECT_EQ(t.vertex_count(), 0U);
  EXPECT_FALSE(value_of(t.nearest_vertex({0, 0, 0})).valid());
}

TEST(Triangulation3, ComesBackFromItsBytesWithItsHandles) {
  for (const PointSource& source : point_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(12);
    DelaunayTriangulation3 t;
    for (int i = 0; i < 60; ++i) {
      const auto made = value_of(t.insert(source.draw(prng)));
      if (prng.chance(0.3)) succeed(t.remove(made.vertex));
    }
    std::vector<std::byte> bytes = value_of(t.serialise());
    DelaunayTriangulation3 back = value_of(DelaunayTriangulation3::deserialise(bytes));
    EXPECT_EQ(live_vertices(back), live_vertices(t));
    EXPECT_TRUE(equals_batch(back));
    EXPECT_EQ(value_of(back.serialise()), bytes);
    const Point3 p{100, 101, 103};
    EXPECT_EQ(value_of(back.insert(p)).vertex, value_of(t.insert(p)).vertex);
    // Damage is seen, wherever it is.
    bytes[prng.below(bytes.size())] ^= std::byte{4};
    EXPECT_EQ(DelaunayTriangulation3::deserialise(bytes).error().code, ErrorCode::invalid_input);
    bytes.resize(bytes.size() / 2);
    EXPECT_FALSE(DelaunayTriangulation3::deserialise(bytes).ok());
  }
  EXPECT_FALSE(DelaunayTriangulation3::deserialise({}).ok());
}

TEST(Triangulation3, SnapshotIsTheBatch) {
  Prng prng(13);
  DelaunayTriangulation3 t;
  for (int i = 0; i < 80; ++i) (void)value_of(t.insert(few_bits(prng)));
  succeed(t.remove(t.vertex_at(5)));
  const DelaunaySnapshot3 s = value_of(t.snapshot());
  EXPECT_EQ(s.points.size(), t.vertex_count());
  EXPECT_EQ(s.vertex.raw(), live_vertices(t));
  EXPECT_EQ(s.mesh.tet_count(), t.tet_count());
}

TEST(Triangulation3, RangesAreOnesOfTheLanguage) {
  static_assert(std::ranges::forward_range<decltype(DelaunayTriangulation3().vertices())>);
  static_assert(std::ranges::forward_range<decltype(DelaunayTriangulation3().tets())>);
  DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(small_lattice()));
  for (std::size_t i = 0; i < 216; i += 2) succeed(t.remove(t.vertex_at(i)));
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::distance(t.vertices())), t.vertex_count());
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::distance(t.tets())), t.tet_count());
  EXPECT_TRUE(std::ranges::is_sorted(t.vertices()));
}

}  // namespace
}  // namespace tetloft::test
