// What the perturbed predicates promise beyond agreement with the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <tetloft/predicates.hpp>

#include "unit/predicates/families.hpp"

namespace tetloft::test {

namespace {

template <class Point>
bool distinct(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::count(points.begin(), points.end(), points[i]) != 1) return false;
  }
  return true;
}

template <class Check>
void for_each_case(const Check& check) {
  for (const Family& family : families()) {
    Prng prng(77);
    for (int trial = 0; trial < 120; ++trial) {
      const Points p = family.make(prng);
      SCOPED_TRACE(family.name + " " + to_string(p));
      check(p);
    }
  }
}

TEST(IncirclePerturbed, IsNeverZeroOnDistinctPoints) {
  int zeros_broken = 0;
  for_each_case([&](const Points& p) {
    const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]), d = flat(p[3]);
    const Sign plain = incircle(a, b, c, d);
    const Sign perturbed = incircle_perturbed(a, b, c, d);
    if (plain != Sign::zero) {
      EXPECT_EQ(perturbed, plain);
    } else if (distinct(std::vector{a, b, c, d}) && orient2d(a, b, c) != Sign::zero) {
      EXPECT_NE(perturbed, Sign::zero);
      ++zeros_broken;
    }
  });
  EXPECT_GE(zeros_broken, 50);
}

TEST(InspherePerturbed, IsNeverZeroOnDistinctPoints) {
  int zeros_broken = 0;
  for_each_case([&](const Points& p) {
    const Sign plain = insphere(p[0], p[1], p[2], p[3], p[4]);
    const Sign perturbed = insphere_perturbed(p[0], p[1], p[2], p[3], p[4]);
    if (plain != Sign::zero) {
      EXPECT_EQ(perturbed, plain);
    } else if (distinct(std::vector(p.begin(), p.end())) &&
               orient3d(p[0], p[1], p[2], p[3]) != Sign::zero) {
      EXPECT_NE(perturbed, Sign::zero);
      ++zeros_broken;
    }
  });
  EXPECT_GE(zeros_broken, 50);
}

/// A raised point lies outside; the point latest in canonical order is raised most.
TEST(IncirclePerturbed, PutsTheLastCornerOfASquareOutside) {
  const Point2 a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  EXPECT_EQ(incircle_perturbed(a, b, d, c), Sign::negative);

  EXPECT_EQ(incircle_perturbed(b, c, d, a), Sign::negative);
  EXPECT_EQ(incircle_perturbed(a, b, c, d), Sign::positive);
  EXPECT_EQ(incircle_perturbed(c, d, a, b), Sign::positive);
}

TEST(InspherePerturbed, PutsTheLastCornerOfACubeOutside) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  EXPECT_EQ(insphere_perturbed(a, b, c, d, {1, 1, 1}), Sign::negative);
}

/// All orders of a cube's corners as arguments: the sign follows the permutation's.
TEST(InspherePerturbed, DependsOnTheSetOfPointsOnly) {
  const Points cube = {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}};
  const Sign sign = insphere_perturbed(cube[0], cube[1], cube[2], cube[3], cube[4]);
  ASSERT_NE(sign, Sign::zero);
  std::array<std::size_t, 5> order = {0, 1, 2, 3, 4};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t k = 0; k < i; ++k) inversions += order[k] > order[i] ? 1 : 0;
    }
    EXPECT_EQ(insphere_perturbed(cube[order[0]], cube[order[1]], cube[order[2]], cube[order[3]],
                                 cube[order[4]]),
              inversions % 2 == 0 ? sign : -sign);
  } while (std::next_permutation(order.begin(), order.end()));
}

/// Four points of one plane of constant z and an apex on either side: the sphere through
/// three of them and the apex meets the plane in their circle.
TEST(InspherePerturbed, RestrictedToAPlaneIsIncirclePerturbed) {
  int zeros = 0;
  for_each_case([&](const Points& p) {
    const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]), d = flat(p[3]);
    const double z = p[4].z;
    const auto at = [z](const Point2& q) { return Point3{q.x, q.y, z}; };
    for (const double height : {z - 1 - std::abs(z), z + 1 + std::abs(z)}) {
      if (!std::isfinite(height)) continue;
      const Point3 apex{p[4].x, p[4].y, height};
      const Sign flat_sign = incircle_perturbed(a, b, c, d);
      const Sign expected = height > z ? flat_sign : -flat_sign;
      EXPECT_EQ(insphere_perturbed(at(a), at(b), at(c), apex, at(d)), expected);
    }
    zeros += incircle(a, b, c, d) == Sign::zero ? 1 : 0;
  });
  EXPECT_GE(zeros, 200);
}

TEST(InspherePerturbed, IsZeroWherePointsCoincide) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  for (const Point3& e : {a, b, c, d}) {
    EXPECT_EQ(insphere_perturbed(a, b, c, d, e), Sign::zero);
  }
  EXPECT_EQ(insphere_perturbed(a, b, c, b, d), Sign::zero);
  EXPECT_EQ(incircle_perturbed({0, 0}, {1, 0}, {0, 1}, {-0.0, 1}), Sign::zero);
}

}  // namespace

}  // namespace tetloft::test
