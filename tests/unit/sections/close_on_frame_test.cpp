// Open level lines closed along a rectangle: which side is solid, where lines may end, and what
// independent counting says of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>
#include <tetloft/repair.hpp>

#include "support/stacks/height_fields.hpp"

namespace tetloft {

using namespace internal;
namespace {

using testing::LevelLines;

// Lines, all of them open.
LevelLines lines_of(const std::vector<std::vector<std::vector<Point2>>>& levels) {
  LevelLines lines;
  for (const auto& level : levels) {
    const SectionId s =
        lines.stack.sections.push_back({static_cast<double>(lines.stack.sections.size()), {}});
    for (const std::vector<Point2>& line : level) {
      lines.open.push_back({s, lines.stack.sections[s].contours.push_back({line})});
    }
  }
  return lines;
}

FrameOptions frame(double x0, double y0, double x1, double y1) {
  FrameOptions options;
  options.corners = std::array<Point2, 2>{Point2{x0, y0}, Point2{x1, y1}};
  return options;
}

ClosedOnFrame closed(const LevelLines& lines, const FrameOptions& options = {}) {
  Result<ClosedOnFrame> result = close_on_frame(lines.stack, lines.open, options);
  if (!result) {
    ADD_FAILURE() << to_string(result.error());
    return {};
  }
  const Result<void> valid = validate(result->stack);
  EXPECT_TRUE(valid.ok()) << to_string(valid.error());
  return *std::move(result);
}

double area_of(const Section& section) {
  if (section.contours.empty()) return 0;
  double sum = 0;
  for (const RegionOutline& region : outlines(section, nest(section))) sum += area(region);
  return sum;
}

std::vector<double> areas_of(const SectionStack& stack) {
  std::vector<double> areas;
  for (const Section& section : stack.sections)
    areas.push_back(std::round(1e6 * area_of(section)) / 1e6);
  return areas;
}

bool says(const std::vector<Warning>& warnings, const std::string& text) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) {
    return warning.message.find(text) != std::string::npos;
  });
}

// A ramp across the square of side 8: lines x = 2, 4, 6, whichever way they run.
std::vector<std::vector<std::vector<Point2>>> ramp(bool rises) {
  const auto line = [](double x, bool up) {
    return std::vector<Point2>{{x, up ? 0.0 : 8.0}, {x + 0.5, 4}, {x, up ? 8.0 : 0.0}};
  };
  std::vector<std::vector<std::vector<Point2>>> levels{
      {line(2, true)}, {line(4, false)}, {line(6, true)}};
  if (!rises) std::reverse(levels.begin(), levels.end());
  return levels;
}

TEST(CloseOnFrame, TakesTheSideOnWhichHigherLevelsLie) {
  const ClosedOnFrame up = closed(lines_of(ramp(true)), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(up.stack), (std::vector<double>{46, 30, 14}));
  const ClosedOnFrame down = closed(lines_of(ramp(false)), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(down.stack), (std::vector<double>{50, 34, 18}));
  for (const ClosedOnFrame* result : {&up, &down}) {
    EXPECT_FALSE(says(result->changes, "nothing tells"));
    EXPECT_FALSE(says(result->changes, "not level lines"));
    EXPECT_TRUE(says(result->changes, "3 open lines closed along the rectangle"));
  }
}

TEST(CloseOnFrame, GoesRoundAllCorners) {
  // A pit at the middle of the lower side: all corners are solid; a summit there: none is.
  const std::vector<Point2> wide{{1, 0}, {4, 5}, {7, 0}};
  const std::vector<Point2> narrow{{3, 0}, {4, 2}, {5, 0}};
  const ClosedOnFrame pit = closed(lines_of({{narrow}, {wide}}), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(pit.stack), (std::vector<double>{62, 49}));
  EXPECT_EQ(pit.stack.sections[SectionId(0)].contours[ContourId(0)].vertices.size(), 7U);
  const ClosedOnFrame summit = closed(lines_of({{wide}, {narrow}}), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(summit.stack), (std::vector<double>{15, 2}));
}

TEST(CloseOnFrame, KnowsCornersThatLinesEndIn) {
  const std::vector<Point2> diagonal{{0, 0}, {8, 8}};
  const std::vector<Point2> corner{{4, 0}, {8, 4}};
  const ClosedOnFrame result = closed(lines_of({{diagonal}, {corner}}), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(result.stack), (std::vector<double>{32, 8}));
  EXPECT_EQ(result.stack.sections[SectionId(0)].contours[ContourId(0)].vertices.size(), 3U);
}

TEST(CloseOnFrame, LetsClosedContoursTellOfLevelsWithoutLines) {
  // A summit above a ramp, and a hollow below one: the lowest level is the whole rectangle but for
  // the hollow.
  LevelLines lines = lines_of({{}, {ramp(true)[0][0]}, {}});
  const auto square = [](double x, double y) {
    return Contour{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  };
  lines.stack.sections[SectionId(0)].contours.push_back(square(0.5, 3));
  lines.stack.sections[SectionId(2)].contours.push_back(square(5, 5));
  const ClosedOnFrame result = closed(lines, frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(result.stack), (std::vector<double>{63, 46, 1}));
  EXPECT_FALSE(result.origin[SectionId(0)][ContourId(1)].valid());
  EXPECT_TRUE(says(result.changes, "holds all of it"));
}

TEST(CloseOnFrame, FallsBackWhereNothingTells) {
  const ClosedOnFrame result = closed(lines_of({{ramp(true)[0][0]}}), frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(result.stack), (std::vector<double>{46}));
  EXPECT_TRUE(says(result.changes, "nothing tells on which side"));
}

TEST(CloseOnFrame, TellsOfLinesThatAreNoLevels) {
  // The lines of the middle level on both sides of those around it.
  const std::vector<Point2> left{{1, 0}, {1, 8}};
  const std::vector<Point2> right{{7, 0}, {7, 8}};
  const std::vector<Point2> low{{0, 4}, {8, 4}};
  const ClosedOnFrame result = closed(lines_of({{left}, {low}, {right}}), frame(0, 0, 8, 8));
  EXPECT_TRUE(says(result.changes, "not level lines of one height"));
}

TEST(CloseOnFrame, TakesSidesWithoutEndsFartherOut) {
  LevelLines lines = lines_of({{{{0, 2}, {4, 1}, {8, 2}}}, {{{0, 5}, {4, 7}, {8, 5}}}});
  const ClosedOnFrame result = closed(lines);
  EXPECT_EQ(result.low, (Point2{0, 0.5}));
  EXPECT_EQ(result.high, (Point2{8, 7.5}));
  EXPECT_TRUE(says(result.changes, "2 sides"));
}

TEST(CloseOnFrame, DropsWhatRunsAlongTheFrame) {
  const LevelLines lines =
      lines_of({{{{0, 0}, {2, 0}, {2, 8}, {5, 8}}, {{8, 1}, {8, 3}, {8, 5}}}, {{{4, 0}, {4, 8}}}});
  const ClosedOnFrame result = closed(lines, frame(0, 0, 8, 8));
  EXPECT_EQ(areas_of(result.stack), (std::vector<double>{48, 32}));
  EXPECT_TRUE(says(result.changes, "only run along"));
}

TEST(CloseOnFrame, RefusesLinesThatEndElsewhere) {
  const auto refusal = [](const LevelLines& lines, const FrameOptions& options) {
    const Result<ClosedOnFrame> result = close_on_frame(lines.stack, lines.open, options);
    return result ? Error{} : result.error();
  };
  const Error inside =
      refusal(lines_of({{{{0, 1}, {4, 4}}}, {{{0, 5}, {8, 5}}}}), frame(0, 0, 8, 8));
  EXPECT_EQ(inside.code, ErrorCode::invalid_input);
  EXPECT_EQ(inside.where.section, 0U);
  EXPECT_EQ(inside.where.vertex, 1U);
  EXPECT_NE(inside.message.find("ends here, and not on the rectangle from (0, 0) to (8, 8)"),
            std::string::npos);
  EXPECT_EQ(refusal(lines_of({{{{0, 1}, {9, 4}}}}), frame(0, 0, 8, 8)).where.vertex, 1U);
  const Error twice = refusal(lines_of({{{{0, 1}, {8, 1}}, {{0, 1}, {8, 4}}}}), frame(0, 0, 8, 8));
  EXPECT_NE(twice.message.find("in one point"), std::string::npos);
  EXPECT_EQ(refusal(lines_of({{{{0, 1}}}}), frame(0, 0, 8, 8)).code, ErrorCode::invalid_input);
  EXPECT_EQ(refusal(lines_of({{{{0, 1}, {8, 1}}}}), frame(0, 0, 0, 8)).code, ErrorCode::usage);
  LevelLines stray = lines_of({{{{0, 1}, {8, 1}}}});
  stray.open.push_back({SectionId(7), ContourId(0)});
  EXPECT_EQ(refusal(stray, {}).code, ErrorCode::usage);
}

TEST(CloseOnFrame, LeavesAStackWithoutOpenLines) {
  LevelLines lines = lines_of({{{{0, 0}, {1, 0}, {0, 1}}}});
  lines.open.clear();
  const ClosedOnFrame result = closed(lines);
  EXPECT_EQ(result.stack.contour_count(), 1U);
  EXPECT_EQ(result.origin[SectionId(0)][ContourId(0)], ContourId(0));
  EXPECT_TRUE(result.changes.empty());
}

// Against the field itself: its lattice points, and the area that its cells have above a level.
TEST(CloseOnFrame, IsTheRegionAboveALevelOfRandomFields) {
  std::size_t with_open = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Prng prng(seed);
    const testing::HeightField field = testing::random_field(prng);
    const LevelLines lines = testing::level_lines(prng, field);
    if (lines.open.empty()) continue;
    ++with_open;
    const Result<ClosedOnFrame> result = close_on_frame(
        lines.stack, lines.open, frame(0, 0, field.width(), field.height_of_frame()));
    ASSERT_TRUE(result.ok()) << seed << to_string(result.error());
    ASSERT_FALSE(says(result->changes, "not level lines")) << seed;
    if (says(result->changes, "nothing tells")) continue;
    for (const Section& section : result->stack.sections) {
      EXPECT_NEAR(area_of(section), testing::area_above(field, section.z), 1e-9)
          << seed << " at " << section.z;
    }
  }
  EXPECT_GT(with_open, 150U);
}

}  // namespace
}  // namespace tetloft
