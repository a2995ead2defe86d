// After any history a triangulation is that of the points that are left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace tetloft::test {
namespace {

// One random operation.
void change(DelaunayTriangulation2& t, const PlaneSource& source, Prng& prng) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  const std::uint64_t draw = prng.below(10);
  if (live.empty() || draw < 5) {
    const Point2 p = source.draw(prng);
    const bool was_there =
        std::any_of(live.begin(), live.end(), [&](DelaunayVertex v) { return t.point(v) == p; });
    const auto made =
        value_of(t.insert(p, live.empty() || prng.chance(0.5) ? DelaunayVertex() : live.front()));
    EXPECT_EQ(made.is_new, !was_there);
    EXPECT_EQ(t.point(made.vertex), p);
    return;
  }
  const DelaunayVertex v = live[prng.below(live.size())];
  if (draw < 9) {
    succeed(t.remove(v));
    EXPECT_FALSE(t.is_live(v));
    return;
  }
  const Point2 to = source.draw(prng);
  const bool taken = std::any_of(live.begin(), live.end(),
                                 [&](DelaunayVertex u) { return u != v && t.point(u) == to; });
  EXPECT_EQ(t.move(v, to).ok(), !taken);
  EXPECT_TRUE(t.is_live(v));
  if (!taken) {
    EXPECT_EQ(t.point(v), to);
  }
}

TEST(Histories, EqualTheBatchAfterEveryStep) {
  for (const PlaneSource& source : plane_sources()) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation2 t;
      for (int step = 0; step < 60; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        change(t, source, prng);
        ASSERT_TRUE(equals_batch(t));
      }
    }
  }
}

TEST(Histories, OfManyPointsEndWhereTheBatchBegins) {
  for (const PlaneSource& source : plane_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(77);
    std::vector<Point2> points;
    for (int i = 0; i < 400; ++i) points.push_back(source.draw(prng));
    DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
    ASSERT_TRUE(equals_batch(t));
    std::vector<Point2> more;
    for (int i = 0; i < 200; ++i) more.push_back(source.draw(prng));
    const std::vector<DelaunayVertex> handles = value_of(t.insert(more));
    for (std::size_t i = 0; i < more.size(); ++i) EXPECT_EQ(t.point(handles[i]), more[i]);
    ASSERT_TRUE(equals_batch(t));
    std::vector<DelaunayVertex> live = live_vertices(t);
    prng.shuffle(live);
    for (std::size_t i = 0; i < live.size(); ++i) {
      succeed(t.remove(live[i]));
      if (i % 16 == 0) {
        ASSERT_TRUE(equals_batch(t)) << i;
      }
    }
    EXPECT_EQ(t.vertex_count(), 0U);
    EXPECT_EQ(t.dimension(), -1);
  }
}

// A hub of many spokes, on a circle: its star is filled by many flips.
TEST(Histories, HubsGoAndComeBack) {
  for (const int rim : {4, 40, 400}) {
    SCOPED_TRACE(rim);
    DelaunayTriangulation2 t;
    const DelaunayVertex hub = value_of(t.insert({0, 0})).vertex;
    for (int i = 0; i < rim; ++i) {
      const double angle = 6.283185307179586 * i / rim;
      (void)value_of(t.insert({std::cos(angle), std::sin(angle)}));
    }
    ASSERT_TRUE(equals_batch(t));
    succeed(t.remove(hub));
    ASSERT_TRUE(equals_batch(t));
    ASSERT_TRUE(value_of(t.insert({0, 0})).is_new);
    ASSERT_TRUE(equals_batch(t));
  }
}

// Points on a parabola and one far below: all are on the hull, and the far one sees them all.
TEST(Histories, VerticesOfTheHullGo) {
  DelaunayTriangulation2 t;
  for (int i = -20; i <= 20; ++i) (void)value_of(t.insert({1.0 * i, 1.0 * i * i}));
  const DelaunayVertex below = value_of(t.insert({0, -1000})).vertex;
  const DelaunayVertex above = value_of(t.insert({0, 1000})).vertex;
  ASSERT_TRUE(equals_batch(t));
  succeed(t.remove(below));
  ASSERT_TRUE(equals_batch(t));
  succeed(t.remove(above));
  ASSERT_TRUE(equals_batch(t));
}

}  // namespace
}  // namespace tetloft::test
