// DXF: polylines of both forms, arcs, closedness, planes seen from below, and what is left out.
#include <gtest/gtest.h>

#include <string>

#include "unit/drawings/stack_support.hpp"

namespace tetloft {
namespace {

using test::heights_of;
using test::says;

std::string groups(const std::vector<std::pair<int, std::string>>& all) {
  std::string text;
  for (const auto& [code, value] : all) text += "  " + std::to_string(code) + '\n' + value + '\n';
  return text;
}

std::string dxf(const std::string& entities, const std::string& before = "") {
  return groups({{0, "SECTION"}, {2, "HEADER"}, {9, "$INSUNITS"}, {70, "6"}, {0, "ENDSEC"}}) +
         before + groups({{0, "SECTION"}, {2, "ENTITIES"}}) + entities +
         groups({{0, "ENDSEC"}, {0, "EOF"}});
}

using Vertices = std::vector<std::vector<std::string>>;  // x, y, bulge if any
const Vertices kSquare{{"0", "0"}, {"4", "0"}, {"4", "4"}, {"0", "4"}};

std::string light(const std::string& z, const Vertices& vertices, const std::string& flags = "1",
                  const std::string& more = "") {
  std::string text = groups({{0, "LWPOLYLINE"},
                             {8, "contours"},
                             {90, std::to_string(vertices.size())},
                             {70, flags},
                             {38, z}}) +
                     more;
  for (const auto& v : vertices) {
    text += groups({{10, v[0]}, {20, v[1]}});
    if (v.size() > 2) text += groups({{42, v[2]}});
  }
  return text;
}

std::string heavy(const std::string& z, const Vertices& vertices, const std::string& flags = "1") {
  std::string text =
      groups({{0, "POLYLINE"}, {8, "c"}, {66, "1"}, {10, "0"}, {20, "0"}, {30, z}, {70, flags}});
  for (const auto& v : vertices) {
    text += groups({{0, "VERTEX"}, {10, v[0]}, {20, v[1]}, {30, v.size() > 2 ? v[2] : "0"}});
  }
  return text + groups({{0, "SEQEND"}});
}

ReadStack read(const std::string& text) {
  Result<ReadStack> stack = parse_stack(text, "a.dxf");
  if (!stack) {
    ADD_FAILURE() << to_string(stack.error()) << '\n' << text;
    return {};
  }
  return *std::move(stack);
}

std::string refusal(const std::string& text) { return test::refusal_of(text, {}, "a.dxf"); }

TEST(Dxf, ReadsPolylinesOfBothForms) {
  const ReadStack stack =
      read(dxf(light("350", kSquare) + heavy("375.5", kSquare) +
               heavy("0", {{"0", "0", "400"}, {"4", "0", "400"}, {"4", "4", "400"}}, "9")));
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{350, 375.5, 400}));
  EXPECT_EQ(stack.stack.vertex_count(), 11U);
  EXPECT_EQ(stack.stack.about.unit, "m");
}

TEST(Dxf, TakesAnyLineEnds) {
  const std::string text = dxf(light("1", kSquare));
  for (const std::string& end : {std::string("\r\n"), std::string("\r")}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read(other).stack.vertex_count(), 4U);
  }
  EXPECT_EQ(read("999\nmade by hand\n" + text).stack.vertex_count(), 4U);
}

TEST(Dxf, ClosesByFlagOrRepeatedVertex) {
  const Vertices ring{{"0", "0"}, {"4", "0"}, {"4", "4"}, {"0", "0"}};
  EXPECT_EQ(read(dxf(light("1", ring, "0"))).stack.vertex_count(), 3U);
  EXPECT_NE(refusal(dxf(light("1", kSquare, "0"))).find("a.dxf:16: contour 0: an open line"),
            std::string::npos)
      << refusal(dxf(light("1", kSquare, "0")));
}

TEST(Dxf, JoinsLines) {
  const auto line = [](const std::string& x0, const std::string& y0, const std::string& x1,
                       const std::string& y1) {
    return groups({{0, "LINE"}, {10, x0}, {20, y0}, {30, "2"}, {11, x1}, {21, y1}, {31, "2"}});
  };
  const ReadStack stack =
      read(dxf(line("0", "0", "4", "0") + line("4", "4", "4", "0") + line("4", "4", "0", "0")));
  EXPECT_EQ(stack.stack.contour_count(), 1U);
  EXPECT_EQ(stack.stack.vertex_count(), 3U);
}

TEST(Dxf, MakesArcsOfLineSegments) {
  // A disc of radius 1 as two half circles, one run the other way round.
  for (const char* bulge : {"1", "-1"}) {
    const ReadStack stack = read(dxf(light("1", {{"-1", "0", bulge}, {"1", "0", bulge}})));
    const auto& v = stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
    ASSERT_EQ(v.size(), 32U);
    for (const Point2& p : v) EXPECT_NEAR(p.x * p.x + p.y * p.y, 1, 1e-14);
    // A bulge is counter-clockwise.
    EXPECT_EQ(v[8].y < 0, *bulge == '1');
    EXPECT_TRUE(says(stack.warnings, "2 arcs are made of line segments"));
  }
  const ReadStack circle = read(dxf(
      groups({{0, "CIRCLE"}, {10, "1"}, {20, "2"}, {30, "3"}, {40, "5"}}) + light("9", kSquare)));
  EXPECT_EQ(circle.stack.sections[SectionId(0)].contours[ContourId(0)].vertices.size(), 64U);
  // Open: the last vertex has no arc.
  const ReadStack open =
      read(dxf(light("1", {{"0", "0"}, {"1", "0"}, {"0", "1"}, {"0", "0", "1"}}, "0")));
  EXPECT_EQ(open.stack.vertex_count(), 3U);
}

TEST(Dxf, MirrorsPlanesSeenFromBelow) {
  const ReadStack stack =
      read(dxf(light("-7", kSquare, "1", groups({{210, "0"}, {220, "0"}, {230, "-1"}}))));
  EXPECT_EQ(heights_of(stack.stack), std::vector<double>{7});
  EXPECT_EQ(stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices[1], (Point2{-4, 0}));
  EXPECT_NE(refusal(dxf(light("1", kSquare, "1", groups({{210, "1"}, {220, "0"}, {230, "0"}}))))
                .find("not horizontal"),
            std::string::npos);
}

TEST(Dxf, LeavesOutOtherEntitiesAndBlocks) {
  const std::string blocks = groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}}) +
                             light("9", kSquare) + groups({{0, "ENDBLK"}, {0, "ENDSEC"}});
  const ReadStack stack =
      read(dxf(light("1", kSquare) + groups({{0, "INSERT"}, {2, "b"}, {10, "1"}}) +
                   groups({{0, "TEXT"}, {1, "words"}, {40, "2.5"}}) + heavy("3", kSquare, "16"),
               blocks));
  EXPECT_EQ(heights_of(stack.stack), std::vector<double>{1});
  EXPECT_TRUE(says(stack.warnings, "1 of type 'INSERT' (explode the blocks"));
  EXPECT_TRUE(says(stack.warnings, "1 of type 'TEXT'"));
  EXPECT_TRUE(says(stack.warnings, "1 of type 'POLYLINE of a mesh'"));
}

TEST(Dxf, RefusesWhatIsNone) {
  const std::string whole = dxf(light("1", kSquare));
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"AutoCAD Binary DXF\r\n\x1a", "binary form"},
      {whole.substr(0, whole.size() - 24), "end is missing"},
      {dxf(light("x", kSquare)), "'x' is not a number"},
      {dxf(groups({{0, "POLYLINE"}, {0, "LINE"}})), "no SEQEND"},
      {dxf(groups({{0, "POLYLINE"}, {70, "1"}})), "no SEQEND"},
      {groups({{0, "SECTION"}, {2, "HEADER"}, {0, "ENDSEC"}, {0, "EOF"}}), "no section ENTITIES"},
      {groups({{0, "SECTION"}, {2, "ENTITIES"}}) + "word\n0\n", "is no group code"},
      {groups({{0, "SECTION"}, {0, "SECTION"}}), "inside of another"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << '\n' << refusal(text);
  }
}

TEST(Dxf, CountsAsAnIndependentReaderDoes) {
  const auto files = test::reference_files("dxf");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  for (const auto& file : files) {
    const Result<FileSummary> summary = inspect(file.string());
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    const std::string truth = test::get(file.string() + ".truth.json");
    const std::size_t at = truth.find("\"LWPOLYLINE\": ");
    EXPECT_EQ(summary->lines->contours, std::stoul(truth.substr(at + 14)));
    const std::size_t list = truth.find("\"elevations_group38\"");
    const auto end = truth.begin() + static_cast<std::ptrdiff_t>(truth.find(']', list));
    const auto levels =
        1 + std::count(truth.begin() + static_cast<std::ptrdiff_t>(list) + 21, end, ',');
    EXPECT_EQ(summary->lines->planes, static_cast<std::size_t>(levels));
  }
}

}  // namespace
}  // namespace tetloft
