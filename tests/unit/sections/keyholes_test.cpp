// Channels that repair() closes, and narrow places that it must not close.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <tetloft/nesting.hpp>

#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

Repaired closed(const std::vector<Contour>& contours, double width) {
  Result<Repaired> result = repair(one(contours), {.keyholes = width});
  EXPECT_TRUE(result.ok()) << to_string(result.error());
  return result.ok() ? *result : Repaired{};
}

const Section& section_of(const Repaired& result) { return result.stack.sections[SectionId(0)]; }

// A square of 10 with a hole of 4 and a channel along y from 4.9 to 5.1.
Contour keyholed_square() {
  return contour({{0, 0},
                  {10, 0},
                  {10, 4.9},
                  {7, 4.9},
                  {7, 3},
                  {3, 3},
                  {3, 7},
                  {7, 7},
                  {7, 5.1},
                  {10, 5.1},
                  {10, 10},
                  {0, 10}});
}

TEST(Keyholes, AreClosedUpToTheWidthAndNoFurther) {
  const Repaired result = closed({keyholed_square()}, 0.25);
  EXPECT_EQ(result.channels, 1U);
  ASSERT_EQ(section_of(result).contours.size(), 2U);
  EXPECT_NEAR(result.area_after, 84, 1e-12);
  EXPECT_NEAR(result.area_before, 84 - 0.6, 1e-12);
  EXPECT_EQ(nest(section_of(result)).depth[ContourId(1)], 1U);
  EXPECT_NE(to_string(result.changes.back()).find("channel closed, 0.2 wide and 3 long"),
            std::string::npos)
      << to_string(result.changes.back());
  EXPECT_EQ(closed({keyholed_square()}, 0.19).channels, 0U);
  EXPECT_EQ(closed({keyholed_square()}, 0.19).stack.contour_count(), 1U);
}

TEST(Keyholes, DependOnNeitherStartNorDirection) {
  const Contour given = keyholed_square();
  for (std::size_t by = 0; by < given.vertices.size(); ++by) {
    for (const Contour& other : {rotated(given, by), reversed(rotated(given, by))}) {
      const Repaired result = closed({other}, 0.25);
      EXPECT_EQ(section_of(result).contours.size(), 2U);
      EXPECT_NEAR(result.area_after, 84, 1e-12);
    }
  }
}

TEST(Keyholes, LinkTwoHolesToo) {
  // A hole within a square: two rooms of it, and a channel from one to the other.
  const Contour rooms = contour({{1, 3},
                                 {4, 3},
                                 {4, 4.9},
                                 {6, 4.9},
                                 {6, 3},
                                 {9, 3},
                                 {9, 7},
                                 {6, 7},
                                 {6, 5.1},
                                 {4, 5.1},
                                 {4, 7},
                                 {1, 7}});
  const Repaired result = closed({rectangle(0, 0, 10, 10), rooms}, 0.25);
  EXPECT_EQ(section_of(result).contours.size(), 3U);
  EXPECT_NEAR(result.area_after, 76, 1e-12);
}

TEST(Keyholes, BetweenPlacesWhoseCornersAreNotOppositeAreClosed) {
  // Walls of vertices that have none across: ends lie on edges.
  const Contour skew = contour({{0, 0},
                                {10, 0},
                                {10, 4.9},
                                {7.4, 4.9},
                                {7, 3},
                                {3, 3},
                                {3, 7},
                                {7, 7},
                                {7, 5.1},
                                {10.5, 5.1},
                                {10, 10},
                                {0, 10}});
  const Repaired result = closed({skew}, 0.25);
  EXPECT_EQ(result.channels, 1U);
  EXPECT_EQ(section_of(result).contours.size(), 2U);
  EXPECT_TRUE(validate(result.stack).ok());
}

TEST(Keyholes, OfOneVoxelAreClosed) {
  // Steps of a voxel, as a slanted line of them is cut out.
  const Contour steps = contour({{0, 0},  {20, 0}, {20, 9},  {18, 9},  {18, 8},  {16, 8}, {16, 7},
                                 {14, 7}, {14, 5}, {6, 5},   {6, 15},  {14, 15}, {14, 8}, {15, 8},
                                 {15, 9}, {17, 9}, {17, 10}, {20, 10}, {20, 20}, {0, 20}});
  EXPECT_EQ(closed({steps}, 0.9).channels, 0U);
  const Repaired result = closed({steps}, 1.5);
  EXPECT_EQ(result.channels, 1U);
  EXPECT_EQ(section_of(result).contours.size(), 2U);
  EXPECT_EQ(result.area_after, 400 - 80);
}

TEST(Keyholes, SlitsThatEndBlindlyStay) {
  const Contour slit =
      contour({{0, 0}, {10, 0}, {10, 4.9}, {3, 4.9}, {3, 5.1}, {10, 5.1}, {10, 10}, {0, 10}});
  EXPECT_EQ(closed({slit}, 0.3).channels, 0U);
  // With vertices all along.
  Contour fine;
  for (int k = 0; k <= 40; ++k) fine.vertices.push_back({10 - 0.2 * k, 4.9});
  for (int k = 40; k >= 0; --k) fine.vertices.push_back({10 - 0.2 * k, 5.1});
  for (const Point2 p : {Point2{10, 10}, Point2{0, 10}, Point2{0, 0}, Point2{10, 0}}) {
    fine.vertices.push_back(p);
  }
  EXPECT_EQ(closed({fine}, 0.3).channels, 0U);
  EXPECT_EQ(closed({fine}, 0.3).stack.sections[SectionId(0)].contours[ContourId(0)].vertices,
            fine.vertices);
}

TEST(Keyholes, PlacesBetweenTwoContoursStay) {
  const Repaired two = closed({rectangle(0, 0, 5, 5), rectangle(5.1, 0, 9, 5)}, 0.5);
  EXPECT_EQ(two.channels, 0U);
  // A channel in which another body lies, all along it.
  const Contour plug = rectangle(7.5, 4.99, 9.5, 5.01);
  EXPECT_EQ(closed({keyholed_square(), plug}, 0.25).channels, 0U);
}

TEST(Keyholes, NarrowPlacesWithoutLengthStay) {
  // Two corners that nearly meet, point against point.
  const Contour jaws = contour({{0, 0},
                                {10, 0},
                                {10, 4},
                                {8, 4.95},
                                {6, 3},
                                {3, 3},
                                {3, 7},
                                {6, 7},
                                {8, 5.05},
                                {10, 6},
                                {10, 10},
                                {0, 10}});
  EXPECT_EQ(closed({jaws}, 0.2).channels, 0U);
}

TEST(Keyholes, AWidthMustBeAboveZero) {
  for (const double bad : {0.0, -1.0, static_cast<double>(INFINITY)}) {
    const auto refused = repair(one({keyholed_square()}), {.keyholes = bad});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
  }
}

}  // namespace
}  // namespace tetloft::testing
