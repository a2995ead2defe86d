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

using Differences = std::array<Rounded, 12>;

// Of four points of the unit sphere from a fifth, all rounded: most differences are no doubles.
Differences nearly_cospherical(Prng& prng) {
  std::array<std::array<double, 3>, 5> p;
  for (auto& point : p) {
    const double z = prng.unit() - 0.5, turn = 6.28 * prng.unit();
    const double r = std::sqrt(1 - z * z);
    point = {r * std::cos(turn), r * std::sin(turn), z};
  }
  Differences d;
  for (std::size_t i = 0; i < 12; ++i) d[i] = two_difference(p[i / 3][i % 3], p[4][i % 3]);
  return d;
}

// Of a, b, c from d, where z is nearly the sum of x and y.
Differences nearly_coplanar(Prng& prng) {
  std::array<std::array<double, 3>, 4> p;
  for (auto& [x, y, z] : p) {
    x = prng.unit();
    y = prng.unit();
    z = (x + 0.1) + y;
  }
  Differences d{};
  for (std::size_t i = 0; i < 9; ++i) d[i] = two_difference(p[i / 3][i % 3], p[3][i % 3]);
  return d;
}

struct Insphere {
  static constexpr double kSecondOrder = kInsphereSecondOrder;
  template <class Of>
  static auto of(const Differences& d, const Of& of) {
    return predicates::insphere_determinant(of(d[0]), of(d[1]), of(d[2]), of(d[3]), of(d[4]),
                                            of(d[5]), of(d[6]), of(d[7]), of(d[8]), of(d[9]),
                                            of(d[10]), of(d[11]));
  }
  // The magnitudes of the monomials, in sum, at most.
  static double most(const std::array<double, 3>& m) {
    return 24 * m[0] * m[1] * m[2] * (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  }
};

struct Orient3d {
  static constexpr double kSecondOrder = kOrient3dSecondOrder;
  template <class Of>
  static auto of(const Differences& d, const Of& of) {
    return predicates::orient3d_determinant(of(d[0]), of(d[1]), of(d[2]), of(d[3]), of(d[4]),
                                            of(d[5]), of(d[6]), of(d[7]), of(d[8]));
  }
  static double most(const std::array<double, 3>& m) { return 6 * m[0] * m[1] * m[2]; }
};

// |value + correction − exact|.
template <class Exact>
double error(const Corrected& c, const Exact& exact) {
  const auto rest = (exact - to_expansion(c.value)) - to_expansion(c.correction);
  return rest.size() == 0 ? 0 : std::abs(rest[rest.size() - 1]);
}

template <class Determinant>
void expect_second_order(Differences (*draw)(Prng&)) {
  Prng prng(75);
  double value_error = 0, halves_error = 0, rounded_error = 0;
  for (int round = 0; round < 2000; ++round) {
    const Differences d = draw(prng);
    std::array<double, 3> m{};
    for (std::size_t i = 0; i < 12; ++i) m[i % 3] = std::max(m[i % 3], std::abs(d[i].value));
    const double unit = 0x1p-106 * Determinant::most(m);
    // Of the differences as they are rounded, and as they are.
    const Corrected halves = Determinant::of(d, [](const Rounded& r) { return Halves(r.value); });
    const Corrected rounded = Determinant::of(d, [](const Rounded& r) {
      return Corrected{r.value, r.error};
    });
    const auto of_values =
        Determinant::of(d, [](const Rounded& r) { return to_expansion(r.value); });
    const auto exact = Determinant::of(d, [](const Rounded& r) { return to_expansion(r); });
    const double plain = Determinant::of(d, [](const Rounded& r) { return r.value; });
    EXPECT_EQ(halves.value, plain);
    EXPECT_EQ(rounded.value, plain);
    halves_error = std::max(halves_error, error(halves, of_values) / unit);
    rounded_error = std::max(rounded_error, error(rounded, exact) / unit);
    value_error = std::max(value_error, error({plain, 0}, exact) / unit);
  }
  EXPECT_LE(halves_error, Determinant::kSecondOrder);
  EXPECT_LE(rounded_error, Determinant::kSecondOrder);
  // What is corrected is larger by far.
  EXPECT_GT(value_error, 1e10);
}

TEST(Corrected, InsphereDeterminantIsOffBySecondOrder) {
  expect_second_order<Insphere>(nearly_cospherical);
}

TEST(Corrected, Orient3dDeterminantIsOffBySecondOrder) {
  expect_second_order<Orient3d>(nearly_coplanar);
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
