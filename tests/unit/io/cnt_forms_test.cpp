// Forms in which people's programs write .cnt: triples, commas, comments, open lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/io.hpp>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

// A convex polygon with numbers of many digits.
Contour polygon(std::size_t n, Prng& prng, Point2 centre = {0, 0}) {
  Contour contour;
  const double turn = static_cast<double>(prng.below(1000)) / 1000;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        6.283185307179586 * (static_cast<double>(i) + turn) / static_cast<double>(n);
    contour.vertices.push_back({centre.x + 5 * std::cos(angle), centre.y + 5 * std::sin(angle)});
  }
  return contour;
}

SectionStack polygons(std::size_t n, Prng& prng) {
  SectionStack stack;
  for (int s = 0; s < 3; ++s) {
    Section section{s == 0 ? 0.0 : s + 0.1 * s, {}};
    for (int c = 0; c < 2 && s != 1; ++c) {
      section.contours.push_back(polygon(n, prng, {c * 20.0, 1}));
    }
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

using VertexText = std::function<std::string(const Point2&, double z)>;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string text_of(const SectionStack& stack, const VertexText& vertex, double count_factor = 1) {
  std::string text = "S " + std::to_string(stack.sections.size()) + '\n';
  for (const Section& section : stack.sections.raw()) {
    std::size_t n = 0;
    for (const Contour& contour : section.contours.raw()) n += contour.vertices.size();
    text += "v " + number(std::floor(count_factor * static_cast<double>(n))) + " z " +
            number(section.z) + '\n';
    for (const Contour& contour : section.contours.raw()) {
      text += "{\n";
      for (const Point2& p : contour.vertices) text += vertex(p, section.z) + '\n';
      text += "}\n";
    }
  }
  return text;
}

std::string pair(const Point2& p, double) { return number(p.x) + ' ' + number(p.y); }
std::string triple(const Point2& p, double z) { return pair(p, z) + ' ' + number(z); }
std::string tilted(const Point2& p, double z) { return pair(p, z) + ' ' + number(z + p.x / 8); }

void expect_same_stack(const SectionStack& a, const SectionStack& b) {
  ASSERT_EQ(a.sections.size(), b.sections.size());
  for (std::size_t s = 0; s < a.sections.size(); ++s) {
    const Section& x = a.sections[SectionId(s)];
    const Section& y = b.sections[SectionId(s)];
    EXPECT_EQ(test::bits(x.z), test::bits(y.z));
    ASSERT_EQ(x.contours.size(), y.contours.size());
    for (std::size_t c = 0; c < x.contours.size(); ++c) {
      EXPECT_EQ(x.contours[ContourId(c)].vertices, y.contours[ContourId(c)].vertices);
    }
  }
}

void expect_refused(const std::string& text, const std::string& words, std::size_t line = 0) {
  for (const Validity validity : {Validity::required, Validity::unchecked}) {
    const auto read = parse_cnt(text, "t.cnt", validity);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
    EXPECT_NE(read.error().message.find(words), std::string::npos) << read.error().message;
    EXPECT_EQ(read.error().where.file, "t.cnt");
    if (line != 0) {
      EXPECT_EQ(read.error().where.line, line);
    }
  }
}

// Odd and even numbers of numbers, multiples of six among them.
const std::vector<std::size_t> kCorners{3, 4, 5, 6, 7, 8, 9, 12, 18, 60};

TEST(CntTriples, AreReadAsSuchWithOneWarning) {
  Prng prng(15);
  for (const std::size_t n : kCorners) {
    const SectionStack stack = polygons(n, prng);
    // Right counts, and counts of nothing: then validity must tell.
    for (const double factor : {1.0, 0.0, 3.0}) {
      const std::string text = text_of(stack, triple, factor);
      for (const Validity validity : {Validity::required, Validity::unchecked}) {
        const auto read = parse_cnt(text, "t.cnt", validity);
        ASSERT_TRUE(read.ok()) << n << ' ' << to_string(read.error());
        expect_same_stack(read->stack, stack);
        std::size_t told = 0;
        for (const Warning& warning : read->warnings) {
          if (warning.message.find("three numbers to a vertex") == std::string::npos) continue;
          ++told;
          EXPECT_EQ(warning.where.line, 3U);
        }
        EXPECT_EQ(told, 1U);
        if (factor == 1) {
          EXPECT_EQ(read->warnings.size(), 1U);
        }
      }
    }
  }
}

TEST(CntTriples, OutOfTheirPlaneAreNamed) {
  Prng prng(16);
  for (const std::size_t n : kCorners) {
    expect_refused(text_of(polygons(n, prng), tilted), "three numbers to a vertex", 3);
  }
}

TEST(CntTriples, AreOnlySupposedWhereNothingButAnOddNumberTellsOfThem) {
  // One number of ten is missing; nine are three times three.
  expect_refused("S 1\nv 5 z 0\n{ 0 0 9 0 9 9 4 7 1 }\n",
                 "odd number of coordinates; if it has three numbers to a vertex", 3);
}

TEST(CntTriples, MayCloseTheirContours) {
  Prng prng(17);
  for (const std::size_t n : kCorners) {
    const SectionStack stack = polygons(n, prng);
    SectionStack closed = stack;
    for (Section& section : closed.sections.raw()) {
      for (Contour& contour : section.contours) {
        contour.vertices.push_back(Point2(contour.vertices.front()));
      }
    }
    const auto read = parse_cnt(text_of(closed, triple), "t.cnt");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    expect_same_stack(read->stack, stack);
  }
}

TEST(CntPairs, AreNeverTakenForTriples) {
  Prng prng(18);
  for (const std::size_t n : kCorners) {
    const SectionStack stack = polygons(n, prng);
    // Whatever is announced: right counts, none, and those that triples would have.
    for (const double factor : {1.0, 0.0, 2.0 / 3, 3.0}) {
      const auto read = parse_cnt(text_of(stack, pair, factor), "t.cnt");
      ASSERT_TRUE(read.ok()) << n << ' ' << to_string(read.error());
      expect_same_stack(read->stack, stack);
    }
  }
  // Zero at every third place, in the plane z = 0.
  const std::string text = "S 1\nv 6 z 0\n{ 1 2  0 -1  -4 0  -5 1  0 3  -1 0 }\n";
  ASSERT_EQ(parse_cnt(text, "t.cnt", Validity::unchecked)->stack.vertex_count(), 6U);
}

TEST(CntSeparators, BetweenNumbersAreReadAsSpace) {
  Prng prng(19);
  const SectionStack stack = polygons(6, prng);
  for (const std::string between : {",", ", ", " ,", "\t;\n", ";"}) {
    for (const std::string after : {"", ",", ";", " , "}) {
      const VertexText form = [&](const Point2& p, double) {
        return number(p.x) + between + number(p.y) + after;
      };
      const auto read = parse_cnt(text_of(stack, form), "t.cnt");
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      EXPECT_TRUE(read->warnings.empty());
      expect_same_stack(read->stack, stack);
    }
  }
}

TEST(CntSeparators, WithoutANumberAreNamed) {
  for (const char* numbers :
       {",0 0 1 0 1 1", "0,,0 1 0 1 1", "0 0;,1 0 1 1", "0 0 1 0 1 1,,", ","}) {
    expect_refused("S 1\nv 3 z 0\n{\n" + std::string(numbers) + "}\n", "a number is missing", 4);
  }
  expect_refused("S 1\nv 3 z 0,0\n{ 0 0 1 0 1 1 }\n", "',0'", 2);
}

TEST(CntSeparators, AreNamedWhereTheyAreDecimalCommas) {
  Prng prng(20);
  for (const std::size_t n : kCorners) {
    const VertexText form = [](const Point2& p, double) {
      std::string text = pair(p, 0);
      for (char& c : text) c = c == '.' ? ',' : c;
      return text;
    };
    SectionStack stack = polygons(n, prng);
    for (Section& section : stack.sections.raw()) {
      section.z = std::floor(section.z);
      // Every number with a fraction, as programs of such a locale write them.
      for (Contour& contour : section.contours) {
        for (Point2& p : contour.vertices) {
          p = {std::floor(p.x * 64) / 64 + 1.0 / 128, std::floor(p.y * 64) / 64 + 1.0 / 128};
        }
      }
    }
    expect_refused(text_of(stack, form), "decimal");
  }
}

TEST(CntComments, AreReadAsSpaceAnywhere) {
  const std::string text =
      "S 2\nv 3 z 0\n{\n0 0\n10 0\n10 10\n}\nv 3 z 1\n{\n0 0\n10 0\n10 10\n}\n";
  const auto plain = parse_cnt(text, "t.cnt");
  ASSERT_TRUE(plain.ok());
  for (const std::string comment : {"#", "# {v 3 z 1}, S 2 \xC3\xA9", "#0 0"}) {
    for (std::size_t at = 0; at <= text.size(); ++at) {
      // Between tokens, and glued to the end of one.
      if (at > 0 && at < text.size() && text[at] != '\n') continue;
      std::string commented = text;
      commented.insert(at, comment + '\n');
      const auto read = parse_cnt(commented, "t.cnt");
      ASSERT_TRUE(read.ok()) << commented << to_string(read.error());
      EXPECT_TRUE(read->warnings.empty());
      expect_same_stack(read->stack, plain->stack);
    }
  }
  // Lines count on.
  expect_refused("# one\nS 1 # two\n# three\nv 3 z 0 {\n0 0 # five\n1 x\n}", "'x'", 6);
}

// A level line from one side of a frame of 100 to another, and a square frame above it.
std::string level_line(double from_y, double to_y, double wave, bool closed_along_frame) {
  std::string text = "S 2\nv 0 z 0\n{\n";
  for (int i = 0; i <= 50; ++i) {
    const double t = i / 50.0;
    text += number(100 * t) + ' ' +
            number(from_y + (to_y - from_y) * t + wave * std::sin(9 * t) * t * (1 - t)) + '\n';
  }
  if (closed_along_frame) text += "100 100\n0 100\n";
  return text + "}\nv 4 z 5\n{ 0 0 100 0 100 100 0 100 }\n";
}

std::size_t told_open(const ReadStack& read) {
  std::size_t told = 0;
  for (const Warning& warning : read.warnings) {
    if (warning.message.find("open line") == std::string::npos) continue;
    EXPECT_EQ(warning.where.line, 3U);
    EXPECT_EQ(warning.where.contour, 0U);
    ++told;
  }
  return told;
}

TEST(CntOpenLines, AreNotClosedWithoutAWord) {
  for (const double to_y : {10.0, 40.0, 80.0}) {
    // Straight, so that its chord crosses nothing.
    const auto read = parse_cnt(level_line(40, to_y, 0, false), "t.cnt", Validity::unchecked);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(told_open(*read), 1U);
    const auto crossing = parse_cnt(level_line(40, to_y, 40, false), "t.cnt");
    ASSERT_FALSE(crossing.ok());
    EXPECT_NE(crossing.error().message.find("open line"), std::string::npos)
        << crossing.error().message;
    EXPECT_EQ(crossing.error().where.line, 3U);
  }
}

TEST(CntOpenLines, ClosedAlongTheFrameAreFine) {
  for (const double to_y : {10.0, 40.0, 80.0}) {
    const auto read = parse_cnt(level_line(40, to_y, 40, true), "t.cnt");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(told_open(*read), 0U);
  }
  // Neither is a contour that ends at the side of the frame where it began.
  std::string bump = "S 1\nv 0 z 0\n{\n";
  for (int i = 0; i <= 40; ++i) {
    bump += number(i) + ' ' + number(std::sin(3.14159 * i / 40) * (i == 40 ? 0 : 9)) + '\n';
  }
  const auto read = parse_cnt(bump + "}\n", "t.cnt");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(told_open(*read), 0U);
}

TEST(CntOpenLines, AreClosedOnRequest) {
  ReadOptions options;
  options.close_on_frame = true;
  for (const double to_y : {10.0, 80.0}) {
    for (const double wave : {0.0, 40.0}) {
      // Above it a square, which the line's lower side does not hold.
      std::string text = level_line(40, to_y, wave, false);
      text.resize(text.find("v 4 z 5"));
      text += "v 4 z 5\n{ 100 90 90 90 90 100 100 100 }\n";
      const auto read = parse_stack(text, "t.cnt", options);
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      const Section& section = read->stack.sections[SectionId(0)];
      ASSERT_EQ(section.contours.size(), 1U);
      const std::vector<Point2>& v = section.contours[ContourId(0)].vertices;
      ASSERT_GE(v.size(), 53U);
      // No line ends above: the frame is beyond the square.
      for (const double x : {0.0, 100.0}) {
        EXPECT_TRUE(std::any_of(v.begin(), v.end(),
                                [&](const Point2& p) { return p.x == x && p.y > 100; }));
      }
      EXPECT_EQ(read->lines[SectionId(0)][ContourId(0)], 3U);
    }
  }
  // Contours along the frame are none.
  const auto closed = parse_stack(level_line(40, 40, 40, true), "t.cnt", options);
  ASSERT_TRUE(closed.ok());
  EXPECT_EQ(closed->stack.contour_count(), 2U);
}

TEST(CntWarnings, ThatAreManyAreSummedUp) {
  std::string text = "S 1\nv 0 z 0\n";
  for (int i = 0; i < 3000; ++i) {
    const std::string x = std::to_string(3 * i);
    text += "{ " + x + " 0 " + x + " 1 " + std::to_string(3 * i + 1) + " 0 " + x + " 0 }\n";
  }
  const auto read = parse_cnt(text, "t.cnt");
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->warnings.size(), 1001U);
  EXPECT_EQ(read->warnings.back().message, "and 2001 more warnings of this file");
}

TEST(CntSections, ThatAreAllEmptyAreRefused) {
  for (const char* text : {"S 2\nv 0 z 0\nv 0 z 1\n", "S 1\nv 0 z 0", "S 0\n"}) {
    EXPECT_FALSE(parse_cnt(text, "t.cnt").ok()) << text;
  }
  EXPECT_TRUE(parse_cnt("S 2\nv 0 z 0\nv 3 z 1 { 0 0 1 0 0 1 }\n", "t.cnt").ok());
}

TEST(CntSections, NearlyInOnePlaneAreTold) {
  const auto read = parse_cnt(
      "S 4\nv 0 z 0\n{0 0 1 0 0 1}\nv 0 z 2\n{0 0 1 0 0 1}\nv 0 z 2.001\n{0 0 1 0 0 1}\n"
      "v 0 z 5\n{0 0 1 0 0 1}\n",
      "t.cnt");
  ASSERT_TRUE(read.ok());
  std::size_t told = 0;
  for (const Warning& warning : read->warnings) {
    if (warning.message.find("two planes") == std::string::npos) continue;
    ++told;
    EXPECT_EQ(warning.where.line, 6U);
    EXPECT_EQ(warning.where.section, 2U);
  }
  EXPECT_EQ(told, 1U);
}

}  // namespace
}  // namespace tetloft
