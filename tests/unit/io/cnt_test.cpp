// NUAGES files.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include <tetloft/io.hpp>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::bits;
using test::TempFolder;

constexpr const char* kSquares =
    "S 2\nv 4 z 0\n{\n0 0\n10 0\n10 10\n0 10\n}\nv 4 z 1\n{\n0 0\n10 0\n10 10\n0 10\n}\n";

void expect_squares(const std::string& text) {
  const auto read = parse_cnt(text, "t.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->stack.sections.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(1)].z, 1.0);
  ASSERT_EQ(read->stack.contour_count(), 2U);
  const auto& vertices = read->stack.sections[SectionId(1)].contours[ContourId(0)].vertices;
  const std::vector<Point2> expected{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(vertices, expected);
}

TEST(ReadCnt, TakesBothHeaderCases) {
  expect_squares(kSquares);
  std::string lower = kSquares;
  for (char& c : lower) c = c == 'S' ? 's' : c;
  expect_squares(lower);
  std::string upper = kSquares;
  for (char& c : upper) c = c == 'v' ? 'V' : c == 'z' ? 'Z' : c;
  expect_squares(upper);
}

TEST(ReadCnt, TakesAnyWhiteSpaceAndLineEnds) {
  std::string crlf;
  for (const char* c = kSquares; *c != '\0'; ++c) {
    if (*c == '\n') crlf += '\r';
    crlf += *c;
  }
  expect_squares(crlf);
  std::string one_line;
  for (const char* c = kSquares; *c != '\0'; ++c) one_line += *c == '\n' ? '\t' : *c;
  expect_squares(one_line);
  expect_squares("\xEF\xBB\xBF \n\n" + std::string(kSquares) + " \n\v\f\n");
  expect_squares("S2 v4 z0{0 0 10 0 10 10 0 10}v 4 z1{ 0 0\n10\n0 1e1 0X1.4p3 +0 +10.000e0}");
  // A missing line end at the end of the file.
  expect_squares(std::string(kSquares).substr(0, std::string(kSquares).size() - 1));
}

TEST(ReadCnt, KeepsEmptySectionsAndBothDirections) {
  const auto read = parse_cnt("S 3 v 0 z 0 v 3 z 1 { 0 0 0 1 1 0 } v 0 z 2", "t.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  EXPECT_EQ(read->stack.sections.size(), 3U);
  EXPECT_EQ(read->stack.contour_count(), 1U);
  EXPECT_EQ(area_sign(read->stack.sections[SectionId(1)].contours[ContourId(0)]), Sign::negative);
}

TEST(ReadCnt, RecordsTheLineOfEachContour) {
  const auto read = parse_cnt("S 1\nv 6 z 0\n\n{ 0 0 1 0 0 1 }\n{\n5 5 6 5 5 6\n}\n", "t.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->lines[SectionId(0)][ContourId(0)], 4U);
  EXPECT_EQ(read->lines[SectionId(0)][ContourId(1)], 5U);
}

TEST(ReadCnt, NamesFileAndLineOfGeometricErrors) {
  const auto read = parse_cnt(
      "S 2\nv 3 z 0\n{ 0 0 1 0 0 1 }\nv 4 z 1\n\n{\n0 0\n1 1\n1 0\n0 1\n}\n", "dir/t.cnt");
  ASSERT_FALSE(read.ok());
  const Error& error = read.error();
  EXPECT_EQ(error.code, ErrorCode::invalid_input);
  EXPECT_EQ(error.where.file, "dir/t.cnt");
  EXPECT_EQ(error.where.line, 6U);
  EXPECT_EQ(error.where.section, 1U);
  EXPECT_EQ(error.where.contour, 0U);
  EXPECT_FALSE(error.message.empty());
}

TEST(ReadCnt, NamesTheLineOfASectionOutOfOrder) {
  const auto read =
      parse_cnt("S 2\nv 3 z 0\n{ 0 0 1 0 0 1 }\nv 3 z -1\n{ 0 0 1 0 0 1 }\n", "t.cnt");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().where.line, 4U);
}

TEST(ReadCnt, NamesTheLineOfMalformedText) {
  const std::vector<std::pair<std::string, std::size_t>> texts{
      {"", 1},
      {" \n \n", 3},
      {"3\n", 1},
      {"S\n", 2},
      {"S x\n", 1},
      {"S -1\n", 1},
      {"S 1.5\n", 1},
      {"S nan\n", 1},
      {"S 1\nw\n", 2},
      {"S 1\nv 3\n{ 0 0 1 0 0 1 }\n", 3},
      {"S 1\nv 3 z\n{ 0 0 1 0 0 1 }\n", 3},
      {"S 1\nv 3 z inf\n", 2},
      {"S 1\nv 3 z 0\n{ 0 0\n1 0\n0 x1 }\n", 5},
      {"S 1\nv 3 z 0\n{ 0 0\n1 0\n0 1e999 }\n", 5},
      {"S 1\nv 3 z 0\n{ 0 0\n1 0\n0 }\n", 5},
      {"S 1\nv 3 z 0\n{ 0 0\n1 0\n{ 0 1 }\n", 5},
      {"S 1\nv 3 z 0\n{ 0 0\n1 0\nv 0 z 1\n", 5},
      {"S 1\nv 3 z 0\n{ 0 0 1 0 0 1 }\n}\n", 4},
      {"S 1\nv 3 z 0\n{ 0 0 1 0 0 1", 3},
      {"S 1\nv 3 z 0\n{ 0 0 1 0 0 1 }\ngarbage", 4},
      {std::string("S 1\nv 3 z 0\n{ 0 0 1 0 0 \0 }", 27), 3}};
  for (const auto& [text, line] : texts) {
    const auto read = parse_cnt(text, "t.cnt");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::invalid_input) << text;
    EXPECT_EQ(read.error().where.line, line) << text;
    EXPECT_EQ(read.error().where.file, "t.cnt") << text;
  }
}

TEST(ReadCnt, MendsWrongCountsWithAWarning) {
  for (const char* text :
       {"S 1000000000 v 3 z 0 { 0 0 1 0 0 1 }", "S 0 v 3 z 0 { 0 0 1 0 0 1 }",
        "S 1 v 4000000000 z 0 { 0 0 1 0 0 1 }", "S 1 v 1e300 z 0 { 0 0 1 0 0 1 }"}) {
    const auto read = parse_cnt(text, "t.cnt");
    ASSERT_TRUE(read.ok()) << text;
    ASSERT_EQ(read->warnings.size(), 1U) << text;
    EXPECT_EQ(read->warnings[0].where.file, "t.cnt");
    EXPECT_EQ(read->warnings[0].where.line, 1U);
    EXPECT_EQ(read->stack.vertex_count(), 3U);
  }
}

TEST(ReadCnt, MendsRepeatedVerticesWithAWarning) {
  const auto read = parse_cnt("S 1\nv 6 z 0\n{\n0 0\n1 0\n1 0\n1 0\n0 1\n0 0\n}\n", "t.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.vertex_count(), 3U);
  ASSERT_FALSE(read->warnings.empty());
  EXPECT_EQ(read->warnings[0].where.line, 3U);
  EXPECT_EQ(read->warnings[0].where.contour, 0U);
}

TEST(ReadCnt, TellsWhenThereIsNoFile) {
  TempFolder folder;
  for (const std::string& path : {folder.file("none.cnt"), folder.file("")}) {
    const auto read = read_cnt(path);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::io);
    EXPECT_EQ(read.error().where.file, path);
    EXPECT_FALSE(read.error().message.empty());
  }
}

TEST(WriteCnt, ReadsBackBitForBit) {
  TempFolder folder;
  SectionStack stack;
  Section section;
  section.z = -0x1.fffffffffffffp900;
  section.contours.push_back({{{5e-324, -0.0}, {1.0 / 3, 1e-300}, {0.1, 0x1p999}}});
  section.contours.push_back({{{-5, 1}, {-4, 1}, {-4.35e-7 - 4, 0x1.0000000000001p1}}});
  stack.sections.push_back(section);
  stack.sections.push_back({-0.0, {}});
  section.z = 0x1p-1074;
  stack.sections.push_back(section);

  const std::string path = folder.file("a.cnt");
  ASSERT_TRUE(write_cnt(path, stack).ok());
  const auto read = read_cnt(path);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->stack.sections.size(), 3U);
  for (std::size_t s = 0; s < 3; ++s) {
    const Section& a = stack.sections[SectionId(s)];
    const Section& b = read->stack.sections[SectionId(s)];
    EXPECT_EQ(bits(a.z), bits(b.z));
    ASSERT_EQ(a.contours.size(), b.contours.size());
    for (std::size_t c = 0; c < a.contours.size(); ++c) {
      const auto& u = a.contours[ContourId(c)].vertices;
      const auto& v = b.contours[ContourId(c)].vertices;
      ASSERT_EQ(u.size(), v.size());
      for (std::size_t i = 0; i < u.size(); ++i) {
        EXPECT_EQ(bits(u[i].x), bits(v[i].x));
        EXPECT_EQ(bits(u[i].y), bits(v[i].y));
      }
    }
  }
}

// Whatever the damage: a stack that is valid, or an error that names the file.
TEST(ReadCnt, SurvivesDamage) {
  Prng prng(11);
  const std::string whole =
      "S 2\r\nv 7 z -1.5e0\n{\n0 0\n0x1p3 0\n8 8.25\n0 8\n}\n{ 2 2 3 2 2 3 }\nV 3 Z 1\n"
      "{ 1 1 5 1 1 5 }\n";
  std::size_t accepted = 0;
  constexpr std::size_t kTrials = 5000;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    std::string text = whole;
    for (std::uint64_t n = prng.below(3) + 1; n > 0 && !text.empty(); --n) {
      const auto at = static_cast<std::size_t>(prng.below(text.size()));
      switch (prng.below(4)) {
        case 0: text[at] = static_cast<char>(prng.below(256)); break;
        case 1: text.erase(at, static_cast<std::size_t>(prng.below(10))); break;
        case 2: text.resize(at + 1); break;
        default: text.insert(at, 1, "0123456789.-+eExXpP{}vVsSzZ \n"[prng.below(29)]); break;
      }
    }
    const auto read = parse_cnt(text, "t.cnt");
    if (read.ok()) {
      ++accepted;
      ASSERT_TRUE(validate(read->stack).ok()) << text;
    } else {
      ASSERT_EQ(read.error().code, ErrorCode::invalid_input) << to_string(read.error());
      ASSERT_EQ(read.error().where.file, "t.cnt");
    }
  }
  EXPECT_GT(accepted, kTrials / 20);
  EXPECT_LT(accepted, kTrials * 9 / 10);
}

// One pass: 400 sections with contours of 1,000 vertices are read in time that shows no
// quadratic term, also under sanitizers.
TEST(ReadCnt, IsLinear) {
  std::string text = "S 400\n";
  for (int s = 0; s < 400; ++s) {
    text += "v 1000 z " + std::to_string(s) + "\n{\n";
    for (int i = 0; i < 1000; ++i) {
      const double angle = 0.006283185307179586 * i;
      text += std::to_string(100 * std::cos(angle)) + ' ' + std::to_string(100 * std::sin(angle)) +
              '\n';
    }
    text += "}\n";
  }
  const auto start = std::chrono::steady_clock::now();
  const auto read = parse_cnt(text, "t.cnt");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.vertex_count(), 400'000U);
  EXPECT_LT(seconds.count(), 20.0);
}

}  // namespace
}  // namespace tetloft
