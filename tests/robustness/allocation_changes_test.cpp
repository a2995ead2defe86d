// Memory that ends in changes of triangulations: what is left of them can be worked with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/delaunay_triangulation3.hpp>

#include "robustness/failing_allocator.hpp"

namespace tetloft::test {
namespace {

Point2 shifted(const Point2& p, double by) { return {p.x + by, p.y + by}; }
Point3 shifted(const Point3& p, double by) { return {p.x + by, p.y + by, p.z + by * by}; }

// All places are a vertex's or free, as bytes must have them; points come and all go.
template <class T, class Point>
testing::AssertionResult works_on(T& t, const Point& p) {
  if constexpr (requires { t.serialise(); }) {
    if (!T::deserialise(t.serialise().value()).ok()) return testing::AssertionFailure() << "places";
  }
  for (int i = 0; i < 6; ++i) {
    if (!t.insert(shifted(p, 100.5 + i)).ok()) return testing::AssertionFailure() << "no insertion";
  }
  if constexpr (requires { t.constraints(); }) {
    for (const ConstraintId c : t.constraints()) {
      if (!t.remove_constraint(c).ok()) return testing::AssertionFailure() << "no opening";
    }
  }
  while (t.vertex_count() != 0) {
    if (!t.remove(*t.vertices().begin()).ok()) return testing::AssertionFailure() << "no removal";
  }
  return testing::AssertionSuccess();
}

// Each allocation of `change` fails, alone and with all that follow.
template <class T, class Point, class Change>
void fail_everywhere(const std::vector<Point>& points, const Change& change) {
  for (const Failing how : {Failing::once, Failing::from_there}) {
    bool failed = true;
    for (std::size_t n = 1; failed; ++n) {
      SCOPED_TRACE(testing::Message() << "allocation " << n);
      T t;
      for (const Point& p : points) ASSERT_TRUE(t.insert(p).ok());
      arm_allocator(n, how);
      const auto result = change(t);
      failed = allocator_failed();
      (void)disarm_allocator();
      if (!result) {
        EXPECT_EQ(result.error().code, ErrorCode::out_of_memory) << to_string(result.error());
      }
      ASSERT_TRUE(works_on(t, points.front()));
    }
  }
}

template <class T, class Point>
void fail_changes(const std::vector<Point>& points) {
  SCOPED_TRACE(testing::Message() << points.size() << " points");
  const std::vector<Point> more{shifted(points[0], 7.25), shifted(points[1], 3.5), points[1],
                                shifted(points[0], -6)};
  const Execution execution{.threads = 1};
  fail_everywhere<T>(points, [&](T& t) { return t.insert(more[0]); });
  fail_everywhere<T>(points, [&](T& t) { return t.insert(more, execution); });
  for (std::size_t i = 0; i < std::min<std::size_t>(3, points.size()); ++i) {
    fail_everywhere<T>(points, [&](T& t) { return t.remove(t.vertex_at(i)); });
    fail_everywhere<T>(points, [&](T& t) { return t.move(t.vertex_at(i), more[0]); });
  }
}

TEST(MemoryEnds, InChangesOfThePlane) {
  using T = DelaunayTriangulation2;
  fail_changes<T>(std::vector<Point2>{{0, 0}, {4, 0}, {1, 5}, {6, 6}, {2, 2}, {3, 1}});
  fail_changes<T>(std::vector<Point2>{{0, 4}, {0, 0}, {1, 0}, {2, 0}});
  fail_changes<T>(std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}});
}

// A vertex that moves onto a wall divides it, and is not taken back.
TEST(MemoryEnds, InChangesBesideWalls) {
  using T = DelaunayTriangulation2;
  const std::vector<Point2> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {1, 3}, {6, 4}};
  fail_everywhere<T>(points, [](T& t) -> Result<void> {
    const auto made = t.insert_constraint(t.vertex_at(0), t.vertex_at(2));
    return made.ok() ? t.move(t.vertex_at(4), {4, 4}) : made.error();
  });
}

TEST(MemoryEnds, InChangesOfSpace) {
  using T = DelaunayTriangulation3;
  fail_changes<T>(
      std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {1, 5, 0}, {6, 6, 1}, {2, 2, 4}, {3, 1, 7}});
  fail_changes<T>(std::vector<Point3>{{0, 0, 3}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}});
  fail_changes<T>(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  fail_changes<T>(std::vector<Point3>{{0, 0, 0}, {1, 1, 1}});
}

}  // namespace
}  // namespace tetloft::test
