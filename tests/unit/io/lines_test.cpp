// Labels and points.
#include <gtest/gtest.h>

#include <tetloft/formats.hpp>

#include "core/little_endian.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::TempFolder;

TEST(Labels, TakeCommentsAndBlankLines) {
  const auto labels = parse_labels("# head\n\n0 1 7\r\n  2\t3 4294967294# tail\n#\n5 0 0", "l");
  ASSERT_TRUE(labels.ok()) << to_string(labels.error());
  ASSERT_EQ(labels->labels.size(), 3U);
  EXPECT_EQ(labels->labels[0].contour, ContourId(1));
  EXPECT_EQ(labels->labels[0].label, 7U);
  EXPECT_EQ(labels->labels[1].section, SectionId(2));
  EXPECT_EQ(labels->labels[1].label, 4294967294U);
  EXPECT_TRUE(labels->decisions.empty());
  EXPECT_TRUE(parse_labels("", "l").ok());
}

TEST(Labels, TakeDecisionsAmongThem) {
  const auto labels = parse_labels(
      "join 3 5 7  # overlap: ratio 0.1\n0 1 7\npart\t0 4294967294 2# no\njoin 3 5 7\n", "l");
  ASSERT_TRUE(labels.ok()) << to_string(labels.error());
  EXPECT_EQ(labels->labels.size(), 1U);
  ASSERT_EQ(labels->decisions.size(), 3U);
  const LinkDecision& joined = labels->decisions[0];
  EXPECT_EQ(joined.slab, SlabId(3));
  EXPECT_EQ(joined.lower, ContourId(5));
  EXPECT_EQ(joined.upper, ContourId(7));
  EXPECT_TRUE(joined.join);
  const LinkDecision& parted = labels->decisions[1];
  EXPECT_EQ(parted.slab, SlabId(0));
  EXPECT_EQ(parted.lower, ContourId(4294967294U));
  EXPECT_EQ(parted.upper, ContourId(2));
  EXPECT_FALSE(parted.join);
}

TEST(Labels, TakeDecisionsOnVoids) {
  const auto labels = parse_labels(
      "hole 3 5 7 # mine\nopen 0 1 2\nclose\t4294967294 outside 2\njoin 0 1 2\nopen 5 3 outside\n"
      "part 5 0 0\n",
      "l");
  ASSERT_TRUE(labels.ok()) << to_string(labels.error());
  EXPECT_TRUE(labels->labels.empty());
  EXPECT_EQ(labels->decisions.size(), 2U);
  ASSERT_EQ(labels->hole_labels.size(), 1U);
  EXPECT_EQ(labels->hole_labels[0].section, SectionId(3));
  EXPECT_EQ(labels->hole_labels[0].contour, ContourId(5));
  EXPECT_EQ(labels->hole_labels[0].label, 7U);
  ASSERT_EQ(labels->void_decisions.size(), 3U);
  const LinkDecision& opened = labels->void_decisions[0];
  EXPECT_EQ(opened.slab, SlabId(0));
  EXPECT_EQ(opened.lower, ContourId(1));
  EXPECT_EQ(opened.upper, ContourId(2));
  EXPECT_TRUE(opened.join);
  const LinkDecision& closed = labels->void_decisions[1];
  EXPECT_EQ(closed.slab, SlabId(4294967294U));
  EXPECT_FALSE(closed.lower.valid());
  EXPECT_EQ(closed.upper, ContourId(2));
  EXPECT_FALSE(closed.join);
  EXPECT_FALSE(labels->void_decisions[2].upper.valid());
  const auto written = format_labels(*labels);
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(*written,
            "join 0 1 2\npart 5 0 0\nhole 3 5 7\nopen 0 1 2\nclose 4294967294 outside 2\n"
            "open 5 3 outside\n");
}

TEST(Labels, NameTheLineOfAnError) {
  for (const char* text : {"0 0 1\n0 1\n",
                           "0 0 1\n0 1 2 3\n",
                           "0 0 1\n0 -1 2\n",
                           "0 0 1\n0 1.5 2\n",
                           "0 0 1\nx 1 2\n",
                           "0 0 1\n0 0 4294967295\n",
                           "0 0 1\n99999999999999999999 0 0\n",
                           "0 0 1\njoin 0 1\n",
                           "join 0 0 1\npart 0 0 1 2\n",
                           "part 0 0 1\nunite 0 0 1\n",
                           "0 0 1\njoin 0 0 -1\n",
                           "0 0 1\njoin 4294967295 0 0\n",
                           "join 0 0 1\npart 0 0 1\n",
                           "0 0 1\njoin\n",
                           "0 0 1\nhole 0 1\n",
                           "0 0 1\nhole 0 outside 1\n",
                           "0 0 1\nopen outside 0 0\n",
                           "0 0 1\nclose 0 1\n",
                           "0 0 1\nclose 0 -1 outside\n",
                           "open 0 0 1\nclose 0 0 1\n",
                           "0 0 1\nopen 0 outside outside\n",
                           "0 0 1\nopen 0 0 4294967295\n"}) {
    const auto labels = parse_labels(text, "l.txt");
    ASSERT_FALSE(labels.ok()) << text;
    EXPECT_EQ(labels.error().code, ErrorCode::invalid_input) << text;
    EXPECT_EQ(labels.error().where.line, 2U) << text;
    EXPECT_EQ(labels.error().where.file, "l.txt") << text;
  }
}

TEST(Labels, SayWhatWasExpected) {
  const auto message = [](const char* text) { return parse_labels(text, "l").error().message; };
  EXPECT_EQ(message("jion 0 0 1\n"),
            "'jion' is neither join, part, hole, open, close nor a section (did you mean join?)");
  EXPECT_EQ(message("part 0 0\n"), "expected \"part section contour contour_above\", got 3 fields");
  EXPECT_EQ(message("0 0\n"), "expected \"section contour label\", got 2 fields");
  EXPECT_EQ(message("hole 0 0\n"), "expected \"hole section contour label\", got 3 fields");
  EXPECT_EQ(message("open 0 0\n"), "expected \"open section hole hole_above\", got 3 fields");
  EXPECT_EQ(message("open 0 0 inside\n"),
            "'inside' is no hole: expected an integer from 0 or outside");
  EXPECT_EQ(message("join 0 0 outside\n"), "'outside' is no contour: expected an integer from 0");
  EXPECT_EQ(message("open 0 outside outside\n"),
            "the outside is the same in all sections: there is nothing to decide");
  EXPECT_EQ(message("close 1 outside 0\nopen 1 outside 0\n"),
            "open and close of the same contours: see line 1");
  EXPECT_EQ(message("part 1 0 0\n1 0 1\npart 0 0 0\njoin 1 0 0\n"),
            "join and part of the same contours: see line 1");
}

TEST(Labels, ComeFromAFile) {
  TempFolder folder;
  test::put(folder.file("l"), "1 2 3\n");
  const auto labels = read_labels(folder.file("l"));
  ASSERT_TRUE(labels.ok());
  EXPECT_EQ(labels->labels.size(), 1U);
  EXPECT_EQ(read_labels(folder.file("none")).error().code, ErrorCode::io);
}

TEST(Points, ReadTextAndBinaryAlike) {
  TempFolder folder;
  const std::vector<double> hard = test::hard_doubles();
  std::string text = "# points\n";
  std::string bytes;
  std::vector<Point3> expected;
  for (std::size_t i = 0; i + 2 < hard.size(); ++i) {
    expected.push_back({hard[i], hard[i + 1], hard[i + 2]});
    for (std::size_t k = 0; k < 3; ++k) {
      char buffer[40];
      std::snprintf(buffer, sizeof buffer, "%a ", hard[i + k]);
      text += buffer;
      append_little(bytes, hard[i + k]);
    }
    text += "\n";
  }
  test::put(folder.file("p.txt"), text);
  test::put(folder.file("p.bin"), bytes);
  for (const char* name : {"p.txt", "p.bin"}) {
    const auto points = read_points(folder.file(name));
    ASSERT_TRUE(points.ok()) << to_string(points.error());
    EXPECT_TRUE(points->warnings.empty());
    ASSERT_EQ(points->points.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_TRUE(test::same_bits(points->points[i], expected[i])) << name << ' ' << i;
    }
  }
}

TEST(Points, AcceptNone) {
  TempFolder folder;
  test::put(folder.file("p.txt"), "# nothing\n");
  test::put(folder.file("p.bin"), "");
  EXPECT_TRUE(read_points(folder.file("p.txt"))->points.empty());
  EXPECT_TRUE(read_points(folder.file("p.bin"))->points.empty());
}

TEST(Points, NameTheLineOfAnError) {
  TempFolder folder;
  for (const char* text : {"0 0 0\n1 2\n", "0 0 0\n1 2 3 4\n", "0 0 0\n1 2 nan\n",
                           "0 0 0\n1 2 inf\n", "0 0 0\n1,2,3\n"}) {
    test::put(folder.file("p.txt"), text);
    const auto points = read_points(folder.file("p.txt"));
    ASSERT_FALSE(points.ok()) << text;
    EXPECT_EQ(points.error().code, ErrorCode::invalid_input) << text;
    EXPECT_EQ(points.error().where.line, 2U) << text;
  }
}

TEST(Points, NameTheVertexOfABinaryError) {
  TempFolder folder;
  std::string bytes;
  for (const double value : {0.0, 1.0, 2.0, 3.0, std::numeric_limits<double>::infinity(), 5.0}) {
    append_little(bytes, value);
  }
  test::put(folder.file("p.bin"), bytes);
  EXPECT_EQ(read_points(folder.file("p.bin")).error().where.vertex, 1U);
  test::put(folder.file("p.bin"), bytes.substr(0, 47));
  EXPECT_EQ(read_points(folder.file("p.bin")).error().code, ErrorCode::invalid_input);
}

TEST(WriteLines, RefusesAnArrayOfAnotherLength) {
  TempFolder folder;
  const LineSet lines{{{Point3{0, 0, 0}, Point3{1, 0, 0}}}, {{"kind", {1, 2}}}};
  const auto refused = write_lines(folder.file("l.vtp"), lines);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.file, folder.file("l.vtp"));
  EXPECT_TRUE(test::get(folder.file("l.vtp")).empty());
}

TEST(WriteLines, WritesEndsAndData) {
  TempFolder folder;
  const LineSet lines{{{Point3{0, 0, 0}, Point3{1, 0.1, 2}}}, {{"kind", {7}}}};
  ASSERT_TRUE(write_lines(folder.file("l.vtp"), lines, Encoding::ascii).ok());
  const std::string text = test::get(folder.file("l.vtp"));
  EXPECT_NE(text.find("NumberOfLines=\"1\""), std::string::npos);
  EXPECT_NE(text.find("1 0.1 2"), std::string::npos);
  EXPECT_NE(text.find("Name=\"kind\""), std::string::npos);
}

}  // namespace
}  // namespace tetloft
