// Which stage answers: every stage of every predicate is reached, by the inputs it is for.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include <tetloft/predicates.hpp>

#include "unit/predicates/families.hpp"

namespace tetloft::test {

namespace {

using Stages = PredicateCounters::Stages;

Stages operator+(const Stages& a, const Stages& b) {
  return {a.filter + b.filter, a.expansion + b.expansion, a.integer + b.integer,
          a.symbolic + b.symbolic, a.lattice + b.lattice};
}

std::uint64_t total(const Stages& s) {
  return s.filter + s.expansion + s.integer + s.symbolic + s.lattice;
}

/// Calls of all predicates on some cases of all families.
void call(const std::function<void(const Points&)>& predicate) {
  for (const Family& family : families()) {
    Prng prng(5);
    for (int trial = 0; trial < 20; ++trial) predicate(family.make(prng));
  }
}

const std::uint64_t kCalls = 20 * families().size();

TEST(Stages, AllOfOrient2dAreReached) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  call([](const Points& p) { (void)orient2d(flat(p[0]), flat(p[1]), flat(p[2])); });
  EXPECT_GE(counters.orient2d.filter, 50U);
  EXPECT_GE(counters.orient2d.lattice, 10U);
  EXPECT_GE(counters.orient2d.expansion, 10U);
  EXPECT_GE(counters.orient2d.integer, 10U);
  EXPECT_EQ(total(counters.orient2d), kCalls);
}

TEST(Stages, AllOfOrient3dAreReached) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  call([](const Points& p) { (void)orient3d(p[0], p[1], p[2], p[3]); });
  EXPECT_GE(counters.orient3d.filter, 50U);
  EXPECT_GE(counters.orient3d.lattice, 10U);
  EXPECT_GE(counters.orient3d.expansion, 10U);
  EXPECT_GE(counters.orient3d.integer, 10U);
  EXPECT_EQ(total(counters.orient3d), kCalls);
}

TEST(Stages, FiltersAnswerForAThinAxis) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  Prng prng(11);
  constexpr std::uint64_t kTrials = 500;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    Points points;
    for (Point3& p : points) {
      p = {prng.between(-1, 1), prng.between(-1, 1), 5e-324 * double(prng.below(1000))};
    }
    (void)orient3d(points[0], points[1], points[2], points[3]);
    (void)insphere(points[0], points[1], points[2], points[3], points[4]);
  }
  EXPECT_GE(counters.orient3d.filter, kTrials - 10);
  EXPECT_GE(counters.insphere.filter, kTrials - 10);
}

/// What rounding leaves of zero is told by twice the precision, whose filters count as such: of
/// points near each other, whose differences are doubles, and of others.
TEST(Stages, FiltersAnswerForATiltedPlane) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  Prng prng(12);
  constexpr std::uint64_t kTrials = 500;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    const double size = trial % 2 == 0 ? 1 : 1e-3;
    const double x = prng.unit(), y = prng.unit();
    Points points;
    for (Point3& p : points) {
      p.x = x + size * prng.unit();
      p.y = y + size * prng.unit();
      p.z = 0.3 * p.x + 0.7 * p.y;
    }
    const Sign sign = orient3d(points[0], points[1], points[2], points[3]);
    EXPECT_EQ(sign, -orient3d(points[1], points[0], points[2], points[3]));
    (void)insphere(points[0], points[1], points[2], points[3], points[4]);
  }
  // Some are coplanar.
  EXPECT_GE(counters.orient3d.filter, 2 * kTrials * 9 / 10);
  EXPECT_GE(counters.insphere.filter, kTrials * 9 / 10);
}

TEST(Stages, AllOfIncircleAreReached) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  call([](const Points& p) { (void)incircle(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3])); });
  EXPECT_GE(counters.incircle.filter, 50U);
  EXPECT_GE(counters.incircle.lattice, 10U);
  EXPECT_GE(counters.incircle.expansion, 10U);
  EXPECT_GE(counters.incircle.integer, 10U);
  EXPECT_EQ(counters.incircle.symbolic, 0U);
  EXPECT_EQ(total(counters.incircle), kCalls);
}

TEST(Stages, AllOfInsphereAreReached) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  call([](const Points& p) { (void)insphere(p[0], p[1], p[2], p[3], p[4]); });
  EXPECT_GE(counters.insphere.filter, 50U);
  EXPECT_GE(counters.insphere.lattice, 10U);
  EXPECT_GE(counters.insphere.expansion, 10U);
  EXPECT_GE(counters.insphere.integer, 10U);
  EXPECT_EQ(counters.insphere.symbolic, 0U);
  EXPECT_EQ(total(counters.insphere), kCalls);
}

/// Orientations that a perturbation needs belong to its call and are not counted.
TEST(Stages, AllOfThePerturbedPredicatesAreReached) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  call([](const Points& p) {
    (void)incircle_perturbed(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3]));
    (void)insphere_perturbed(p[0], p[1], p[2], p[3], p[4]);
  });
  for (const Stages& s : {counters.incircle, counters.insphere}) {
    EXPECT_GE(s.filter, 50U);
    EXPECT_GE(s.expansion, 10U);
    EXPECT_GE(s.integer, 10U);
    EXPECT_GE(s.symbolic, 10U);
    EXPECT_EQ(total(s), kCalls);
  }
  // Lattices decide cocircular points, left to the perturbation; in space they also decide
  // where the gap hid the sign.
  EXPECT_GE(counters.insphere.lattice, 3U);
  EXPECT_EQ(total(counters.orient2d + counters.orient3d), 0U);
}

TEST(Stages, UniformPointsNeverLeaveTheFilter) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  Prng prng(1);
  const auto point = [&] { return Point3{prng.unit(), prng.unit(), prng.unit()}; };
  for (int i = 0; i < 1000; ++i) {
    (void)insphere(point(), point(), point(), point(), point());
    (void)orient3d(point(), point(), point(), point());
  }
  EXPECT_EQ(counters.insphere.filter, 1000U);
  EXPECT_EQ(counters.orient3d.filter, 1000U);
}

TEST(Stages, LatticesNeverNeedExpansions) {
  PredicateCounters counters;
  const PredicateCounting scope(counters);
  Prng prng(1);
  const auto point = [&] {
    return Point3{100.5 + static_cast<double>(prng.below(40)),
                  50.5 + static_cast<double>(prng.below(40)),
                  2.5 * static_cast<double>(prng.below(4))};
  };
  for (int i = 0; i < 3000; ++i) {
    (void)insphere_perturbed(point(), point(), point(), point(), point());
    (void)orient3d(point(), point(), point(), point());
    (void)incircle_perturbed(flat(point()), flat(point()), flat(point()), flat(point()));
    (void)orient2d(flat(point()), flat(point()), flat(point()));
  }
  EXPECT_EQ(counters.insphere.expansion + counters.orient3d.expansion +
                counters.incircle.expansion + counters.orient2d.expansion,
            0U);
}

TEST(PredicateCounting, CountsOnlyWhileItLives) {
  PredicateCounters counters;
  {
    const PredicateCounting scope(counters);
    (void)orient2d({0, 0}, {1, 0}, {0, 1});
  }
  (void)orient2d({0, 0}, {1, 0}, {0, 1});
  EXPECT_EQ(total(counters.orient2d), 1U);
}

TEST(PredicateCounting, RestoresTheOuterScope) {
  PredicateCounters outer;
  PredicateCounters inner;
  const PredicateCounting outer_scope(outer);
  (void)orient2d({0, 0}, {1, 0}, {0, 1});
  {
    const PredicateCounting inner_scope(inner);
    (void)orient2d({0, 0}, {1, 0}, {0, 1});
    (void)orient2d({0, 0}, {1, 0}, {0, 1});
  }
  (void)orient2d({0, 0}, {1, 0}, {0, 1});
  EXPECT_EQ(total(outer.orient2d), 2U);
  EXPECT_EQ(total(inner.orient2d), 2U);
}

}  // namespace

}  // namespace tetloft::test
