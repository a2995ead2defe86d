// Fill rules of repair(), copies, and areas that are told.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using Contours = std::vector<Contour>;

Repaired filled(const Contours& contours, FillRule fill) {
  Result<Repaired> result = repair(one(contours), {.fill = fill});
  EXPECT_TRUE(result.ok()) << to_string(result.error());
  return result.ok() ? *result : Repaired{};
}

std::size_t contours_in(const Repaired& result) {
  return result.stack.sections[SectionId(0)].contours.size();
}

bool tells(const Repaired& result, const std::string& words) {
  return std::any_of(result.changes.begin(), result.changes.end(), [&](const Warning& warning) {
    return warning.message.find(words) != std::string::npos;
  });
}

TEST(Fill, TracesThatOverlapAreUnited) {
  const Contours two{rectangle(0, 0, 10, 10), rectangle(6, 3, 16, 13)};
  const Repaired united = filled(two, FillRule::unite);
  EXPECT_EQ(contours_in(united), 1U);
  EXPECT_EQ(united.area_before, 172);
  EXPECT_EQ(united.area_after, 172);
  EXPECT_EQ(united.moved, 0);
  EXPECT_TRUE(tells(united, "overlaps contour 1 and is united"));
  const Repaired odd = filled(two, FillRule::odd);
  EXPECT_NEAR(odd.area_after, 144, 1e-3);
  EXPECT_TRUE(tells(odd, "overlaps contour 1, and what lies in both is left out"));
}

TEST(Fill, AHoleOfUnitedTracesStays) {
  const Contours holed{rectangle(0, 0, 10, 10), rectangle(5, 0.5, 15, 9.5), rectangle(7, 4, 8, 5)};
  const Repaired united = filled(holed, FillRule::unite);
  EXPECT_EQ(contours_in(united), 2U);
  EXPECT_EQ(united.area_after, 100 + 90 - 45 - 1);
  // Two traces of the hole, too.
  Contours again = holed;
  again.push_back(rectangle(7.5, 4.5, 8.5, 5.5));
  EXPECT_EQ(filled(again, FillRule::unite).area_after, 100 + 90 - 45 - 1.75);
}

TEST(Fill, AContourThatTouchesFromInsideIsAHoleAndNotUnited) {
  const Repaired united = filled({rectangle(0, 0, 10, 10), rectangle(0, 2, 4, 5)}, FillRule::unite);
  EXPECT_EQ(united.area_after, 88);
  const Repaired cornered =
      filled({rectangle(0, 0, 4, 4), contour({{2, 0}, {3, 2}, {1, 2}})}, FillRule::unite);
  EXPECT_NEAR(cornered.area_after, 14, 1e-4);
}

TEST(Fill, NeighboursThatShareASideBecomeOneByAnyRule) {
  for (const FillRule fill : {FillRule::odd, FillRule::unite, FillRule::winding}) {
    const Repaired result = filled({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}, fill);
    EXPECT_EQ(contours_in(result), 1U);
    EXPECT_EQ(result.area_after, 2);
  }
}

TEST(Fill, ALoopGoneTwiceIsInsideByUnionAndWinding) {
  const Contour twice =
      contour({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 3}});
  for (const FillRule fill : {FillRule::unite, FillRule::winding}) {
    EXPECT_NEAR(filled({twice}, fill).area_after, 9, 1e-3);
  }
}

TEST(Fill, WindingAsksWhichWayContoursRun) {
  const Contour outline = rectangle(0, 0, 4, 4);
  const Contour inner = rectangle(1, 1, 2, 2);
  EXPECT_EQ(filled({outline, reversed(inner)}, FillRule::winding).area_after, 15);
  const Repaired same = filled({outline, inner}, FillRule::winding);
  EXPECT_EQ(same.area_after, 16);
  EXPECT_EQ(contours_in(same), 1U);
  EXPECT_TRUE(tells(same, "the region has both sides of it"));
  EXPECT_EQ(filled({outline, inner}, FillRule::odd).area_after, 15);
  EXPECT_EQ(filled({outline, inner}, FillRule::unite).area_after, 15);
}

TEST(Fill, OtherRulesAreRefused) {
  const auto refused = repair(one({rectangle(0, 0, 1, 1)}), {.fill = static_cast<FillRule>(3)});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::usage);
}

TEST(Copies, OfWhateverStartAndDirectionAreKeptOnce) {
  const Contour given = contour({{0, 0}, {4, 0}, {5, 3}, {1, 4}});
  const Repaired result =
      filled({given, rotated(given, 2), reversed(rotated(given, 1))}, FillRule::odd);
  ASSERT_EQ(contours_in(result), 1U);
  EXPECT_EQ(result.stack.sections[SectionId(0)].contours[ContourId(0)].vertices, given.vertices);
  EXPECT_EQ(result.copies, 2U);
  EXPECT_EQ(result.area_before, result.area_after);
  EXPECT_TRUE(tells(result, "a copy of contour 0 left out"));
}

TEST(Copies, ThatDifferByRoundingAreKeptOnceTheLargerOne) {
  const Contour exact = rectangle(0, 0, 10, 10);
  const Contour rounded = contour({{0, 0}, {10, 0.001}, {10, 10}, {0, 9.999}});
  for (const Contours& both : {Contours{exact, rounded}, Contours{rounded, exact}}) {
    const Repaired result = filled(both, FillRule::odd);
    EXPECT_EQ(contours_in(result), 1U);
    EXPECT_EQ(result.area_after, 100);
    EXPECT_TRUE(tells(result, "but for 0.001, left out"));
  }
}

TEST(Copies, AreNoThinPartsBesideEachOther) {
  // Their vertices are near each other, for their length; but they share nothing.
  const Repaired strips =
      filled({rectangle(0, 0, 1000, 0.5), rectangle(0, 0.5, 1000, 1)}, FillRule::odd);
  EXPECT_EQ(strips.copies, 0U);
  EXPECT_EQ(strips.area_after, 1000);
  const Repaired shell =
      filled({rectangle(0, 0, 10, 10), contour({{0, 0}, {9.5, 0.5}, {9.5, 9.5}, {0.5, 9.5}})},
             FillRule::odd);
  EXPECT_EQ(shell.copies, 0U);
}

}  // namespace
}  // namespace tetloft::testing
