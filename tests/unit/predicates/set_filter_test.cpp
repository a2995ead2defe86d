// Filters with one bound for a set: certain where they answer, final where they are exact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/predicates.hpp>

#include "core/prng.hpp"
#include "predicates/set_filter.hpp"
#include "predicates/two_doubles.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using predicates::SetFilter;

std::vector<Point3> draw(std::size_t n, Prng& prng, auto&& coordinate) {
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    p.x = coordinate(prng);
    p.y = coordinate(prng);
    p.z = coordinate(prng);
  }
  return points;
}

struct Tally {
  int answered = 0;
  int silent = 0;
  int perturbed = 0;
};

// All filters agree with the exact predicates on random choices of five points.
Tally expect_agreement(const std::vector<Point3>& points, Prng& prng) {
  const SetFilter filter(points);
  Tally tally;
  for (int round = 0; round < 3000; ++round) {
    const auto pick = [&]() -> const Point3& { return points[prng.below(points.size())]; };
    const Point3 &a = pick(), &b = pick(), &c = pick(), &d = pick(), &e = pick();
    const int o = filter.orient3d(a, b, c, d);
    const int s = filter.insphere(a, b, c, d, e);
    if (o != 0 || filter.is_exact()) {
      EXPECT_EQ(static_cast<Sign>(o), orient3d(a, b, c, d));
    }
    if (s != 0 || filter.is_exact()) {
      EXPECT_EQ(static_cast<Sign>(s), insphere(a, b, c, d, e));
    }
    const std::array<const Point3*, 5> all{&a, &b, &c, &d, &e};
    bool distinct = true;
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t k = 0; k < i; ++k) distinct = distinct && *all[i] != *all[k];
    }
    if (s == 0 && filter.is_exact() && distinct) {
      std::array<std::uint32_t, 5> rank{};
      for (std::size_t i = 0; i < 5; ++i) {
        for (const Point3* other : all) rank[i] += canonical_less(*other, *all[i]) ? 1U : 0U;
      }
      EXPECT_EQ(predicates::perturbed_insphere_of_cospherical(filter, all, rank),
                insphere_perturbed(a, b, c, d, e));
      ++tally.perturbed;
    }
    (s != 0 ? tally.answered : tally.silent) += 1;
  }
  return tally;
}

TEST(SetFilter, IsNeverWrong) {
  Prng prng(71);
  const Tally uniform = expect_agreement(draw(200, prng, [](Prng& r) { return r.unit(); }), prng);
  EXPECT_GT(uniform.answered, 2500);
  const Tally tenths = expect_agreement(
      draw(60, prng, [](Prng& r) { return static_cast<double>(r.below(5)) / 10; }), prng);
  EXPECT_GT(tenths.silent, 100);
  expect_agreement(
      draw(60, prng,
           [](Prng& r) { return std::ldexp(r.unit() - 0.5, static_cast<int>(r.below(100)) - 50); }),
      prng);
}

TEST(SetFilter, IsExactOnSmallMultiplesOfAPowerOfTwo) {
  Prng prng(72);
  for (const double unit : {1.0, 0.5, 0x1p-180, 0x1p+140}) {
    for (const std::uint64_t side : {3U, 601U}) {
      const auto points =
          draw(100, prng, [&](Prng& r) { return unit * (static_cast<double>(r.below(side)) - 7); });
      EXPECT_TRUE(SetFilter(points).is_exact());
      const Tally tally = expect_agreement(points, prng);
      if (side == 3) {
        EXPECT_GT(tally.perturbed, 100);
      }
    }
  }
  std::vector<Point3> wide =
      draw(50, prng, [](Prng& r) { return static_cast<double>(r.below(3)); });
  wide.push_back({900, 0, 0});
  EXPECT_FALSE(SetFilter(wide).is_exact());
  expect_agreement(wide, prng);
}

TEST(SetFilter, DoesNotAnswerWhereDeterminantsCouldOverflow) {
  const std::vector<Point3> far{{1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 1e200}, {0, 0, 0}, {1, 2, 3}};
  const SetFilter filter(far);
  EXPECT_FALSE(filter.is_exact());
  EXPECT_EQ(filter.insphere(far[0], far[1], far[2], far[3], far[4]), 0);
  EXPECT_EQ(filter.orient3d(far[0], far[1], far[2], far[4]), 0);
}

// Of two simplices at once, bit by bit: what their determinants are one after the other.
TEST(SetFilter, DecidesTwoSimplicesAsEachAlone) {
  Prng prng(73);
  const auto unit = [](Prng& r) { return r.unit(); };
  const auto tenths = [](Prng& r) { return static_cast<double>(r.below(5)) / 10; };
  int answers[3] = {};
  for (const std::vector<Point3>& points : {draw(200, prng, unit), draw(60, prng, tenths)}) {
    const SetFilter filter(points);
    for (int round = 0; round < 1000; ++round) {
      std::array<const Point3*, 4> s, t;
      for (const Point3*& p : s) p = &points[prng.below(points.size())];
      for (const Point3*& p : t) p = &points[prng.below(points.size())];
      const Point3& e = points[prng.below(points.size())];
      const std::array<int, 2> both = filter.insphere(s, t, e);
      EXPECT_EQ(both[0], filter.insphere(*s[0], *s[1], *s[2], *s[3], e));
      EXPECT_EQ(both[1], filter.insphere(*t[0], *t[1], *t[2], *t[3], e));
      ++answers[both[0] + 1];
    }
  }
  for (const int count : answers) EXPECT_GT(count, 100);
}

TEST(TwoDoubles, AreRoundedAsEachAlone) {
  Prng prng(74);
  for (int round = 0; round < 1000; ++round) {
    std::array<double, 12> s, t;
    for (double& v : s) v = std::ldexp(prng.unit() - 0.5, static_cast<int>(prng.below(40)));
    for (double& v : t) v = std::ldexp(prng.unit() - 0.5, static_cast<int>(prng.below(40)));
    const auto determinant = [](const auto& v) {
      return predicates::insphere_determinant(v(0), v(1), v(2), v(3), v(4), v(5), v(6), v(7), v(8),
                                              v(9), v(10), v(11));
    };
    const predicates::TwoDoubles both =
        determinant([&](std::size_t i) { return predicates::TwoDoubles(s[i], t[i]); });
    EXPECT_EQ(both.first(), determinant([&](std::size_t i) { return s[i]; }));
    EXPECT_EQ(both.second(), determinant([&](std::size_t i) { return t[i]; }));
  }
}

TEST(SetFilter, TakesAnyNumberOfPoints) {
  EXPECT_FALSE(SetFilter().is_exact());
  EXPECT_FALSE(SetFilter(std::span<const Point3>()).is_exact());
  const std::vector<Point3> one{{0.1, 0.2, 0.3}};
  EXPECT_EQ(SetFilter(one).orient3d(one[0], one[0], one[0], one[0]), 0);
}

// One point after the other, as all at once: the same answers, exact or not.
TEST(SetFilter, GrowsToThatOfAllPoints) {
  Prng prng(9);
  for (int kind = 0; kind < 3; ++kind) {
    const auto points = draw(40, prng, [&](Prng& r) {
      const double grid = static_cast<double>(r.below(kind == 1 ? 400 : 40));
      return kind == 2 ? grid * r.unit() : grid * 0.25;
    });
    SetFilter grown;
    for (std::size_t n = 1; n <= points.size(); ++n) {
      grown.add(points[n - 1]);
      const std::span<const Point3> some = std::span(points).first(n);
      const SetFilter all(some);
      ASSERT_EQ(grown.is_exact(), all.is_exact());
      for (int round = 0; round < 20; ++round) {
        const auto p = [&]() -> const Point3& { return some[prng.below(n)]; };
        const Point3 &a = p(), &b = p(), &c = p(), &d = p(), &e = p();
        EXPECT_EQ(grown.orient3d(a, b, c, d), all.orient3d(a, b, c, d));
        EXPECT_EQ(grown.insphere(a, b, c, d, e), all.insphere(a, b, c, d, e));
        const Point3 query{7 * prng.unit(), -prng.unit(), prng.unit()};
        const SetFilter with = grown.with(query);
        EXPECT_FALSE(with.is_exact());
        const int s = with.orient3d(a, b, c, query);
        if (s != 0) {
          EXPECT_EQ(static_cast<Sign>(s), orient3d(a, b, c, query));
        }
      }
    }
  }
}

// What lies within the box counts for the lattice too, whatever unit that had before.
TEST(SetFilter, GrowsByPointsWithinItsBox) {
  const std::vector<Point3> points{
      {0, 0, 0}, {0x1p+155, 0, 0}, {1, 0, 0}, {0, 0x1p+150, 0}, {0, 0, 0x1p+150}};
  SetFilter grown;
  for (const Point3& p : points) grown.add(p);
  EXPECT_FALSE(grown.is_exact());
  EXPECT_FALSE(SetFilter(points).is_exact());
}

}  // namespace
}  // namespace tetloft::test
