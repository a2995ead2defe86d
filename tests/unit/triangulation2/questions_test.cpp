// Where points lie and what is near; values and handles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <thread>

#include <tetloft/predicates.hpp>

#include "support.hpp"

namespace tetloft::test {
namespace {

// Squared distances of points with few bits are exact.
double squared(const Point2& a, const Point2& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y;
}

Point2 few_bits(Prng& prng) {
  const auto c = [&] { return static_cast<double>(prng.below(64)) / 8; };
  return {c(), c()};
}

std::vector<Point2> small_lattice() {
  std::vector<Point2> points;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) points.push_back({1.0 * x, 1.0 * y});
  }
  return points;
}

// Sets of every dimension whose distances are exact in doubles.
std::vector<std::vector<Point2>> sets_of_few_bits() {
  std::vector<std::vector<Point2>> sets{small_lattice(), {{1, 2}}, {}};
  Prng prng(5);
  for (int kind = 0; kind < 3; ++kind) {
    std::vector<Point2> points;
    for (int i = 0; i < 150; ++i) {
      Point2 p = few_bits(prng);
      if (kind == 1) p = {p.x, 2 * p.x};
      if (kind == 2) p = {std::floor(p.x / 4), std::floor(p.y / 4)};
      points.push_back(p);
    }
    sets.push_back(points);
  }
  return sets;
}

// With constraints and without.
TEST(Questions, ManyAtOnceHaveTheAnswersOfEachAlone) {
  const auto simplex_of = [](const Location2& at) { return at.triangle; };
  for (const std::vector<Point2>& points : sets_of_few_bits()) {
    SCOPED_TRACE(testing::Message() << points.size() << " points");
    DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
    Prng prng(16);
    std::vector<Point2> queries;
    for (int i = 0; i < 2600; ++i) queries.push_back(few_bits(prng));
    expect_answers_of_each(t, queries, simplex_of);
    if (t.vertex_count() < 2) continue;
    ASSERT_TRUE(t.insert_constraint(t.hull().front(), t.hull().back()).ok());
    expect_answers_of_each(t, queries, simplex_of);
  }
}

TEST(Questions, NearestVerticesAreThoseOfAllByDistanceThenIndex) {
  for (const std::vector<Point2>& points : sets_of_few_bits()) {
    SCOPED_TRACE(testing::Message() << points.size() << " points");
    const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
    Prng prng(6);
    for (int round = 0; round < 60; ++round) {
      Point2 p = few_bits(prng);
      if (round % 4 == 0) p = {p.x * 3 - 8, p.y - 20};
      if (round % 4 == 1) p = {std::floor(p.x) + 0.5, std::floor(p.y) + 0.5};
      expect_nearest_of_all(t, p, squared, prng);
    }
  }
}

TEST(Questions, LocateNamesTheSmallestSimplex) {
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(small_lattice()));
  Prng prng(8);
  std::array<int, 5> seen{};
  for (int round = 0; round < 400; ++round) {
    const auto c = [&] { return static_cast<double>(prng.below(49)) / 4 - 0.5; };
    const Point2 p{c(), c()};
    const Location2 at = value_of(t.locate(p));
    ++seen[static_cast<std::size_t>(at.kind)];
    const bool inside = std::min(p.x, p.y) >= 0 && std::max(p.x, p.y) <= 11;
    ASSERT_EQ(at.kind != LocationKind::outside, inside);
    if (!inside) {
      EXPECT_FALSE(at.triangle.valid() || at.vertices[0].valid());
      continue;
    }
    const auto corners = t.vertices(at.triangle);
    std::size_t used = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      // Replaced by p, the corner's triangle is flat iff the corner has no part in p.
      auto moved = std::array{t.point(corners[0]), t.point(corners[1]), t.point(corners[2])};
      moved[i] = p;
      const Sign s = orient2d(moved[0], moved[1], moved[2]);
      EXPECT_NE(s, Sign::negative);
      const bool named =
          std::find(at.vertices.begin(), at.vertices.end(), corners[i]) != at.vertices.end();
      EXPECT_EQ(named, s == Sign::positive);
      used += named ? 1 : 0;
    }
    constexpr std::array<std::size_t, 5> kVertices{1, 2, 3, 4, 0};
    EXPECT_EQ(used, kVertices[static_cast<std::size_t>(at.kind)]);
  }
  seen[static_cast<std::size_t>(LocationKind::tet)] = 1;
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 0);
}

TEST(Questions, SidesOfEdgesAreTheTrianglesThatHaveThem) {
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(small_lattice()));
  std::size_t sides = 0;
  for (const auto& [u, v] : t.edges()) {
    const std::array<TriangleId, 2> there = t.triangles(u, v);
    const std::array<TriangleId, 2> back = t.triangles(v, u);
    EXPECT_EQ(there[0], back[1]);
    EXPECT_EQ(there[1], back[0]);
    EXPECT_TRUE(there[0].valid() || there[1].valid());
    if (!there[0].valid()) continue;
    ++sides;
    const auto w = t.vertices(there[0]);
    const auto at = static_cast<std::size_t>(std::find(w.begin(), w.end(), u) - w.begin());
    ASSERT_LT(at, 3U);
    EXPECT_EQ(w[(at + 1) % 3], v);
    sides += there[1].valid() ? 1U : 0U;
  }
  EXPECT_LT(sides, 3 * t.triangle_count());
  const std::array<TriangleId, 2> none = t.triangles(t.vertex_at(0), t.vertex_at(143));
  EXPECT_FALSE(none[0].valid() || none[1].valid());
  EXPECT_THROW((void)t.triangles(t.vertex_at(0), {}), std::out_of_range);
}

TEST(Questions, LocateKnowsRows) {
  DelaunayTriangulation2 t;
  EXPECT_EQ(value_of(t.locate({0, 0})).kind, LocationKind::outside);
  for (const Point2& p : {Point2{0, 0}, {4, 4}, {2, 2}}) (void)value_of(t.insert(p));
  EXPECT_EQ(t.dimension(), 1);
  EXPECT_EQ(value_of(t.locate({1, 1})).kind, LocationKind::edge);
  EXPECT_EQ(value_of(t.locate({1, 1})).vertices[1].index, 2U);
  EXPECT_EQ(value_of(t.locate({2, 2})).kind, LocationKind::vertex);
  EXPECT_EQ(value_of(t.locate({1, 1.5})).kind, LocationKind::outside);
  EXPECT_EQ(value_of(t.locate({5, 5})).kind, LocationKind::outside);
}

// The filter of pixels is exact for its own points: others must not be taken for such.
TEST(Questions, PointsOffTheGridAreLocatedToo) {
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(small_lattice()));
  Prng prng(10);
  for (int round = 0; round < 300; ++round) {
    const double x = 1.0 + static_cast<double>(prng.below(8));
    const Point2 p{x, std::nextafter(x, prng.chance(0.5) ? 0.0 : 99.0)};
    const Location2 at = value_of(t.locate(p));
    ASSERT_TRUE(at.kind == LocationKind::edge || at.kind == LocationKind::facet);
    const auto v = t.vertices(at.triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NE(orient2d(t.point(v[i]), t.point(v[(i + 1) % 3]), p), Sign::negative);
    }
  }
}

TEST(Handles, OfRemovedVerticesNameNothing) {
  DelaunayTriangulation2 t;
  const DelaunayVertex a = value_of(t.insert({0, 0})).vertex;
  const DelaunayVertex b = value_of(t.insert({1, 0})).vertex;
  succeed(t.remove(a));
  EXPECT_FALSE(t.is_live(a));
  EXPECT_EQ(t.remove(a).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(t.move(a, {4, 4}).error().code, ErrorCode::invalid_input);
  EXPECT_THROW((void)t.point(a), std::out_of_range);
  EXPECT_THROW((void)t.star(a), std::out_of_range);
  EXPECT_THROW((void)t.vertices(TriangleId(0)), std::out_of_range);
  EXPECT_THROW((void)t.vertex_at(99), std::out_of_range);
  const DelaunayVertex c = value_of(t.insert({2, 0})).vertex;
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
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}};
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  EXPECT_EQ(t.vertex_slots(), 5U);
  EXPECT_EQ(t.vertex_count(), 3U);
  EXPECT_FALSE(t.vertex_at(2).valid() || t.vertex_at(4).valid());
  EXPECT_EQ(t.vertex_at(3), (DelaunayVertex{3, 0}));
}

TEST(Triangulation2, RefusesWhatIsNotFinite) {
  DelaunayTriangulation2 t;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(t.insert({inf, 0}).error().code, ErrorCode::invalid_input);
  const std::vector<Point2> points{{0, 0}, {0, std::nan("")}};
  EXPECT_EQ(t.insert(points).error().where.vertex, 1U);
  EXPECT_EQ(DelaunayTriangulation2::of(points).error().where.vertex, 1U);
  EXPECT_FALSE(t.locate({0, inf}).ok());
  EXPECT_FALSE(t.vertices_within({0, 0}, -1).ok());
  EXPECT_EQ(t.vertex_count(), 0U);
}

TEST(Triangulation2, StopsWhenAskedAndStaysAsItWas) {
  Prng prng(3);
  std::vector<Point2> points;
  for (int i = 0; i < 20000; ++i) points.push_back({prng.unit(), prng.unit()});
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(std::span(points).first(100)));
  std::stop_source stop;
  const Execution execution{.threads = 1,
                            .stop = stop.get_token(),
                            .progress = [&](std::size_t done, std::size_t /*all*/) {
                              if (done == 2) stop.request_stop();
                            }};
  EXPECT_EQ(t.insert(points, execution).error().code, ErrorCode::cancelled);
  EXPECT_EQ(t.vertex_count(), 100U);
  EXPECT_TRUE(equals_batch(t));
  EXPECT_EQ(value_of(t.insert({9, 9})).vertex, (DelaunayVertex{100, 0}));
}

TEST(Triangulation2, CopiesMovesAndSwaps) {
  Prng prng(4);
  DelaunayTriangulation2 t;
  for (int i = 0; i < 40; ++i) {
    (void)value_of(t.insert({prng.unit(), prng.unit()}));
  }
  DelaunayTriangulation2 copy = t;
  for (int i = 0; i < 20; ++i) succeed(copy.remove(copy.vertex_at(static_cast<std::size_t>(i))));
  EXPECT_TRUE(equals_batch(copy));
  EXPECT_TRUE(equals_batch(t));
  EXPECT_EQ(t.vertex_count(), 40U);
  swap(t, copy);
  EXPECT_EQ(t.vertex_count(), 20U);
  DelaunayTriangulation2 moved = std::move(t);
  EXPECT_EQ(moved.vertex_count(), 20U);
  EXPECT_TRUE(equals_batch(moved));
  t = copy;
  EXPECT_EQ(t.vertex_count(), 40U);
  t.clear();
  EXPECT_EQ(t.vertex_count(), 0U);
  EXPECT_FALSE(value_of(t.nearest_vertex({0, 0})).valid());
}

TEST(Triangulation2, SnapshotIsTheBatch) {
  Prng prng(13);
  DelaunayTriangulation2 t;
  for (int i = 0; i < 80; ++i) (void)value_of(t.insert(few_bits(prng)));
  succeed(t.remove(t.vertex_at(5)));
  const DelaunaySnapshot2 s = value_of(t.snapshot());
  EXPECT_EQ(s.dimension, 2);
  EXPECT_EQ(s.vertex.raw(), live_vertices(t));
  EXPECT_EQ(s.triangulation.triangles.size(), t.triangle_count());
  for (const PlaneVertexId v : s.vertex.ids()) {
    EXPECT_EQ(s.triangulation.points[v], t.point(s.vertex[v]));
  }
}

TEST(Triangulation2, RangesAreOnesOfTheLanguage) {
  static_assert(std::ranges::forward_range<decltype(DelaunayTriangulation2().vertices())>);
  static_assert(std::ranges::forward_range<decltype(DelaunayTriangulation2().triangles())>);
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(small_lattice()));
  for (std::size_t i = 0; i < 144; i += 2) succeed(t.remove(t.vertex_at(i)));
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::distance(t.vertices())), t.vertex_count());
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::distance(t.triangles())), t.triangle_count());
  EXPECT_TRUE(std::ranges::is_sorted(t.vertices()));
}

TEST(Triangulation2, AnswersSeveralThreadsAtOnce) {
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(small_lattice()));
  std::vector<std::vector<DelaunayVertex>> answers(4);
  std::vector<std::thread> threads;
  for (auto& answer : answers) {
    threads.emplace_back([&] {
      Prng prng(21);
      for (int i = 0; i < 200; ++i) {
        const Point2 p = few_bits(prng);
        answer.push_back(value_of(t.nearest_vertex(p)));
        answer.push_back(value_of(t.locate(p)).vertices[0]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& answer : answers) EXPECT_EQ(answer, answers[0]);
}

}  // namespace
}  // namespace tetloft::test
