// Distances compared, against rationals.
#include "predicates/distances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/prng.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using oracle::Rational;

Rational exact_square(double a, double b) {
  const Rational d = Rational::exactly(a) - Rational::exactly(b);
  return d * d;
}

Rational exact_squared_distance(const Point3& p, const Point3& q) {
  return exact_square(p.x, q.x) + exact_square(p.y, q.y) + exact_square(p.z, q.z);
}

Sign sign_of(const Rational& r) { return static_cast<Sign>(r.sign()); }

// Coordinates whose distances agree, or nearly so: grids of every scale, some moved by an ulp.
double coordinate(Prng& prng, int kind) {
  const double grid = static_cast<double>(prng.below(4)) - 1;
  switch (kind) {
    case 0: return grid;
    case 1: return prng.chance(0.5) ? std::nextafter(grid, 9.0) : grid;
    case 2: return 1 + grid * 0x1p-52;
    case 3: return grid * 0x1p+600;
    case 4: return grid * 0x1p-600;
    case 5: return grid * std::numeric_limits<double>::denorm_min();
    default: return std::ldexp(grid, static_cast<int>(prng.below(2000)) - 1000);
  }
}

TEST(CompareDistances, IsExact) {
  Prng prng(41);
  std::size_t equal = 0;
  for (int kind = 0; kind < 7; ++kind) {
    for (int round = 0; round < 300; ++round) {
      const auto point = [&] {
        return Point3{coordinate(prng, kind), coordinate(prng, kind), coordinate(prng, kind)};
      };
      const Point3 p = point(), a = point(), b = point();
      const Sign expected = sign_of(exact_squared_distance(p, a) - exact_squared_distance(p, b));
      equal += expected == Sign::zero ? 1U : 0U;
      EXPECT_EQ(predicates::compare_distances(p, a, b), expected) << kind << " " << round;
      EXPECT_EQ(predicates::compare_distances(p, b, a), -expected);
    }
  }
  EXPECT_GT(equal, 100U);
}

TEST(CompareDistance, WithARadiusIsExact) {
  Prng prng(42);
  std::size_t equal = 0;
  for (int kind = 0; kind < 7; ++kind) {
    for (int round = 0; round < 300; ++round) {
      const auto point = [&] { return Point3{coordinate(prng, kind), coordinate(prng, kind), 0}; };
      const Point3 p = point(), a = point();
      double radius = std::abs(coordinate(prng, kind));
      if (round % 3 == 0) radius = std::hypot(p.x - a.x, p.y - a.y);
      if (std::isinf(radius)) continue;
      const Sign expected = sign_of(exact_squared_distance(p, a) - exact_square(radius, 0));
      equal += expected == Sign::zero ? 1U : 0U;
      EXPECT_EQ(predicates::compare_distance(p, a, radius), expected) << kind << " " << round;
    }
  }
  EXPECT_GT(equal, 100U);
  EXPECT_EQ(predicates::compare_distance({0, 0, 0}, {1e300, 1e300, 1e300},
                                         std::numeric_limits<double>::infinity()),
            Sign::negative);
}

}  // namespace
}  // namespace tetloft::test
