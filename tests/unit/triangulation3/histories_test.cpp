// After any history a triangulation is that of the points that are left.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support.hpp"

namespace tetloft::test {
namespace {

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
  for (const PointSource& source : point_sources())
    come_and_go<DelaunayTriangulation3>(source, equals_batch);
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
