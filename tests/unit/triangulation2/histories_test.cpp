// After any history a triangulation is that of the points that are left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace tetloft::test {
namespace {

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
  for (const PlaneSource& source : plane_sources())
    come_and_go<DelaunayTriangulation2>(source, equals_batch);
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
