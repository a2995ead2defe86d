// Starts are near and live.
#include "spatial/start_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/prng.hpp"

namespace tetloft::internal {
namespace {

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

TEST(StartGrid, NamesAVertexOfTheCellWhateverTheBox) {
  const std::vector<Point3> sizes{{1, 1, 1}, {1000, 1, 1}, {1, 1e-9, 1}, {5, 0, 5}, {0, 0, 3}};
  for (const Point3& size : sizes) {
    SCOPED_TRACE(testing::Message() << size.x << " " << size.y << " " << size.z);
    Prng prng(31);
    std::vector<Point3> points;
    for (int i = 0; i < 4000; ++i) {
      points.push_back({7 + size.x * prng.unit(), size.y * prng.unit(), size.z * prng.unit()});
    }
    StartGrid grid;
    grid.start_again({Point3{7, 0, 0}, Point3{7 + size.x, size.y, size.z}}, points.size());
    EXPECT_FALSE(grid.is_outgrown(points.size()));
    EXPECT_TRUE(grid.is_outgrown(10 * points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) grid.add(points[i], VertexId(i));
    double sum = 0;
    for (const Point3& p : points) {
      const VertexId v = grid.near(p, [](VertexId) { return true; });
      ASSERT_TRUE(v.valid());
      sum += distance(points[v.index()], p);
    }
    // Of 4,000 points in 2,000 cells or so, those of one cell are some two hundredths of a line
    // apart, and a tenth of a cube.
    EXPECT_LT(sum / 4000, 0.2 * distance(size, {0, 0, 0}));
  }
}

TEST(StartGrid, PassesOverVerticesThatAreGone) {
  StartGrid grid;
  EXPECT_FALSE(grid.near({0, 0, 0}, [](VertexId) { return true; }).valid());
  grid.start_again({Point3{0, 0, 0}, Point3{1, 1, 1}}, 1000);
  grid.add({0.9, 0.9, 0.9}, VertexId(1));
  grid.add({0.1, 0.1, 0.1}, VertexId(2));
  EXPECT_EQ(grid.near({0.95, 0.95, 0.95}, [](VertexId) { return true; }), VertexId(1));
  EXPECT_EQ(grid.near({0.95, 0.95, 0.95}, [](VertexId v) { return v != VertexId(1); }),
            VertexId(2));
  EXPECT_EQ(grid.near({-5, 1e300, 3}, [](VertexId) { return true; }).valid(), true);
}

}  // namespace
}  // namespace tetloft::internal
