// Every predicate on every family of hard points: agreement with the oracle, and the
// identities of the contracts.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <ostream>

#include <tetloft/predicates.hpp>

#include "support/exact/predicates.hpp"
#include "unit/predicates/families.hpp"

namespace tetloft {

void PrintTo(Sign s, std::ostream* out) { *out << static_cast<int>(s); }

namespace test {

namespace {

constexpr int kTrials = 80;

class Family_ : public testing::TestWithParam<Family> {
 protected:
  template <class Check>
  void for_each_case(const Check& check) {
    Prng prng(20240229);
    for (int trial = 0; trial < kTrials && !HasFailure(); ++trial) {
      const Points p = GetParam().make(prng);
      SCOPED_TRACE("trial " + std::to_string(trial) + " " + to_string(p));
      check(p, prng);
    }
  }
};

int number(Sign s) { return static_cast<int>(s); }

TEST_P(Family_, Orient2dAgreesWithOracle) {
  for_each_case([](const Points& p, Prng&) {
    const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]);
    EXPECT_EQ(number(orient2d(a, b, c)), oracle::orient2d(a, b, c));
  });
}

TEST_P(Family_, Orient3dAgreesWithOracle) {
  for_each_case([](const Points& p, Prng&) {
    EXPECT_EQ(number(orient3d(p[0], p[1], p[2], p[3])), oracle::orient3d(p[0], p[1], p[2], p[3]));
  });
}

TEST_P(Family_, IncircleAgreesWithOracle) {
  for_each_case([](const Points& p, Prng&) {
    const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]), d = flat(p[3]);
    EXPECT_EQ(number(incircle(a, b, c, d)), oracle::incircle(a, b, c, d));
    EXPECT_EQ(number(incircle_perturbed(a, b, c, d)), oracle::incircle_perturbed(a, b, c, d));
  });
}

TEST_P(Family_, InsphereAgreesWithOracle) {
  for_each_case([](const Points& p, Prng&) {
    EXPECT_EQ(number(insphere(p[0], p[1], p[2], p[3], p[4])),
              oracle::insphere(p[0], p[1], p[2], p[3], p[4]));
    EXPECT_EQ(number(insphere_perturbed(p[0], p[1], p[2], p[3], p[4])),
              oracle::insphere_perturbed(p[0], p[1], p[2], p[3], p[4]));
  });
}

/// The determinants are antisymmetric in all points, the query point included: stronger than
/// identity (1) of the contracts, and what makes the perturbation consistent.
TEST_P(Family_, SwappingTwoPointsNegates) {
  for_each_case([](const Points& p, Prng& prng) {
    Points q = p;
    const std::size_t i = prng.below(3);
    const std::size_t k = (i + 1 + prng.below(2)) % 3;
    std::swap(q[i], q[k]);
    EXPECT_EQ(orient2d(flat(q[0]), flat(q[1]), flat(q[2])),
              -orient2d(flat(p[0]), flat(p[1]), flat(p[2])));
    q = p;
    const std::size_t i4 = prng.below(4);
    const std::size_t k4 = (i4 + 1 + prng.below(3)) % 4;
    std::swap(q[i4], q[k4]);
    EXPECT_EQ(orient3d(q[0], q[1], q[2], q[3]), -orient3d(p[0], p[1], p[2], p[3]));
    EXPECT_EQ(incircle(flat(q[0]), flat(q[1]), flat(q[2]), flat(q[3])),
              -incircle(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3])));
    EXPECT_EQ(incircle_perturbed(flat(q[0]), flat(q[1]), flat(q[2]), flat(q[3])),
              -incircle_perturbed(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3])));
    q = p;
    const std::size_t i5 = prng.below(5);
    const std::size_t k5 = (i5 + 1 + prng.below(4)) % 5;
    std::swap(q[i5], q[k5]);
    EXPECT_EQ(insphere(q[0], q[1], q[2], q[3], q[4]), -insphere(p[0], p[1], p[2], p[3], p[4]));
    EXPECT_EQ(insphere_perturbed(q[0], q[1], q[2], q[3], q[4]),
              -insphere_perturbed(p[0], p[1], p[2], p[3], p[4]));
  });
}

INSTANTIATE_TEST_SUITE_P(Hard, Family_, testing::ValuesIn(families()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace

}  // namespace test

}  // namespace tetloft
