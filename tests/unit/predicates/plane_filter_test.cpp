// Filters of the plane for one set: certain where they answer, final where they are exact.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <tetloft/predicates.hpp>

#include "core/prng.hpp"
#include "predicates/plane_filter.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using predicates::PlaneFilter;

std::vector<Point2> draw(std::size_t n, Prng& prng, auto&& coordinate) {
  std::vector<Point2> points(n);
  for (Point2& p : points) {
    p.x = coordinate(prng);
    p.y = coordinate(prng);
  }
  return points;
}

struct Tally {
  int answered = 0;
  int silent = 0;
};

// All filters agree with the exact predicates on random choices of four points.
Tally expect_agreement(const PlaneFilter& filter, const std::vector<Point2>& points, Prng& prng) {
  Tally tally;
  for (int round = 0; round < 3000; ++round) {
    const auto pick = [&]() -> const Point2& { return points[prng.below(points.size())]; };
    const Point2 &a = pick(), &b = pick(), &c = pick(), &d = pick();
    const int o = filter.orient2d(a, b, c);
    const int s = filter.incircle(a, b, c, d);
    if (o != 0 || filter.is_exact()) {
      EXPECT_EQ(static_cast<Sign>(o), orient2d(a, b, c));
    }
    if (s != 0 || filter.is_exact()) {
      EXPECT_EQ(static_cast<Sign>(s), incircle(a, b, c, d));
    }
    if (s == 0 && filter.is_exact()) {
      EXPECT_EQ(predicates::perturbed_incircle_of_cocircular(a, b, c, d),
                incircle_perturbed(a, b, c, d));
    }
    (s != 0 ? tally.answered : tally.silent) += 1;
  }
  return tally;
}

Tally expect_agreement(const std::vector<Point2>& points, Prng& prng) {
  return expect_agreement(PlaneFilter(points), points, prng);
}

TEST(PlaneFilter, IsNeverWrong) {
  Prng prng(81);
  const Tally uniform = expect_agreement(draw(200, prng, [](Prng& r) { return r.unit(); }), prng);
  EXPECT_GT(uniform.answered, 2500);
  const Tally tenths = expect_agreement(
      draw(60, prng, [](Prng& r) { return static_cast<double>(r.below(5)) / 10; }), prng);
  EXPECT_GT(tenths.silent, 100);
  for (const int spread : {100, 900, 2000}) {
    expect_agreement(draw(60, prng,
                          [&](Prng& r) {
                            const auto below = static_cast<std::uint64_t>(spread);
                            return std::ldexp(r.unit() - 0.5,
                                              static_cast<int>(r.below(below)) - spread / 2);
                          }),
                     prng);
  }
}

// Differences that are rounded, and determinants near zero: where a bound is put to the test.
TEST(PlaneFilter, IsNeverWrongNearZero) {
  Prng prng(82);
  for (const double offset : {0.0, 1.0, 1e3, 1e9}) {
    for (const double noise : {1e-9, 1e-15, 1e-16}) {
      std::vector<Point2> circle(40);
      for (std::size_t i = 0; i < circle.size(); ++i) {
        const double angle = 0.1 + 0.15 * static_cast<double>(i);
        circle[i] = {offset + std::cos(angle) + noise * prng.unit(),
                     offset + std::sin(angle) + noise * prng.unit()};
      }
      expect_agreement(circle, prng);
    }
  }
}

TEST(PlaneFilter, IsExactOnSmallMultiplesOfAPowerOfTwo) {
  Prng prng(83);
  for (const double unit : {1.0, 0.5, 0x1p-180, 0x1p+140}) {
    for (const std::uint64_t side : {3U, 5201U}) {
      const auto points =
          draw(100, prng, [&](Prng& r) { return unit * (static_cast<double>(r.below(side)) - 7); });
      EXPECT_TRUE(PlaneFilter(points).is_exact());
      expect_agreement(points, prng);
    }
  }
  std::vector<Point2> wide =
      draw(50, prng, [](Prng& r) { return static_cast<double>(r.below(3)); });
  wide.push_back({9000, 0});
  EXPECT_FALSE(PlaneFilter(wide).is_exact());
  expect_agreement(wide, prng);
}

TEST(PlaneFilter, IsNoLongerExactOnceAPointOffTheLatticeIsAdmitted) {
  Prng prng(84);
  std::vector<Point2> points =
      draw(50, prng, [](Prng& r) { return static_cast<double>(r.below(9)); });
  points.push_back({0, 0});
  points.push_back({8, 8});
  const PlaneFilter lattice(points);
  for (const Point2& within : {Point2{3, 5}, Point2{8, 0}}) {
    PlaneFilter filter = lattice;
    filter.admit(within);
    EXPECT_TRUE(filter.is_exact());
  }
  for (const Point2& off : {Point2{2.5, 3}, Point2{9, 0}, Point2{0, -1}, Point2{1, 0x1p-1074}}) {
    PlaneFilter filter = lattice;
    filter.admit(off);
    EXPECT_FALSE(filter.is_exact());
    std::vector<Point2> all = points;
    all.insert(all.end(), 10, off);
    expect_agreement(filter, all, prng);
  }
}

TEST(PlaneFilter, DoesNotAnswerWithoutACoordinate) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point2> lattice{{0, 0}, {1, 0}, {0, 1}, {2, 2}};
  for (const PlaneFilter& filter : {PlaneFilter(lattice), PlaneFilter()}) {
    EXPECT_EQ(filter.orient2d(lattice[0], {nan, nan}, lattice[2]), 0);
    EXPECT_EQ(filter.incircle(lattice[0], lattice[1], {nan, nan}, lattice[3]), 0);
  }
}

TEST(PlaneFilter, DoesNotAnswerWhereDeterminantsOverflow) {
  const std::vector<Point2> far{{1e200, 0}, {0, 1e200}, {0, 0}, {1, 2}};
  const PlaneFilter filter(far);
  EXPECT_FALSE(filter.is_exact());
  EXPECT_EQ(filter.incircle(far[0], far[1], far[2], far[3]), 0);
}

}  // namespace
}  // namespace tetloft::test
