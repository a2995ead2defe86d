// What an insertion would change is what it changes, among constraints too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "constrained_support.hpp"

namespace tetloft::test {
namespace {

using Triple = std::array<DelaunayVertex, 3>;

Triple sorted(Triple v) {
  std::sort(v.begin(), v.end());
  return v;
}

// Of a point that was inserted since.
testing::AssertionResult is_what_changed(const ConflictZone2& zone, const DelaunayTriangulation2& t,
                                         const DelaunayTriangulation2& with, DelaunayVertex p) {
  const std::set<Triple> before = triangles_by_vertices(t), after = triangles_by_vertices(with);
  std::set<Triple> gone, come, named, joined;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                      std::inserter(gone, gone.end()));
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::inserter(come, come.end()));
  for (const TriangleId triangle : zone.triangles) named.insert(sorted(t.vertices(triangle)));
  for (const auto& [from, to] : zone.horizon) joined.insert(sorted({p, from, to}));
  if (named != gone || named.size() != zone.triangles.size()) {
    return testing::AssertionFailure() << "triangles";
  }
  if (joined != come || joined.size() != zone.horizon.size()) {
    return testing::AssertionFailure() << "horizon";
  }
  if (zone.neighbours != with.neighbours(p)) return testing::AssertionFailure() << "neighbours";
  if (!std::is_sorted(zone.triangles.begin(), zone.triangles.end())) {
    return testing::AssertionFailure() << "order of triangles";
  }
  const bool is_closed = zone.horizon.size() == zone.neighbours.size();
  if (is_closed == with.is_on_hull(p)) return testing::AssertionFailure() << "turn";
  if (is_closed && zone.horizon.front()[0] != zone.neighbours.front()) {
    return testing::AssertionFailure() << "first of the horizon";
  }
  for (std::size_t i = 0; i < zone.horizon.size(); ++i) {
    const auto [from, to] = zone.horizon[i];
    if (!with.triangles(p, from)[0].valid() ||
        with.triangles(p, from)[0] != with.triangles(p, to)[1]) {
      return testing::AssertionFailure() << "turns the other way";
    }
    const bool is_last = i + 1 == zone.horizon.size();
    if ((is_closed || !is_last) && zone.horizon[is_last ? 0 : i + 1][0] != to) {
      return testing::AssertionFailure() << "order of the horizon";
    }
  }
  return testing::AssertionSuccess();
}

// On its lattice, between, on the middle of a constraint, an ulp beside it, far outside.
Point2 place_of_interest(const DelaunayTriangulation2& t, const PlaneSource& source, Prng& prng) {
  const Point2 p = source.draw(prng);
  const std::vector<ConstraintId> constraints = t.constraints();
  switch (prng.below(4)) {
    case 0: return p;
    case 1: return {p.x + 0.25, p.y - 0.5};
    case 2: return {p.x + 64 * (prng.unit() - 0.5), p.y + 64 * (prng.unit() - 0.5)};
    default: break;
  }
  if (constraints.empty()) return p;
  const auto edges = t.edges(constraints[prng.below(constraints.size())]);
  const auto [u, v] = edges[prng.below(edges.size())];
  const Point2 a = t.point(u), b = t.point(v);
  const Point2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  return prng.chance(0.5) ? middle : Point2{middle.x, std::nextafter(middle.y, 100.0)};
}

TEST(ConflictZone, IsWhatInsertionChanges) {
  std::size_t zones = 0, divided = 0;
  for (const PlaneSource& source : plane_sources()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      const DelaunayTriangulation2 t = constrained_at_random(source, prng);
      for (int round = 0; round < 25; ++round) {
        const Point2 p = place_of_interest(t, source, prng);
        const ConflictZone2 zone = value_of(t.conflict_zone(p));
        DelaunayTriangulation2 with = t;
        const auto made = value_of(with.insert(p));
        if (!made.is_new || t.dimension() < 2) {
          EXPECT_TRUE(zone.triangles.empty() && zone.horizon.empty() && zone.neighbours.empty());
          continue;
        }
        ASSERT_TRUE(is_what_changed(zone, t, with, made.vertex)) << round;
        ++zones;
        divided += constrained_edges(with).size() > constrained_edges(t).size() ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(zones, 500U);
  EXPECT_GT(divided, 50U);
}

TEST(ConflictZone, EndsAtConstraints) {
  const std::vector<Point2> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {3, 4}, {5, 4}};
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  const auto v = live_vertices(t);
  const auto neighbours = [&](const Point2& p) { return value_of(t.conflict_zone(p)).neighbours; };
  EXPECT_EQ(neighbours({3.5, 4.5}).size(), 4U);
  (void)value_of(t.insert_constraint(v[4], v[5]));
  EXPECT_EQ(neighbours({3.5, 4.5}).size(), 4U);
  (void)value_of(t.insert_constraint(v[0], v[4]));
  (void)value_of(t.insert_constraint(v[5], v[1]));
  EXPECT_EQ(neighbours({4, 3.75}), (std::vector{v[0], v[1], v[4], v[5]}));
  EXPECT_EQ(neighbours({4, 4}), (std::vector{v[0], v[1], v[2], v[3], v[4], v[5]}));
}

TEST(ConflictZone, RefusesWhatIsNotFinite) {
  DelaunayTriangulation2 t;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(t.conflict_zone({0, inf}).error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(value_of(t.conflict_zone({0, 0})).neighbours.empty());
  (void)value_of(t.insert({1, 1}));
  EXPECT_TRUE(value_of(t.conflict_zone({0, 0})).neighbours.empty());
}

}  // namespace
}  // namespace tetloft::test
