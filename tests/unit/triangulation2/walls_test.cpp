// Walks and searches among walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support.hpp"

namespace tetloft::test {
namespace {

double squared(const Point2& a, const Point2& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y;
}

// What is nearest may lie behind a wall, where no neighbour leads nearer; distances are exact.
TEST(Walls, NearestVerticesAreFoundBehindThem) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Prng prng(seed);
    const auto draw = [&] {
      return Point2{static_cast<double>(prng.below(40)), static_cast<double>(prng.below(40))};
    };
    DelaunayTriangulation2 t;
    for (int i = 0; i < 60; ++i) (void)value_of(t.insert(draw()));
    const std::vector<DelaunayVertex> live = live_vertices(t);
    for (int i = 0; i < 60; ++i) {
      const DelaunayVertex u = live[prng.below(live.size())];
      const DelaunayVertex v = live[prng.below(live.size())];
      if (u != v) (void)t.insert_constraint(u, v);
    }
    for (int round = 0; round < 40; ++round) {
      Point2 p = draw();
      if (round % 4 == 0) p = {3 * p.x - 40, p.y - 50};
      expect_nearest_of_all(t, p, squared, prng);
      EXPECT_EQ(value_of(t.nearest_vertices(p, live.size() + 1)).size(), live.size());
    }
  }
}

// Every edge between an inner and an outer ring shows the middle beyond it, on the way around: who
// always looks at the same edge first walks in circles.
TEST(Walls, WalksAmongThemEnd) {
  constexpr int kSides = 6;
  DelaunayTriangulation2 t;
  std::array<DelaunayVertex, kSides> inner, outer;
  for (std::size_t k = 0; k < kSides; ++k) {
    const double angle = 6.283185307179586 * static_cast<double>(k) / kSides;
    inner[k] = value_of(t.insert({std::cos(angle), std::sin(angle)})).vertex;
    outer[k] = value_of(t.insert({3 * std::cos(angle + 0.4), 3 * std::sin(angle + 0.4)})).vertex;
  }
  for (std::size_t k = 0; k < kSides; ++k) {
    (void)value_of(t.insert_constraint(inner[k], outer[k]));
    (void)value_of(t.insert_constraint(inner[k], outer[(k + 1) % kSides]));
  }
  for (const DelaunayVertex near : outer) {
    EXPECT_EQ(value_of(t.locate({0.01, 0.02}, near)).kind, LocationKind::facet);
  }
}

}  // namespace
}  // namespace tetloft::test
