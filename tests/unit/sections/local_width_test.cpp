// The width of a section at the middle of an edge, against discs drawn by hand and by samples.
#include "sections/local_width.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/stacks/shapes.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
using sections::LocalWidth;
namespace {

constexpr double kWide = 1e6;

TEST(LocalWidth, OfARectangleIsItsShorterSide) {
  const LocalWidth width(section(0, {rectangle(0, 0, 8, 2)}));
  EXPECT_EQ(width.at_middle({0, 0}, {8, 0}, kWide), 2);
  EXPECT_EQ(width.at_middle({8, 2}, {0, 2}, kWide), 2);
  EXPECT_EQ(width.at_middle({0, 0}, {0, 2}, kWide), 2);
  EXPECT_EQ(width.at_middle({0, 0}, {8, 0}, 1.5), 1.5);
}

TEST(LocalWidth, IsThatOfTheNarrowerSide) {
  const LocalWidth width(section(0, {rectangle(0, 0, 4, 4), rectangle(0, 5, 4, 9)}));
  EXPECT_EQ(width.at_middle({0, 4}, {4, 4}, kWide), 1);
  EXPECT_EQ(width.at_middle({0, 0}, {4, 0}, kWide), 4);
}

// The disc at the middle of a triangle's side is its inscribed one where the sides are equal.
TEST(LocalWidth, OfAnEquilateralTriangleIsItsInscribedDisc) {
  const double height = std::sqrt(3.0) / 2;
  const LocalWidth width(section(0, {contour({{0, 0}, {1, 0}, {0.5, height}})}));
  EXPECT_NEAR(width.at_middle({0, 0}, {1, 0}, kWide), 2 * height / 3, 1e-12);
}

// A vertex in the way: a disc through it, and touching.
TEST(LocalWidth, IsBoundedByVerticesThatReachIn) {
  const LocalWidth width(
      section(0, {contour({{-4, 0}, {4, 0}, {4, 8}, {0.5, 8}, {0, 1}, {-0.5, 8}, {-4, 8}})}));
  EXPECT_NEAR(width.at_middle({-4, 0}, {4, 0}, kWide), 1, 1e-12);
}

TEST(LocalWidth, DependsOnTheSetOfEdgesAlone) {
  Prng prng(11);
  for (int round = 0; round < 50; ++round) {
    std::vector<Contour> contours{random_star(prng, 0, 0, 40, 9), random_star(prng, 100, 0, 40, 7)};
    const LocalWidth width(section(0, contours));
    std::vector<Contour> others{reversed(rotated(contours[1], 3)), reversed(contours[0])};
    const LocalWidth other(section(0, others));
    for (const Contour& c : contours) {
      for (std::size_t k = 0; k < c.vertices.size(); ++k) {
        const Point2& a = c.vertices[k];
        const Point2& b = c.vertices[(k + 1) % c.vertices.size()];
        EXPECT_EQ(width.at_middle(a, b, kWide), other.at_middle(b, a, kWide));
      }
    }
  }
}

// No sample of another edge in the disc on either side; one in the disc on one side, if that is a
// little larger.
TEST(LocalWidth, IsThatOfTheLargestEmptyDisc) {
  Prng prng(12);
  for (int round = 0; round < 30; ++round) {
    const Contour star = blob(prng, {0, 0}, 1, 4, 4 + prng.below(8));
    const LocalWidth width(section(0, {star}));
    const std::size_t n = star.vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point2& a = star.vertices[k];
      const Point2& b = star.vertices[(k + 1) % n];
      const double w = width.at_middle(a, b, 20);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const Point2 normal{(b.y - a.y) / length, (a.x - b.x) / length};
      // How much nearer to the centre than the edge is a sample? Above 0: in the disc.
      const auto deepest = [&](double diameter) {
        double depth = -1;
        for (const double side : {-0.5, 0.5}) {
          const Point2 centre{(a.x + b.x) / 2 + side * diameter * normal.x,
                              (a.y + b.y) / 2 + side * diameter * normal.y};
          for (std::size_t j = 0; j < n; ++j) {
            if (j == k) continue;
            const Point2& p = star.vertices[j];
            const Point2& q = star.vertices[(j + 1) % n];
            for (int i = 0; i <= 1000; ++i) {
              const double t = i / 1000.0;
              depth = std::max(depth, diameter / 2 - std::hypot(p.x + t * (q.x - p.x) - centre.x,
                                                                p.y + t * (q.y - p.y) - centre.y));
            }
          }
        }
        return depth;
      };
      EXPECT_LT(deepest(w), 1e-9);
      if (w < 20) {
        EXPECT_GT(deepest(1.05 * w), 0);
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
