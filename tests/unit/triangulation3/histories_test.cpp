// After any history a triangulation is that of the points that are left.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support.hpp"

namespace tetloft::test {
namespace {

// One random operation.
void change(DelaunayTriangulation3& t, const PointSource& source, Prng& prng) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  const std::uint64_t draw = prng.below(10);
  if (live.empty() || draw < 5) {
    const Point3 p = source.draw(prng);
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
  const Point3 to = source.draw(prng);
  const bool taken = std::any_of(live.begin(), live.end(),
                                 [&](DelaunayVertex u) { return u != v && t.point(u) == to; });
  EXPECT_EQ(t.move(v, to).ok(), !taken);
  EXPECT_TRUE(t.is_live(v));
  if (!taken) {
    EXPECT_EQ(t.point(v), to);
  }
}

TEST(Histories, EqualTheBatchAfterEveryStep) {
  for (const PointSource& source : point_sources()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation3 t;
      for (int step = 0; step < 60; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        change(t, source, prng);
        ASSERT_TRUE(equals_batch(t));
        if (t.dimension() < 3 && step % 5 == 0) {
          ASSERT_TRUE(equals_flat_oracle(t));
        }
      }
    }
  }
}

TEST(Histories, OfManyPointsEndWhereTheBatchBegins) {
  for (const PointSource& source : point_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(77);
    std::vector<Point3> points;
    for (int i = 0; i < 400; ++i) points.push_back(source.draw(prng));
    DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
    ASSERT_TRUE(equals_batch(t));
    std::vector<Point3> more;
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

// Points that come together pass through all dimensions, and keep their places.
TEST(Histories, ManyPointsJoinAFew) {
  for (const PointSource& source : point_sources()) {
    for (std::size_t there = 1; there <= 4; ++there) {
      SCOPED_TRACE(testing::Message() << source.name << ", beside " << there);
      Prng prng(there);
      DelaunayTriangulation3 t;
      for (std::size_t i = 0; i < there; ++i) (void)value_of(t.insert(source.draw(prng)));
      std::vector<Point3> more;
      for (int i = 0; i < 30; ++i) more.push_back(source.draw(prng));
      const std::vector<DelaunayVertex> handles = value_of(t.insert(more));
      for (std::size_t i = 0; i < more.size(); ++i) EXPECT_EQ(t.point(handles[i]), more[i]) << i;
      ASSERT_TRUE(equals_batch(t));
    }
  }
}

}  // namespace
}  // namespace tetloft::test
