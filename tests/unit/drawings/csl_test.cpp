// CSL files.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

// A square with a square hole, in the plane z = height; D as the format has it, or its opposite.
std::string plane(int id, int height, const std::string& hole = "4h0 1", int sign = -1) {
  const std::string z = ' ' + std::to_string(height) + "\n";
  return "\n" + std::to_string(id) + " 8 2 0 0 2 " + std::to_string(2 * sign * height) + "\n\n0 0" +
         z + "9 0" + z + "9 9" + z + "0 9" + z + "3 3" + z + "3 6" + z + "6 6" + z + "6 3" + z +
         "\n4 1 0 1 2 3\n" + hole + " 4 5 6 7\n";
}

std::string with_line(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.substr(0, at) + to + text.substr(at + from.size());
}

const std::string kFile = "CSLC\n2 2 \n" + plane(1, 0) + plane(2, 3);

TEST(Csl, IsRecognisedAndCounted) {
  const auto read = inspected(kFile);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "csl");
  EXPECT_EQ(read->lines->planes, 2U);
  EXPECT_EQ(read->lines->contours, 4U);
  EXPECT_EQ(read->lines->points, 16U);
  EXPECT_EQ(read->lines->closed, 4U);
  EXPECT_EQ(read->lines->labels, std::vector<std::int64_t>{1});
  EXPECT_EQ(read->structures.size(), 0U);
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
}

TEST(Csl, ReadsAStackWithItsLabels) {
  const auto read = parse_stack(kFile, "a.csl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->stack.sections.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(1)].z, 3);
  EXPECT_EQ(read->stack.sections[SectionId(1)].contours.size(), 2U);
  ASSERT_EQ(read->labels.labels.size(), 2U);
  EXPECT_EQ(read->labels.labels[1].label, 1U);
  EXPECT_EQ(read->lines[SectionId(0)][ContourId(1)], 16U);
}

TEST(Csl, HolesAreWrittenInSeveralWays) {
  for (const char* const hole : {"4h0 1", "4h 1", "4h-1 1", "4 1h0", "4 1h", "4 1", "4h0 0"}) {
    SCOPED_TRACE(hole);
    const auto read = inspected("CSLC\n2 2\n" + plane(1, 0, hole) + plane(2, 3));
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->lines->labels, std::vector<std::int64_t>{1});
  }
  expect_error("CSLC\n1 2\n" + plane(1, 0, "4h2 1"), {"a.file:16", "'4h2'", "parent"});
  expect_error("CSLC\n1 2\n" + plane(1, 0, "4h1 1"), {"a.file:16", "'4h1'", "parent"});
  expect_error("CSLC\n1 2\n" + plane(1, 0, "4hx 1"), {"a.file:16", "'4hx'", "parent"});
}

TEST(Csl, ALabelIsChosen) {
  const std::string two = "CSLC\n2 3\n" + plane(1, 0, "4 2") + plane(2, 3, "4 2");
  const auto read = parse_stack(two, "a.csl", {.structure = "2"});
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.contour_count(), 2U);
  const auto none = parse_stack(two, "a.csl", {.structure = "3"});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().message.find("--label"), std::string::npos) << none.error().message;
}

TEST(Csl, TheVerticesTellTheSignOfTheEquation) {
  const auto read = inspected("CSLC\n2 2\n" + plane(1, 0, "4h0 1", 1) + plane(2, 3, "4h0 1", 1));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  expect_warning(read->warnings, {"A x + B y + C z = D"});
  expect_error("CSLC\n2 2\n" + plane(1, 2) + with_line(plane(7, 3), "9 9 3", "9 9 5"),
               {"a.file:18", "vertex 2 of plane 7", "2 away"});
  // Nor is one sign right for all.
  expect_error("CSLC\n2 2\n" + plane(1, 2) + plane(2, 3, "4h0 1", 1), {"do not agree"});
}

TEST(Csl, NumbersOfTwoDigitsAreEnough) {
  const auto read = inspected(with_line(kFile, "0 0 2 -6", "0 0 1 -2.99"));
  EXPECT_TRUE(read.ok()) << to_string(read.error());
}

TEST(Csl, PlanesThatAreNotParallelAreNamed) {
  const std::string oblique =
      "CSLC\n2 2\n" + plane(4, 0) + "9 3 1 1 0 1 0\n0 0 0\n0 5 0\n3 0 -3\n3 1 0 1 2\n";
  const auto read = inspected(oblique);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->lines->planes, 2U);
  const auto stack = parse_stack(oblique, "a.csl");
  ASSERT_FALSE(stack.ok());
  EXPECT_NE(stack.error().message.find("planes 4 and 9 are not parallel, but at 45 degrees"),
            std::string::npos)
      << stack.error().message;
}

TEST(Csl, ParallelPlanesMayBeOblique) {
  std::string text = "CSLC\n2 2\n";
  for (const int d : {0, -10}) {
    const std::string x = std::to_string(d == 0 ? 0 : 2);
    const std::string z = std::to_string(d == 0 ? 0 : 1);
    text += "1 3 1 4 0 2 " + std::to_string(d) + "\n" + x + " 0 " + z + "\n" + x + " 5 " + z +
            "\n" + std::to_string(d == 0 ? 1 : 3) + " 0 " + std::to_string(d == 0 ? -2 : -1) +
            "\n3 1 0 1 2\n";
  }
  const auto read = parse_stack(text, "a.csl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.sections.size(), 2U);
}

TEST(Csl, WhatIsHarmlessIsForgiven) {
  // Comments, a component that is closed by its first vertex, a plane without components.
  const auto read = inspected(
      "CSLC # header\r\n3 2 # planes, labels\r\n\r\n1 3 1 0 0 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n"
      "4 1 0 1 2 0\r\n2 0 0 0 0 1 -1\r\n3 3 1 0 0 1 -2\r\n0 0 2\r\n1 0 2\r\n1 1 2\r\n3 5 0 1 "
      "2\r\n");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->lines->planes, 3U);
  EXPECT_EQ(read->lines->contours, 2U);
  expect_warning(read->warnings, {"1 plane without components"});
  expect_warning(read->warnings, {"1 components have labels", "the first here"});
}

TEST(Csl, ErrorsNameTheLine) {
  expect_error("CSL\n", {"a.file:1", "CSLC"}, "csl");
  expect_error("CSLC\n", {"the file ends", "PLANES LABELS"});
  expect_error("CSLC\n1 2 3\n", {"a.file:2", "PLANES LABELS", "3 fields"});
  expect_error("CSLC\n-1 2\n", {"a.file:2", "'-1'", "planes"});
  expect_error("CSLC\n99999999999 2\n", {"plane 1 of 99999999999"});
  expect_error(with_line(kFile, "1 8 2 0 0 2", "1 8 2 0 0 0"), {"a.file:4", "normal of plane 1"});
  expect_error(with_line(kFile, "1 8 2 0 0 2", "1 8 2 0 2"), {"a.file:4", "6 fields"});
  expect_error(with_line(kFile, "1 8 2 0 0 2", "1 x 2 0 0 2"), {"a.file:4", "'x'", "vertices"});
  expect_error(with_line(kFile, "9 9 0", "9 nan 0"), {"a.file:8", "not a finite number"});
  expect_error(with_line(kFile, "9 9 0", "9 9"), {"a.file:8", "x y z"});
  expect_error(with_line(kFile, "0 1 2 3", "0 1 2 8"), {"a.file:15", "'8'", "which has 8"});
  expect_error(with_line(kFile, "0 1 2 3", "0 1 2 -1"), {"a.file:15", "'-1'"});
  expect_error(with_line(kFile, "0 1 2 3", "0 1 2 1"), {"a.file:15", "vertex 1 twice"});
  expect_error(with_line(kFile, "0 1 2 3", "0 1 2"), {"a.file:15", "3 vertices, not 4"});
  expect_error(with_line(kFile, "4 1 0", "4 -1 0"), {"a.file:15", "'-1'", "no label"});
  expect_error(with_line(kFile, "4 1 0", "4 4294967296 0"), {"a.file:15", "no label"});
  expect_error(kFile + "3 0 0 0 0 1 0\n", {"expected the end", "2 planes"});
  expect_error(kFile.substr(0, kFile.size() - 14), {"the file ends", "component 1 of plane 2"});
}

}  // namespace
}  // namespace tetloft
