// Many constraints at once are what they are one after the other; the array of walls is a map.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "constrained_support.hpp"
#include "triangulation2/walls_of_plane.hpp"

namespace tetloft::test {
namespace {

// One after the other, each on what the last one left; the first that is refused ends it.
Result<std::vector<ConstraintId>> one_after_the_other(DelaunayTriangulation2& t,
                                                      const std::vector<Edge>& segments,
                                                      Crossing crossing) {
  std::vector<ConstraintId> made;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto one = t.insert_constraint(segments[i][0], segments[i][1], crossing);
    if (!one) {
      Error error = one.error();
      error.message = "segment " + std::to_string(i) + ": " + error.message;
      return error;
    }
    made.push_back(*one);
  }
  return made;
}

TEST(ManyConstraints, AreWhatTheyAreOneAfterTheOther) {
  std::size_t laid = 0, refused = 0, divided = 0;
  for (const PlaneSource& source : plane_sources()) {
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
      SCOPED_TRACE(testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation2 t = constrained_at_random(source, prng);
      const std::vector<DelaunayVertex> live = live_vertices(t);
      // Few do not cross each other as a rule; neighbours never do.
      std::vector<Edge> segments;
      for (std::uint64_t k = 1 + prng.below(seed % 2 == 0 ? 30 : 4); k > 0; --k) {
        const DelaunayVertex u = live[prng.below(live.size())];
        const auto near = t.neighbours(u);
        const DelaunayVertex v =
            prng.chance(0.8) && !near.empty() ? near[prng.below(near.size())] : live.back();
        segments.push_back({u, v});
      }
      if (prng.chance(0.1)) segments.push_back({live[0], {}});
      const Crossing crossing = prng.chance(0.5) ? Crossing::split : Crossing::refuse;
      DelaunayTriangulation2 single = t;
      const DelaunayTriangulation2 before = t;
      const auto expected = one_after_the_other(single, segments, crossing);
      const auto made = t.insert_constraints(segments, crossing);
      ASSERT_EQ(made.ok(), expected.ok());
      if (made) {
        EXPECT_EQ(*made, *expected);
        ASSERT_TRUE(are_same_constrained(t, single));
        ASSERT_TRUE(is_constrained_delaunay(t, false));
        ++laid;
        divided += t.vertex_count() > before.vertex_count() ? 1U : 0U;
        continue;
      }
      EXPECT_EQ(to_string(made.error()), to_string(expected.error()));
      ASSERT_TRUE(are_same_constrained(t, before));
      ++refused;
    }
  }
  EXPECT_GT(laid, 50U);
  EXPECT_GT(refused, 30U);
  EXPECT_GT(divided, 10U);
}

// A ring of segments given in a random order among many points, inserted along a curve.
TEST(ManyConstraints, KeepTheIdsOfTheirPlaces) {
  Prng prng(3);
  std::vector<Point2> points;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) points.push_back({x + 0.5 * prng.unit(), y + 0.5 * prng.unit()});
  }
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  std::vector<Edge> segments;
  for (std::size_t x = 0; x < 40; ++x) {
    for (std::size_t y = 0; y + 1 < 40; y += 2) {
      segments.push_back({t.vertex_at(40 * x + y), t.vertex_at(40 * x + y + 1)});
    }
  }
  prng.shuffle(segments);
  const auto made = value_of(t.insert_constraints(segments));
  ASSERT_EQ(made.size(), segments.size());
  for (std::size_t i = 0; i < made.size(); ++i) {
    EXPECT_EQ(made[i].index(), i);
    EXPECT_EQ(t.ends(made[i]), segments[i]);
  }
  EXPECT_TRUE(is_constrained_delaunay(t, false));
  EXPECT_EQ(t.constraint_count(), segments.size());
}

using internal::triangulation2::PlaneWall;
using internal::triangulation2::Walls;
using WallsInOrder = std::map<PlaneWall::Edge, std::vector<ConstraintId>>;

testing::AssertionResult are_same_walls(const Walls& walls, const WallsInOrder& expected) {
  WallsInOrder found;
  for (const PlaneWall& wall : walls.all()) found[wall.edge()] = wall.constraints();
  if (found != expected || walls.all().size() != expected.size()) {
    return testing::AssertionFailure() << "walls";
  }
  for (const auto& [edge, over] : expected) {
    const PlaneWall* wall = walls.find(edge[1], edge[0]);
    if (wall == nullptr || wall->constraints() != over || wall->lowest() != over.front() ||
        wall->count() != over.size()) {
      return testing::AssertionFailure() << "a wall";
    }
  }
  return testing::AssertionSuccess();
}

TEST(Walls, AreAMapOfEdges) {
  Prng prng(8);
  Walls walls;
  WallsInOrder expected;
  const auto draw_edge = [&] {
    const VertexId a(prng.below(30));
    return PlaneWall::edge_of(a, VertexId(a.value() + 1 + prng.below(20)));
  };
  for (int step = 0; step < 6000; ++step) {
    // Mostly growing, then mostly shrinking.
    const bool grows = prng.chance(step % 2000 < 1000 ? 0.7 : 0.3);
    const PlaneWall::Edge edge = draw_edge();
    const auto there = expected.find(edge);
    const ConstraintId c(prng.below(5));
    if (grows) {
      std::vector<ConstraintId> over{c};
      if (prng.chance(0.2)) over.push_back(ConstraintId(prng.below(5)));
      walls.add(edge[1], edge[0], over);
      std::vector<ConstraintId>& all = expected[edge];
      all.insert(all.end(), over.begin(), over.end());
      std::sort(all.begin(), all.end());
    } else if (there == expected.end()) {
      EXPECT_EQ(walls.find(edge[0], edge[1]), nullptr);
    } else if (prng.chance(0.2)) {
      const VertexId middle(60 + step);
      Walls::Division division = walls.prepare(edge[0], edge[1], middle);
      walls.divide(division);
      for (const VertexId end : edge) expected[PlaneWall::edge_of(end, middle)] = there->second;
      expected.erase(there);
    } else if (prng.chance(0.2)) {
      walls.rename(edge[0], VertexId(7000 + step), edge[1]);
      expected[PlaneWall::edge_of(VertexId(7000 + step), edge[1])] = there->second;
      expected.erase(there);
    } else if (prng.chance(0.3)) {
      walls.remove(edge[0], edge[1]);
      expected.erase(there);
    } else {
      const ConstraintId gone = there->second[prng.below(there->second.size())];
      std::erase(there->second, gone);
      EXPECT_EQ(walls.take(edge[0], edge[1], gone), there->second.empty());
      if (there->second.empty()) expected.erase(there);
    }
    if (step % 50 == 0) {
      ASSERT_TRUE(are_same_walls(walls, expected)) << step;
    }
  }
  const Walls copy = walls;
  EXPECT_TRUE(are_same_walls(copy, expected));
}

}  // namespace
}  // namespace tetloft::test
