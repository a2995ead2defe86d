// Rows of text: contours in tables, and points in tables, .node and .ply files.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/little_endian.hpp"
#include "io/drawing/csl_write.hpp"
#include "io/table_rows.hpp"
#include "unit/drawings/stack_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::heights_of;
using test::says;

std::string refusal(const std::string& text, const std::string& name = "a.csv") {
  return test::refusal_of(text, {}, name);
}

ReadStack read(const std::string& text, const ReadOptions& options = {}) {
  Result<ReadStack> stack = parse_stack(text, "a.csv", options);
  if (!stack) {
    ADD_FAILURE() << to_string(stack.error()) << '\n' << text;
    return {};
  }
  return *std::move(stack);
}

TEST(TableRows, TellSeparatorsApart) {
  const auto fields_of = [](const std::string& text) {
    io::TableRows rows(text);
    std::string all;
    while (rows.next()) {
      for (const std::string_view field : rows.fields()) all += '<' + std::string(field) + '>';
      all += rows.after_gap() ? "|gap\n" : "\n";
    }
    return all;
  };
  EXPECT_EQ(fields_of("a, b ,c\n1,2,3,\n"), "<a><b><c>\n<1><2><3>\n");
  EXPECT_EQ(fields_of("1,5;2,5;3\n"), "<1,5><2,5><3>\n");
  EXPECT_EQ(fields_of("1\t\t3\n"), "<1><><3>\n");
  EXPECT_EQ(fields_of("  1  2 3 # c\n# d\n\n4 5 6"), "<1><2><3>\n<4><5><6>|gap\n");
  EXPECT_EQ(fields_of("\xEF\xBB\xBF//X Y\r\n1 2\r\n"), "<X><Y>\n<1><2>\n");
  EXPECT_EQ(fields_of("\"x\",\"a,b\"\n1,2"), "<x><a,b>\n<1><2>\n");
}

// A triangle at a height, with what else stands in each row.
std::string rows(const std::string& z, const std::string& more, double at = 0) {
  std::string text;
  for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {4, 4}}) {
    text += std::to_string(at + x) + ',' + std::to_string(y) + ',' + z + more + '\n';
  }
  return text;
}

TEST(Csv, FindsColumnsByName) {
  const std::string body = rows("1", ",0") + rows("1", ",1", 9) + rows("2", ",0");
  for (const char* head : {"x,y,z,contour", "X,Y,Z,contour_id", "\"x\", \"y\", \"z\", \"Loop\"",
                           "x,y,height,id", ""}) {
    const ReadStack stack = read((*head == '\0' ? "" : std::string(head) + '\n') + body);
    EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{1, 2})) << head;
    EXPECT_EQ(stack.stack.contour_count(), 3U) << head;
  }
  const ReadStack turned = read("id,z,y,x\n7,1,0,0\n7,1,0,4\n7,1,4,4\n");
  EXPECT_EQ(turned.stack.sections[SectionId(0)].contours[ContourId(0)].vertices[1], (Point2{4, 0}));
}

TEST(Csv, BeginsContoursWhereNumbersHeightsOrGapsSay) {
  // Numbers that begin anew in each section, without a change of theirs.
  EXPECT_EQ(read("x,y,z,id\n" + rows("1", ",0") + rows("2", ",0")).stack.contour_count(), 2U);
  EXPECT_EQ(read(rows("1", "") + rows("2", "")).stack.contour_count(), 2U);
  EXPECT_EQ(read(rows("1", "") + '\n' + rows("1", "", 9)).stack.contour_count(), 2U);
  // One of an oblique plane.
  const ReadStack oblique = read(
      "x,y,z,id\n0,0,0,0\n4,0,3,0\n4,4,3.5,0\n0,4,0.5,0\n0,0,9,1\n4,0,12,1\n4,4,12.5,1\n0,4,9.5,"
      "1\n");
  EXPECT_EQ(oblique.stack.contour_count(), 2U);
  EXPECT_EQ(oblique.stack.vertex_count(), 8U);
}

TEST(Csv, TakesDecimalCommasBetweenSemicolons) {
  const ReadStack stack = read("x;y;z;contour\n0,5;0;1,25;1\n4;0;1,25;1\n4;4;1,25;1\n");
  EXPECT_EQ(heights_of(stack.stack), std::vector<double>{1.25});
  EXPECT_EQ(stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices[0],
            (Point2{0.5, 0}));
}

TEST(Csv, KeepsStructuresApart) {
  const std::string text =
      "x,y,z,name\n" + rows("1", ",lung") + rows("2", ",lung") + rows("1", ",heart");
  EXPECT_NE(refusal(text).find("several structures: 0 'lung', 1 'heart'"), std::string::npos)
      << refusal(text);
  ReadOptions options;
  options.structure = "Lung";
  EXPECT_EQ(read(text, options).stack.contour_count(), 2U);
}

TEST(Csv, TakesSectionsForHeightsWhereThereAreNone) {
  const ReadStack stack = read("section,x,y\n3,0,0\n3,1,0\n3,1,1\n4,0,0\n4,1,0\n4,1,1\n");
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{3, 4}));
  const ReadStack extra = read("x,y,z,contour,colour\n0,0,1,0,red\n1,0,1,0,red\n1,1,1,0,red\n");
  EXPECT_TRUE(says(extra.warnings, "columns that are not used: 'colour'"));
}

TEST(Csv, RefusesWithTheLine) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "the file is empty"},
      {"x,y,z,id\n", "has no points"},
      {"a,b,c\n1,2,3\n", "a.csv:1: no columns named x and y"},
      {"x,y,name\n1,2,3\n", "no column named z"},
      {"1,2\n", "this one has 2 fields"},
      {"1,2,3,4,5\n", "name the columns"},
      {"x,y,z,id\n1,2,3,4\n1,2,3\n", "a.csv:3: 4 fields are due, here are 3"},
      {"x,y,z,id\n1,2,q,4\n", "a.csv:2: 'q' is not a number"},
      {"x,y,z,id\n1,2,1e999,4\n", "a.csv:2"},
      {"1,2,3\nx,2,3\n", "'x' is not a number"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << '\n' << refusal(text);
  }
}

TEST(Csv, RefusesClouds) {
  std::string cloud;
  for (int i = 0; i < 20'000; ++i) cloud += "0,1," + std::to_string(i) + '\n';
  EXPECT_NE(refusal(cloud).find("these rows are no contours"), std::string::npos);
}

TEST(Csv, IsRecognisedByItsNames) {
  EXPECT_TRUE(parse_stack("x,y,z,contour\n" + rows("1", ",0"), "a").ok());
  EXPECT_FALSE(parse_stack("x,y,z\n" + rows("1", ""), "a").ok());
  EXPECT_TRUE(parse_stack(rows("1", ""), "a.xyz").ok());
}

TEST(Csv, CountsAsAnIndependentReaderDoes) {
  const auto files = test::reference_files("csv");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  for (const auto& file : files) {
    const Result<FileSummary> summary = inspect(file.string());
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->lines->points, test::truth_number(file, "rows"));
    EXPECT_EQ(summary->lines->contours, test::truth_number(file, "contours"));
  }
}

std::vector<Point3> points(const std::string& text, const std::string& name, bool warns = false) {
  const Result<ReadPoints> read = parse_points(text, name);
  if (!read) {
    ADD_FAILURE() << to_string(read.error()) << '\n' << text;
    return {};
  }
  EXPECT_EQ(read->warnings.empty(), !warns) << text;
  return read->points;
}

std::string points_refusal(const std::string& text, const std::string& name) {
  const Result<ReadPoints> read = parse_points(text, name);
  return read ? "" : to_string(read.error());
}

const std::vector<Point3> kTwo{{1, 2, 3}, {4, 5.5, -6}};

TEST(Points, OfTables) {
  EXPECT_EQ(points("1 2 3\n4 5.5 -6\n", "a.xyz"), kTwo);
  EXPECT_EQ(points("1 2 3 0.5\n4 5.5 -6 7 # c\n", "a.xyz", true), kTwo);
  EXPECT_EQ(points("x,y,z\n1,2,3\n4,5.5,-6\n", "a.csv"), kTwo);
  EXPECT_EQ(points("id,z,y,x,t\n0,3,2,1,a\n1,-6,5.5,4,b\n", "a.csv", true), kTwo);
  EXPECT_EQ(points("X;Y;Z\n1;2;3\n4;5,5;-6\n", "a.csv"), kTwo);
  EXPECT_NE(points_refusal("a,b,c\n1,2,3\n", "a.csv").find("no columns named x, y and z"),
            std::string::npos);
  EXPECT_NE(points_refusal("1 2 3\n1 2 3 4\n", "a.xyz").find("a.xyz:2: 3 fields"),
            std::string::npos);
  EXPECT_NE(points_refusal("1 2\n", "a.xyz").find("x y z"), std::string::npos);
  EXPECT_NE(points_refusal("1 2 x\n", "a.xyz").find("'x' is not a number"), std::string::npos);
}

TEST(Points, OfTetGen) {
  EXPECT_EQ(points("# c\n2 3 0 0\n\n1 1 2 3\n2 4 5.5 -6\n# end\n", "a.node"), kTwo);
  EXPECT_EQ(points("2  3  1  1\n0 1 2 3  0.5 -1\n1 4 5.5 -6  7 1\n", "a.node", true), kTwo);
  EXPECT_EQ(points("2 3\n0 1 2 3\n1 4 5.5 -6\n", "a.node"), kTwo);
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "empty"},
      {"2 2 0 0\n", "only 3"},
      {"2 x 0 0\n", "'x' is no count"},
      {"1 3 0 0 0\n", "got 5 fields"},
      {"2 3 0 0\n0 1 2 3\n", "a.node:2: 2 points are announced, here are 1"},
      {"1 3 0 0\n0 1 2 3\n1 1 2 3\n", "more points than the 1"},
      {"1 3 0 0\n2 1 2 3\n", "numbered in order"},
      {"2 3 0 0\n0 1 2 3\n2 1 2 3\n", "numbered in order"},
      {"1 3 0 0\n0 1 2\n", "got 3 fields"},
      {"1 3 0 0\n0 1 2 z\n", "'z' is not a number"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(points_refusal(text, "a.node").find(reason), std::string::npos)
        << text << points_refusal(text, "a.node");
  }
}

template <class T>
void append(std::string& bytes, T value, bool big) {
  std::string little;
  append_little(little, value);
  if (big) std::reverse(little.begin(), little.end());
  bytes += little;
}

TEST(Points, OfPly) {
  const std::string elements =
      "comment x\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 2\nproperty uchar red\nproperty double z\nproperty float y\n"
      "property short x\nend_header\n";
  EXPECT_EQ(points("ply\r\nformat ascii 1.0\n" + elements + "3 0 1 0\n255 3 2 1\n0 -6 5.5 4\n",
                   "a.ply", true),
            kTwo);
  for (const bool big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + elements;
    append(bytes, std::uint8_t{3}, big);
    for (const std::int32_t v : {0, 1, 0}) append(bytes, v, big);
    for (const Point3& p : kTwo) {
      append(bytes, std::uint8_t{9}, big);
      append(bytes, p.z, big);
      append(bytes, static_cast<float>(p.y), big);
      append(bytes, static_cast<std::int16_t>(p.x), big);
    }
    EXPECT_EQ(points(bytes, "a.ply", true), kTwo);
    for (std::size_t cut = bytes.size() - 40; cut < bytes.size(); ++cut) {
      EXPECT_FALSE(parse_points(bytes.substr(0, cut), "a.ply").ok());
    }
  }
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"ply\nformat ascii 1.0\n", "does not end"},
      {"ply\nend_header\n", "names no format"},
      {"ply\nformat odd 1.0\nend_header\n", "unknown format 'odd'"},
      {head + "end_header\n", "no element 'vertex'"},
      {head + "element vertex 1\nproperty float x\nend_header\n1\n", "no property 'y'"},
      {head + "element vertex -1\nend_header\n", "no count"},
      {head + "element vertex 1\nproperty real x\nend_header\n", "no known type"},
      {head + "words\nend_header\n", "a.ply:3: this is no line of a header"},
      {head + "element vertex 9999999999\nproperty float x\nproperty float y\nproperty float z\n"
              "end_header\n1 2 3\n",
       "vertex 1 of 9999999999 is cut off"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(points_refusal(text, "a.ply").find(reason), std::string::npos)
        << text << points_refusal(text, "a.ply");
  }
}

TEST(Points, OfPlyAsSurfacesAreWritten) {
  Model model;
  for (const Point3& p : std::vector<Point3>{{0.5, 0, 0}, {1, 0, 1e-300}, {0, 1, 0}, {0, 0, 2}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const Result<Formatted> written = format_surface(model, {encoding, "ply"});
    ASSERT_TRUE(written.ok());
    EXPECT_EQ(points(written->bytes, "a.ply"), model.points.raw());
  }
}

TEST(WriteCsl, HasPlanesComponentsAndParents) {
  SectionStack stack;
  Section section{0.1, {}};
  section.contours.push_back({{{1, 1}, {2, 1}, {1, 2}}});
  section.contours.push_back({{{0, 0}, {9, 0}, {0, 9}}});
  section.contours.push_back({{{1.125, 1.125}, {1.25, 1.125}, {1.125, 1.25}}});
  stack.sections.push_back(section);
  stack.sections.push_back({1, {}});
  io::StringSink sink;
  const io::Written written = io::write_csl(sink, stack, {});
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(written->size(), 1U);
  EXPECT_EQ(
      sink.take(),
      "CSLC\n1 2\n\n1 9 3 0 0 1 -0.1\n\n1 1 0.1\n2 1 0.1\n1 2 0.1\n0 0 0.1\n9 0 0.1\n0 9 0.1\n"
      "1.125 1.125 0.1\n1.25 1.125 0.1\n1.125 1.25 0.1\n\n3h1 1 0 1 2\n3 1 3 4 5\n"
      "3 1 6 7 8\n");
  stack.frame.axes = {Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}};
  io::StringSink turned;
  ASSERT_TRUE(io::write_csl(turned, stack, {}).ok());
  EXPECT_NE(turned.take().find("1 9 3 1 0 0 -0.1\n\n0.1 1 1\n0.1 2 1\n"), std::string::npos);
}

}  // namespace
}  // namespace tetloft
