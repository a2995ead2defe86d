// Slice contours with adjacency.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

std::string square(int x, const std::string& adjacent, const std::string& state = "closed") {
  const std::string a = std::to_string(x);
  const std::string b = std::to_string(x + 2);
  return "contour " + state + "\n" + a + " 0\n" + b + " 0.000\n" + b + " 2\n" + a +
         " 2\nadjacent\n" + adjacent + "\n";
}

// A body that branches into two, and beside it a body of its own.
const std::string kFile = "slice 1.5\n" + square(0, "0 1 -1") + square(9, "2 -1") + "slice 3\n" +
                          square(-1, "-1") + square(2, "-1") + square(9, "-1");

TEST(Slc, IsRecognisedAndCounted) {
  const auto read = inspected(kFile);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "slc");
  EXPECT_EQ(read->lines->planes, 2U);
  EXPECT_EQ(read->lines->contours, 5U);
  EXPECT_EQ(read->lines->points, 20U);
  EXPECT_EQ(read->lines->closed, 5U);
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
}

TEST(Slc, AdjacencyBecomesLabels) {
  const auto read = parse_stack(kFile, "a.slc");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.sections[SectionId(0)].z, 1.5);
  ASSERT_EQ(read->labels.labels.size(), 5U);
  std::vector<std::uint32_t> labels;
  for (const Label& label : read->labels.labels) labels.push_back(label.label);
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{1, 2, 1, 1, 2}));
}

// As the program's own sample has it: -1 everywhere.
TEST(Slc, WithoutAnyAdjacencyNothingIsTold) {
  const auto read =
      parse_stack("slice 0\n" + square(0, "-1") + "slice 1\n" + square(0, "-1"), "a.slc");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->labels.labels.empty());
}

TEST(Slc, OpenContoursAreCountedButBoundNothing) {
  const std::string file = "slice 0\n" + square(0, "0 -1", "open") + "slice 1\n" + square(0, "-1");
  const auto read = inspected(file);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->lines->open, 1U);
  EXPECT_EQ(read->lines->closed, 1U);
  const auto stack = parse_stack(file, "a.slc");
  ASSERT_FALSE(stack.ok());
  EXPECT_EQ(stack.error().where.line, 2U);
  EXPECT_NE(stack.error().message.find("open"), std::string::npos);
}

TEST(Slc, WhatIsHarmlessIsForgiven) {
  const auto read = inspected(
      "# made by hand\r\nslice 0\r\n\r\ncontour closed # a square\r\n0 0\r\n1 0\r\n"
      "1 1\r\nadjacent 0\r\n3 -1\r\nslice 1\r\n" +
      square(0, "7 -1") + "slice 2\n");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "slc");
  EXPECT_EQ(read->lines->planes, 3U);
  expect_warning(read->warnings, {"no contour 3", "which has 1"});
  expect_warning(read->warnings, {"no contour 7", "which has 0"});
}

TEST(Slc, ErrorsNameTheLine) {
  expect_error("", {"slice Z"}, "slc");
  expect_error("contour closed\n", {"a.file:1", "slice Z"}, "slc");
  expect_error("slice\n", {"a.file:1", "slice Z"}, "slc");
  expect_error("slice x\n", {"a.file:1", "'x'"}, "slc");
  expect_error("slice 0\ncontour\n", {"a.file:2", "contour closed"});
  expect_error("slice 0\ncontour ajar\n", {"a.file:2", "contour closed"});
  expect_error("slice 0\ncontour closed\n0 0 0\n", {"a.file:3", "3 fields"});
  expect_error("slice 0\ncontour closed\n0 q\n", {"a.file:3", "'q'"});
  expect_error("slice 0\ncontour closed\n0 0\n", {"ends within a contour"});
  expect_error("slice 0\ncontour closed\n0 0\nadjacent\n", {"before its -1"});
  expect_error("slice 0\ncontour closed\n0 0\nadjacent\n0\nslice 1\n", {"a.file:6", "'slice'"});
  expect_error("slice 0\ncontour closed\n0 0\nadjacent\n-1 0\n", {"a.file:5", "behind the -1"});
  expect_error("slice 0\ncontour closed\n0 0\nadjacent\n-2\n", {"a.file:5", "'-2'"});
  expect_error("slice 0\ncontour closed\n0 0\nadjacent\n-1\nrubbish\n", {"a.file:6", "slice Z"});
}

}  // namespace
}  // namespace tetloft
