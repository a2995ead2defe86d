#include "delaunay3/affine_basis.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using delaunay3_detail::affine_basis;
using delaunay3_detail::AffineBasis;
using delaunay3_detail::collinear;

TEST(Collinear, SeesLinesInEveryDirection) {
  const Point3 directions[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 0},
                               {0, 1, 2}, {2, 0, 1}, {1, 2, 3}};
  for (const Point3& d : directions) {
    const Point3 a{5, 6, 7};
    const Point3 b{a.x + d.x, a.y + d.y, a.z + d.z};
    const Point3 c{a.x - 3 * d.x, a.y - 3 * d.y, a.z - 3 * d.z};
    EXPECT_TRUE(collinear(a, b, c));
    // Off the line in each coordinate that is not its only direction.
    EXPECT_FALSE(collinear(a, b, {c.x + d.y + d.z, c.y + 5 * (d.x + d.z), c.z + 7 * (d.x + d.y)}));
  }
}

TEST(Collinear, SeesTrianglesInEveryCoordinatePlane) {
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(collinear({0, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_FALSE(collinear({0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
}

TEST(AffineBasis, TakesTheFirstIndependentPoints) {
  const Points points{{1, 1, 1}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3},
                      {1, 2, 1}, {2, 3, 2}, {0, 0, 9}, {8, 0, 0}};
  const AffineBasis basis = affine_basis(points);
  EXPECT_EQ(basis.dimension, 3);
  EXPECT_EQ(basis.place, (std::array<std::size_t, 4>{0, 2, 4, 6}));
}

}  // namespace
}  // namespace tetloft::test
