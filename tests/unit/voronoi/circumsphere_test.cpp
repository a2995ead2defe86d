#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <tetloft/voronoi.hpp>

#include "core/prng.hpp"

namespace tetloft::test {
namespace {

using internal::Prng;

TEST(Circumsphere, OfACubesCornerIsItsOwn) {
  const Sphere3 s = circumsphere({1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {1, 1, 3});
  EXPECT_EQ(s.centre, (Point3{2, 2, 2}));
  EXPECT_DOUBLE_EQ(s.radius, std::sqrt(3.0));
  // The other orientation, and far away.
  EXPECT_EQ(circumsphere({3, 1, 1}, {1, 1, 1}, {1, 3, 1}, {1, 1, 3}).centre, s.centre);
  const double far = 0x1p40;
  const Sphere3 t =
      circumsphere({far + 1, 1, 1}, {far + 3, 1, 1}, {far + 1, 3, 1}, {far + 1, 1, 3});
  EXPECT_EQ(t.centre, (Point3{far + 2, 2, 2}));
}

// Flatter than doubles, and than pairs of them, can see.
TEST(Circumsphere, OfFlatTetsIsExact) {
  for (const int power : {4, 20, 30, 60, 100}) {
    // (±1, 0, 0), (0, 1, 0) and (0, −2, h): the centre is on the axis, at (h² + 3) / (2 h).
    const double h = std::ldexp(1.0, -power);
    const Sphere3 s = circumsphere({1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -2, h});
    const double z = (h * h + 3) / (2 * h);
    EXPECT_NEAR(s.centre.x / z, 0, 1e-15);
    EXPECT_NEAR(s.centre.z / z, 1, 1e-12) << power;
    EXPECT_NEAR(s.radius / std::hypot(1.0, z), 1, 1e-12);
  }
}

TEST(Circumsphere, OfCoplanarPointsIsInfinite) {
  const Sphere3 s = circumsphere({0.1, 0.1, 0}, {0.7, 0.7, 0}, {0.1, 0.7, 0}, {0.3, 0.2, 0});
  EXPECT_EQ(s.radius, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(s.centre.x));
  EXPECT_EQ(circumsphere({}, {}, {}, {}).radius, std::numeric_limits<double>::infinity());
}

TEST(Circumsphere, ScalesWithPowersOfTwo) {
  Prng prng(3);
  const auto draw = [&] { return Point3{prng.unit(), prng.unit(), prng.unit()}; };
  const Point3 a = draw(), b = draw(), c = draw(), d = draw();
  const Sphere3 s = circumsphere(a, b, c, d);
  for (const double k : {0x1p-290, 0x1p290}) {
    const auto scaled = [&](const Point3& p) { return Point3{k * p.x, k * p.y, k * p.z}; };
    const Sphere3 t = circumsphere(scaled(a), scaled(b), scaled(c), scaled(d));
    EXPECT_EQ(t.centre, scaled(s.centre));
    EXPECT_DOUBLE_EQ(t.radius, k * s.radius);
  }
}

}  // namespace
}  // namespace tetloft::test
