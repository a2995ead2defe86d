#include "between/marching.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/section_stack.hpp>

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

// A picture, its first row on top: '#' is −1, '.' is 1.
struct Picture {
  motion::LatticeWindow window;
  std::vector<double> value;

  explicit Picture(const std::vector<std::string>& rows) {
    const auto ny = static_cast<std::int64_t>(rows.size());
    window = {0, 0, static_cast<std::int64_t>(rows[0].size()), ny};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      for (const char c : *row) value.push_back(c == '#' ? -1 : 1);
    }
  }
  [[nodiscard]] std::vector<TracedContour> traced(double step = 1) const {
    return trace_contours(window, value, step);
  }
};

double area(const std::vector<TracedContour>& contours) {
  double sum = 0;
  for (const TracedContour& c : contours) sum += twice_area(c.contour) / 2;
  return sum;
}

TEST(Marching, OneSampleBecomesADiamond) {
  const auto contours = Picture({"...", ".#.", "..."}).traced(2);
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_EQ(contours[0].contour.vertices, (std::vector<Point2>{{1, 2}, {2, 1}, {3, 2}, {2, 3}}));
  EXPECT_EQ(contours[0].sample, 4U);
}

TEST(Marching, InsidesAcrossADiagonalAreParted) {
  EXPECT_EQ(Picture({"....", ".#..", "..#.", "...."}).traced().size(), 2U);
  EXPECT_EQ(Picture({"....", "..#.", ".#..", "...."}).traced().size(), 2U);
  EXPECT_EQ(Picture({".....", ".#.#.", "..#..", ".#.#.", "....."}).traced().size(), 5U);
}

TEST(Marching, OutsidesAcrossADiagonalAreOne) {
  const auto contours =
      Picture({"......", ".####.", ".#.##.", ".##.#.", ".####.", "......"}).traced();
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_GT(twice_area(contours[0].contour), 0);
  EXPECT_LT(twice_area(contours[1].contour), 0);
}

TEST(Marching, HolesRunTheOtherWayAndNameASampleOfTheirPart) {
  const Picture picture(
      {".........", ".#####...", ".#...#.#.", ".#.#.#...", ".#...#...", ".#####...", "........."});
  const auto contours = picture.traced();
  ASSERT_EQ(contours.size(), 4U);
  EXPECT_DOUBLE_EQ(area(contours), 24.5 - 8.5 + 0.5 + 0.5);
  for (const TracedContour& c : contours) {
    EXPECT_LT(picture.value[c.sample], 0);
    for (std::size_t v = 1; v < c.contour.vertices.size(); ++v) {
      EXPECT_TRUE(canonical_less(c.contour.vertices[0], c.contour.vertices[v]));
    }
  }
  for (std::size_t c = 1; c < contours.size(); ++c) {
    EXPECT_TRUE(
        canonical_less(contours[c - 1].contour.vertices[0], contours[c].contour.vertices[0]));
  }
}

TEST(Marching, CrossingsAreLinearAndAwayFromSamples) {
  Picture picture({"...", ".#.", "..."});
  picture.window = {-1, 10, 2, 13};
  picture.value[4] = -3;
  picture.value[3] = 1;     // a quarter from the left
  picture.value[5] = 1e6;   // too near to the sample
  picture.value[1] = 1e-6;  // too far from it
  picture.value[7] = 3;
  const auto contours = picture.traced(0.5);
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_EQ(contours[0].contour.vertices,
            (std::vector<Point2>{{-0.375, 5.5}, {0, 5 + 0.5 / 64}, {0.5 / 64, 5.5}, {0, 5.75}}));
}

TEST(Marching, ADiscHasItsArea) {
  Picture picture({std::vector<std::string>(80, std::string(80, '.'))});
  for (std::int64_t j = 0; j < 80; ++j) {
    for (std::int64_t i = 0; i < 80; ++i) {
      const double x = static_cast<double>(i) - 40.3;
      const double y = static_cast<double>(j) - 39.6;
      picture.value[picture.window.place(i, j)] = std::sqrt(x * x + y * y) - 30.2;
    }
  }
  EXPECT_NEAR(area(picture.traced()) / (3.14159265 * 30.2 * 30.2), 1, 5e-4);
}

}  // namespace
}  // namespace tetloft::testing
