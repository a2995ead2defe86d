#include "between/class_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "unit/between/class_shapes.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
using motion::LatticeWindow;

namespace {

double area(const ClassShape& shape, std::size_t layer) {
  const std::vector<double>& value = shape.value[layer];
  return static_cast<double>(
      std::count_if(value.begin(), value.end(), [](double v) { return v < 0; }));
}

Point2 centroid(const ClassShape& shape, std::size_t layer) {
  const LatticeWindow& w = shape.window;
  Point2 sum;
  for (std::int64_t j = w.j0; j < w.j1; ++j) {
    for (std::int64_t i = w.i0; i < w.i1; ++i) {
      if (!(shape.value[layer][w.place(i, j)] < 0)) continue;
      sum.x += static_cast<double>(i);
      sum.y += static_cast<double>(j);
    }
  }
  return {sum.x / area(shape, layer), sum.y / area(shape, layer)};
}

// Distance to the contours, negative inside, by looking at all edges.
double brute_force(const std::vector<Contour>& contours, const Point2& p) {
  double least = 1e300;
  bool inside = false;
  for (const Contour& contour : contours) {
    Point2 a = contour.vertices.back();
    for (const Point2& b : contour.vertices) {
      const Point2 d{b.x - a.x, b.y - a.y};
      const double t =
          std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
      least = std::min(least, std::hypot(p.x - a.x - t * d.x, p.y - a.y - t * d.y));
      if ((a.y <= p.y) != (b.y <= p.y) && p.x > a.x + (p.y - a.y) / d.y * d.x) inside = !inside;
      a = b;
    }
  }
  return inside ? -least : least;
}

void expect_equal(const ClassShape& a, const ClassShape& b) {
  EXPECT_EQ(a.window.i0, b.window.i0);
  EXPECT_EQ(a.window.j0, b.window.j0);
  EXPECT_EQ(a.window.i1, b.window.i1);
  EXPECT_EQ(a.window.j1, b.window.j1);
  EXPECT_TRUE(a.value == b.value);
  EXPECT_TRUE(a.motion == b.motion);
}

TEST(ClassShape, GivenLayersAreDistancesToTheirContours) {
  const OwnedClass shape = branching();
  const double step = 0.7;
  const ClassShape got = shape.at({0.25, 0.5}, step);
  ASSERT_EQ(got.value.size(), 4U);
  const double near = 0.7 * 6 / step;
  for (const auto& [layer, section] : {std::pair(std::size_t{0}, lower), {std::size_t{3}, upper}}) {
    for (std::int64_t j = got.window.j0; j < got.window.j1; ++j) {
      for (std::int64_t i = got.window.i0; i < got.window.i1; ++i) {
        const Point2 p{static_cast<double>(i) * step, static_cast<double>(j) * step};
        const double want = brute_force(shape.contours[section], p) / step;
        const double value = got.value[layer][got.window.place(i, j)];
        EXPECT_EQ(value < 0, want < 0) << i << ' ' << j;
        if (std::abs(want) < near) {
          EXPECT_NEAR(value, want, 1e-9) << i << ' ' << j;
        } else {
          EXPECT_GE(std::abs(value), near - 1e-9) << i << ' ' << j;
        }
      }
    }
  }
}

TEST(ClassShape, ATranslatedDiscIsHalfWayInTheMiddle) {
  const OwnedClass shape = discs({{{-6, -2}, {0, 0}, {6, 2}, {12, 4}}}, {4, 4, 4, 4});
  const ClassShape got = shape.at({0.5});
  EXPECT_NEAR(centroid(got, 1).x, 3, 0.35);
  EXPECT_NEAR(centroid(got, 1).y, 1, 0.35);
  EXPECT_NEAR(area(got, 1), 16 * 3.14, 6);
}

TEST(ClassShape, AGrowingDiscGrowsBetween) {
  const OwnedClass shape = discs({}, {6, 8, 10, 12});
  const ClassShape got = shape.at({0.25, 0.5, 0.75});
  for (const std::size_t layer : {1U, 2U, 3U}) {
    const double radius = 8 + 0.5 * static_cast<double>(layer);
    EXPECT_NEAR(area(got, layer), radius * radius * 3.14159, 6) << layer;
  }
}

TEST(ClassShape, ARigidMotionMovesAsAWhole) {
  const OwnedClass shape = discs({{{}, {0, 0}, {20, 0}, {}}}, {0, 5, 5, 0});
  const ClassShape got = interpolate(shape.outlines(), 1, {0.5}, Point2{20, 0});
  EXPECT_NEAR(centroid(got, 1).x, 10, 1e-9);
  EXPECT_NEAR(centroid(got, 1).y, 0, 1e-9);
  EXPECT_GE(area(got, 1), area(got, 0));
  for (const Point2& u : got.motion) EXPECT_EQ(u, (Point2{20, 0}));
}

TEST(ClassShape, AClassOfOneSectionRoundsOff) {
  const OwnedClass up = discs({}, {9, 7, 0, 0});
  const ClassShape got = up.at({0.25, 0.5, 0.75});
  EXPECT_GT(area(got, 0), area(got, 1));
  EXPECT_GT(area(got, 1), area(got, 2));
  EXPECT_GE(area(got, 2), area(got, 3));
  EXPECT_GT(area(got, 1), 0.5 * area(got, 0));
  EXPECT_EQ(area(got, 4), 0);
}

TEST(ClassShape, WhatBothSectionsShareAtRestStays) {
  OwnedClass shape;
  shape.z[lower] = 0;
  shape.z[upper] = 5;
  shape.contours[lower] = {box({-20, -3}, {20, 3})};
  shape.contours[upper] = {box({-3, -20}, {3, 20})};
  const ClassShape got = interpolate(shape.outlines(), 1, {0.3, 0.5}, Point2{});
  for (std::size_t k = 0; k < got.window.size(); ++k) {
    const double most = std::max(got.value.front()[k], got.value.back()[k]);
    if (most < -1e-6) {
      EXPECT_LT(got.value[1][k], 0);
      EXPECT_LT(got.value[2][k], 0);
    }
  }
}

TEST(ClassShape, IsTheSameUpsideDown) {
  const OwnedClass shape = branching();
  const ClassShape up = shape.at({0.25, 0.5, 0.75});
  const ClassShape down = shape.upside_down().at({0.25, 0.5, 0.75});
  EXPECT_EQ(up.window.i0, down.window.i0);
  EXPECT_EQ(up.window.j0, down.window.j0);
  ASSERT_EQ(up.window.size(), down.window.size());
  for (std::size_t layer = 0; layer < 5; ++layer) {
    for (std::size_t k = 0; k < up.window.size(); ++k) {
      EXPECT_NEAR(up.value[layer][k], down.value[4 - layer][k], 1e-9) << layer << ' ' << k;
    }
  }
  for (std::size_t k = 0; k < up.window.size(); ++k) {
    EXPECT_NEAR(up.motion[k].x, -down.motion[k].x, 1e-9);
    EXPECT_NEAR(up.motion[k].y, -down.motion[k].y, 1e-9);
  }
}

TEST(ClassShape, DependsNeitherOnOrderNorOnStartNorOnDirection) {
  const OwnedClass shape = branching();
  OwnedClass other = shape;
  for (std::vector<Contour>& contours : other.contours) {
    std::reverse(contours.begin(), contours.end());
    for (Contour& contour : contours) {
      std::rotate(contour.vertices.begin(), contour.vertices.begin() + 5, contour.vertices.end());
      std::reverse(contour.vertices.begin(), contour.vertices.end());
    }
  }
  expect_equal(shape.at({0.25, 0.5}), other.at({0.25, 0.5}));
}

TEST(ClassShape, ScalesByPowersOfTwo) {
  const OwnedClass shape = branching();
  for (const double scale : {0x1p-30, 2.0, 0x1p70}) {
    expect_equal(shape.at({0.25, 0.5}), shape.scaled(scale).at({0.25, 0.5}, scale));
  }
}

TEST(ClassShape, ItsBorderIsOutsideAndNoValueIsZero) {
  std::vector<OwnedClass> shapes{branching(), discs({}, {0, 5, 0, 0}), discs({}, {0, 5, 5, 0}),
                                 discs({}, {0, 0, 5, 20}),
                                 discs({{{}, {0, 0}, {9, 9}, {}}}, {0, 2, 2, 0})};
  for (const OwnedClass& shape : shapes) {
    for (const double step : {0.4, 1.0, 5.0}) {
      const ClassShape got = shape.at({0.2, 0.5, 0.9}, step);
      const LatticeWindow& w = got.window;
      ASSERT_TRUE(got.motion.empty() || got.motion.size() == w.size());
      for (const std::vector<double>& value : got.value) {
        ASSERT_EQ(value.size(), w.size());
        EXPECT_EQ(std::count(value.begin(), value.end(), 0.0), 0);
        for (std::int64_t i = w.i0; i < w.i1; ++i) {
          EXPECT_GT(value[w.place(i, w.j0)], 0);
          EXPECT_GT(value[w.place(i, w.j1 - 1)], 0);
        }
        for (std::int64_t j = w.j0; j < w.j1; ++j) {
          EXPECT_GT(value[w.place(w.i0, j)], 0);
          EXPECT_GT(value[w.place(w.i1 - 1, j)], 0);
        }
      }
    }
  }
}

TEST(ClassShape, ABallIsRoundWhereTheStackEnds) {
  // A ball of radius 12 about height 9, cut at 6, 12 and 18; the first section is the stack's.
  OwnedClass ball;
  for (const auto& [s, z] : {std::pair(lower, 6.0), {upper, 12.0}, {beyond, 18.0}}) {
    ball.z[s] = z;
    ball.contours[s] = {circle({}, std::sqrt(144 - (z - 9) * (z - 9)))};
  }
  const ClassShape got = ball.at({0.5});
  EXPECT_GT(area(got, 1), area(got, 0));
  EXPECT_NEAR(area(got, 1), 144 * 3.14159, 36);
}

TEST(ClassShape, TakesNoLongerWindowThanItNeeds) {
  // A gap a hundred times as high as the class is wide.
  OwnedClass needle = discs({}, {4, 4, 4, 0});
  for (std::size_t s = 0; s < 4; ++s) needle.z[s] = 800 * static_cast<double>(s);
  const ClassShape got = needle.at({0.5});
  EXPECT_LE(got.window.nx(), 60U);
  EXPECT_LE(got.window.ny(), 60U);
  EXPECT_GT(area(got, 1), 30);
}

TEST(ClassShape, IsNoneWhereDoublesMeasureTooCoarsely) {
  const OwnedClass shape = discs({}, {5, 5, 5, 5});
  EXPECT_TRUE(shape.at({0.5}, 0x1p-40).value.empty());
}

}  // namespace

}  // namespace tetloft::testing
