// Scaling all coordinates by a power of two keeps every sign, from denormals to the largest
// doubles: through all ranges and stages, and past every limit between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include <tetloft/predicates.hpp>

#include "unit/predicates/families.hpp"

namespace tetloft::test {

namespace {

std::array<Sign, 6> signs(const Points& p) {
  const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]), d = flat(p[3]);
  return {orient2d(a, b, c),
          orient3d(p[0], p[1], p[2], p[3]),
          incircle(a, b, c, d),
          incircle_perturbed(a, b, c, d),
          insphere(p[0], p[1], p[2], p[3], p[4]),
          insphere_perturbed(p[0], p[1], p[2], p[3], p[4])};
}

/// False if scaling rounds or overflows.
bool scale(const Points& points, int exponent, Points& scaled) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    Point3& q = scaled[i];
    q = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const Point3 back{std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent),
                      std::ldexp(q.z, -exponent)};
    if (!(back == p)) return false;
  }
  return true;
}

TEST(Scaling, ByPowersOfTwoKeepsTheSign) {
  int cases = 0;
  for (const Family& family : families()) {
    static const std::string chosen[] = {"NearlyCospherical", "NearlyCoplanar", "JitteredLattice",
                                         "WideCospherical", "WideCocircular"};
    if (std::find(std::begin(chosen), std::end(chosen), family.name) == std::end(chosen)) continue;
    Prng prng(99);
    for (int trial = 0; trial < 20; ++trial) {
      const Points points = family.make(prng);
      const std::array<Sign, 6> expected = signs(points);
      for (int exponent = -1070; exponent <= 1020; exponent += 9) {
        Points scaled;
        if (!scale(points, exponent, scaled)) continue;
        ++cases;
        EXPECT_EQ(signs(scaled), expected)
            << family.name << " times 2^" << exponent << " " << to_string(points);
      }
    }
  }
  EXPECT_GE(cases, 10000);
}

}  // namespace

}  // namespace tetloft::test
