// Corrected doubles are off by what their header says, at most, against exact expansions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "arithmetic/corrected.hpp"
#include "arithmetic/expansion.hpp"
#include "core/prng.hpp"
#include "predicates/determinants.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using Differences = std::array<double, 12>;

// Of four points of the unit sphere from a fifth, rounded.
Differences nearly_cospherical(Prng& prng) {
  std::array<std::array<double, 3>, 5> p;
  for (auto& point : p) {
    const double z = prng.unit() - 0.5, turn = 6.28 * prng.unit();
    const double r = std::sqrt(1 - z * z);
    point = {r * std::cos(turn), r * std::sin(turn), z};
  }
  Differences d;
  for (std::size_t i = 0; i < 12; ++i) d[i] = p[i / 3][i % 3] - p[4][i % 3];
  return d;
}

template <class Of>
auto determinant(const Differences& d, const Of& of) {
  return predicates::insphere_determinant(of(d[0]), of(d[1]), of(d[2]), of(d[3]), of(d[4]),
                                          of(d[5]), of(d[6]), of(d[7]), of(d[8]), of(d[9]),
                                          of(d[10]), of(d[11]));
}

// |value + correction − exact|, but for the rounding of the result.
double error(const Corrected& c, const Differences& d) {
  const auto exact = determinant(d, [](double v) { return to_expansion(v); });
  const auto rest = (exact - to_expansion(c.value)) - to_expansion(c.correction);
  return rest.size() == 0 ? 0 : std::abs(rest[rest.size() - 1]);
}

// u² times the sum of the magnitudes of the monomials, at most.
double unit_of_second_order(const Differences& d) {
  std::array<double, 3> m{};
  for (std::size_t i = 0; i < 12; ++i) m[i % 3] = std::max(m[i % 3], std::abs(d[i]));
  return 0x1p-106 * 24 * m[0] * m[1] * m[2] * (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
}

TEST(Corrected, InsphereDeterminantIsOffBySecondOrder) {
  Prng prng(75);
  double value_error = 0, halves_error = 0, pairs_error = 0;
  for (int round = 0; round < 2000; ++round) {
    const Differences d = nearly_cospherical(prng);
    const double unit = unit_of_second_order(d);
    const Corrected halves = determinant(d, [](double v) { return Halves(v); });
    const Corrected pairs = determinant(d, [](double v) { return Corrected{v, 0}; });
    EXPECT_EQ(halves.value, determinant(d, [](double v) { return v; }));
    EXPECT_EQ(pairs.value, halves.value);
    halves_error = std::max(halves_error, error(halves, d) / unit);
    pairs_error = std::max(pairs_error, error(pairs, d) / unit);
    value_error = std::max(value_error, error({halves.value, 0}, d) / unit);
  }
  EXPECT_LE(halves_error, kInsphereSecondOrder);
  EXPECT_LE(pairs_error, kInsphereSecondOrder);
  // What is corrected is larger by far.
  EXPECT_GT(value_error, 1e10);
}

TEST(Corrected, CarriesTheErrorsOfItsOperands) {
  const Corrected a{1, 0x1p-60}, b{0x1p-30, -0x1p-90};
  const Corrected sum = a + b, difference = a - b, product = a * b;
  EXPECT_EQ(sum.value, 1 + 0x1p-30);
  EXPECT_EQ(sum.correction, 0x1p-60 - 0x1p-90);
  EXPECT_EQ(difference.correction, 0x1p-60 + 0x1p-90);
  EXPECT_EQ(product.value, 0x1p-30);
  EXPECT_EQ(product.correction, 0);  // 2^-90 of a, and as much less of b
  EXPECT_EQ((Halves(3) * b).correction, -3 * 0x1p-90);
}

}  // namespace
}  // namespace tetloft::test
