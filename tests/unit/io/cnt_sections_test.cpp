// The sections of a .cnt, one after the other: those of the reader of the whole, with its warnings,
// its errors and its places, wherever blocks end.
#include "io/cnt_sections.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "core/prng.hpp"
#include "unit/io/cnt_sections_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using io::CntBlocks;
using test::expect_same;
using test::expect_sections;
using test::Spied;
using test::SpiedBytes;

enum class Outcome { refused, whole, streamed };

// Where the n-th section begins: at the n-th v that no comment holds.
std::size_t line_of_section(const std::string& text, std::size_t n) {
  std::size_t line = 1;
  bool comment = false;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      comment = false;
    }
    comment = comment || c == '#';
    if (!comment && (c == 'v' || c == 'V') && n-- == 0) return line;
  }
  return 0;
}

void expect_places(SectionStream& sections, const std::string& text,
                   const IdVector<SectionId, IdVector<ContourId, std::size_t>>& lines) {
  for (std::size_t s = 0; s < lines.size(); ++s) {
    Place place;
    place.section = s;
    EXPECT_EQ(sections.located(place).line, line_of_section(text, s));
    EXPECT_EQ(sections.located(place).file, "t.cnt");
    for (const ContourId c : lines[SectionId(s)].ids()) {
      place.contour = c.index();
      EXPECT_EQ(sections.located(place).line, lines[SectionId(s)][c]);
    }
  }
  Place beyond;
  beyond.section = lines.size();
  EXPECT_FALSE(sections.located(beyond).line.has_value());
}

Outcome expect_as_whole(const std::string& text, const CntBlocks& blocks = test::kSmallBlocks,
                        bool places = true) {
  SCOPED_TRACE(text.substr(0, 400) + " in blocks of " + std::to_string(blocks.read));
  const std::string name = "t.cnt";
  const Result<ReadValidStack> whole = parse_valid_stack(text, name, {.format = "cnt"});
  const auto spied = std::make_shared<Spied>(Spied{text});
  auto file = std::make_unique<SpiedBytes>(spied);
  auto survey = io::survey_cnt(*file, name, blocks, {.threads = 1});
  EXPECT_LE(spied->largest_read, blocks.read);
  if (!survey) {
    EXPECT_FALSE(whole.ok());
    if (!whole) {
      EXPECT_EQ(survey.error().code, whole.error().code);
      EXPECT_EQ(to_string(survey.error()), to_string(whole.error()));
    }
    return Outcome::refused;
  }
  if (!survey->has_value()) return Outcome::whole;
  EXPECT_TRUE(whole.ok()) << to_string(whole.error());
  if (!whole) return Outcome::streamed;
  expect_same((*survey)->warnings, whole->warnings);
  io::CntSections sections(std::move(file), name, **std::move(survey), blocks);
  expect_sections(sections, whole->stack.stack());
  if (places) expect_places(sections, text, whole->lines);
  return Outcome::streamed;
}

// All that the format allows.
const std::string kRich =
    "\xEF\xBB\xBF# v 3 z 3 { not this }\r\nS 5 # five v's\nv 4 z 0\n{ 0 0, 8 0; 8 8 , 0 8 }\n"
    "V4\tz1# v\n{#{ v\n0 0\t0x1p3 0 # v 1 2\n8 8 0 8,}v 0 z 2 # empty\r\n\r\nV 8\n#v\nZ 3.5\r\n"
    "{0 0 9 0 9 9 0 9}{1,1;2,1;2,2;1,2}\n\n# v 9 z 9\nv 3 z 4{ 0 0 1 0 0 1 }\n# the end: v";

TEST(CntSectionStream, AreThoseOfTheWholeWhereverBlocksEnd) {
  ASSERT_TRUE(parse_valid_stack(kRich, "t.cnt").ok())
      << to_string(parse_valid_stack(kRich, "t.cnt").error());
  for (std::size_t read = 1; read <= 64; ++read) {
    for (const std::size_t validated : {std::size_t{1}, read, std::size_t{1000}}) {
      EXPECT_EQ(expect_as_whole(kRich, {.read = read, .validated = validated}), Outcome::streamed);
    }
  }
}

TEST(CntSectionStream, AreMendedWithTheWarningsOfTheWhole) {
  const std::string texts[] = {
      // counts, repeated vertices, a header that is wrong
      "S 7\nv 5 z 0\n{0 0 1 0 1 1 1 1 0 1 0 0}\nv 1 z 1\n{0 0 1 0 0 1}\n{5 5 6 5 5 6 5 5}",
      // planes too near to each other, in one part and in two
      "S 4\nv 3 z 0 {0 0 1 0 0 1}\nv 3 z 10 {0 0 1 0 0 1}\nv 3 z 10.001 {0 0 1 0 0 1}\n"
      "v 3 z 20 {0 0 1 0 0 1}\nv 3 z 30 {0 0 1 0 0 1}\nv 0 z 30.001\nv 3 z 40 {0 0 1 0 0 1}\n",
      // lines across the frame of all sections, and one that the next section puts inside
      "S 3\nv 8 z 0\n{0 0 1 1 2 1.5 3 1.7 4 1.7 5 1.5 6 1 7 .05}\nv 18 z 1\n\n"
      "{0 0 1 1 2 1.5 3 1.7 4 1.75 5 1.7 6 1.5 7 1 8 .05}\n"
      "{0 3 1 4 2 4.5 3 4.7 4 4.75 5 4.7 6 4.5 7 4 8 3}\nv 4 z 2 {1 0 2 0 2 1 1 1}"};
  std::size_t warnings = 0;
  for (const std::string& text : texts) {
    const auto whole = parse_valid_stack(text, "t.cnt");
    ASSERT_TRUE(whole.ok()) << to_string(whole.error());
    EXPECT_FALSE(whole->warnings.empty());
    warnings += whole->warnings.size();
    for (const std::size_t validated : {1U, 60U, 1000U}) {
      EXPECT_EQ(expect_as_whole(text, {.read = 7, .validated = validated}), Outcome::streamed);
    }
  }
  EXPECT_EQ(warnings, 9U);
}

TEST(CntSectionStream, TellAThousandWarningsInTheOrderOfTheWhole) {
  std::string text = "S 1\n";
  for (int s = 0; s < 1100; ++s) {
    text += "v 3 z " + std::to_string(s + (s % 3 == 0 ? 0.9999 : 0)) +
            "\n{0 0 1 1 2 1.5 3 1.7 4 1.7 5 1.5 6 1 7 .05 0 0 0 0}\n";
  }
  const auto whole = parse_valid_stack(text, "t.cnt");
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  EXPECT_EQ(whole->warnings.size(), 1001U);
  EXPECT_EQ(expect_as_whole(text, {.read = 100, .validated = 500}, false), Outcome::streamed);
  // Fewer of each kind than a thousand.
  const std::string few = text.substr(0, text.find("v 3 z 400"));
  EXPECT_EQ(expect_as_whole(few, {.read = 100, .validated = 500}, false), Outcome::streamed);
}

TEST(CntSectionStream, TellOfOpenLinesOfTheLastBoxAlone) {
  // Many that end at the box of the first sections, and many that end at that of all.
  std::string text = "S 1200\n";
  for (int s = 0; s < 1200; ++s) {
    text += "v 8 z " + std::to_string(s) + "\n{0 0 1 1 2 1.5 3 1.7 4 1.7 5 1.5 6 1 " +
            (s < 600 ? "7" : "7.1") + " .05}\n";
  }
  const auto whole = parse_valid_stack(text, "t.cnt");
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  EXPECT_EQ(whole->warnings.size(), 600U);
  EXPECT_EQ(expect_as_whole(text, {.read = 100, .validated = 500}, false), Outcome::streamed);
}

std::string section_text(double z, const std::string& contours) {
  return "v 3 z " + std::to_string(z) + "\n" + contours + "\n";
}

TEST(CntSectionStream, AreRefusedInTheWordsOfTheWhole) {
  const std::string fine = "{0 0 1 0 1 1 0 1}";
  const std::string touching = "{0 0 1 0 0 1}\n{0 0 -1 0 -1 -1}";
  const std::string open = "{0 0 1 0 2 0 3 0 2 0.5 3 0.5 9 9 0 1 9 8}";
  const std::vector<double> heights[] = {{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {0, 1, 1, 2, 3},
                                         {0, 2, 1, 3, 4}, {0, 1, 2, 4, 3}, {0, 1, 2, 3, 1e305}};
  int streamed = 0;
  int refused = 0;
  for (const auto& z : heights) {
    for (std::size_t bad = 0; bad <= z.size(); ++bad) {
      for (const std::string& contours : {touching, open}) {
        std::string text = "S 5\n";
        for (std::size_t s = 0; s < z.size(); ++s) {
          text += section_text(z[s], s == bad ? contours : fine);
        }
        for (const std::size_t validated : {1U, 70U, 1000U}) {
          const Outcome outcome = expect_as_whole(text, {.read = 16, .validated = validated});
          EXPECT_NE(outcome, Outcome::whole);
          ++(outcome == Outcome::streamed ? streamed : refused);
        }
      }
    }
  }
  EXPECT_EQ(streamed, 6);
  EXPECT_EQ(refused, 210);
}

TEST(CntSectionStream, OfWhatIsNoPairsAreReadAsAWhole) {
  for (const std::string text :
       {"S 1\nv 3 z 0\n{0 0 0 1 0 0 0 1 0}", "S 1\nv 3 z 0\n{0 0 1 0 0 1 7}",
        "S 1\nv 3 z 0\n{0,0 0,0 1,0 0,0 0,0 1,0}", "S 1\nv 3 z 0\n{0 0 1 0 0 1 7}\nv x",
        "S 2\nv 0 z 0\nv 0 z 1", "S 0"}) {
    EXPECT_EQ(expect_as_whole(text), Outcome::whole);
  }
  // Wrong counts alone are no reason.
  EXPECT_EQ(expect_as_whole("S 1\nv 7 z 0\n{0,0 1,0 1,1 0,1}"), Outcome::streamed);
}

TEST(CntSectionStream, OfFaultyFilesAreRefusedInTheWordsOfTheWhole) {
  for (const std::string text : {"",
                                 "# v\n",
                                 "x",
                                 "v 3 z 1",
                                 "Sv 3",
                                 "S v 3 z 1",
                                 "S 3v 1 z 1",
                                 "S -1",
                                 "S 1 { }",
                                 "S 1\nv 3 z 0 {0 0 1 0 v 3 z 1 {0 0 1 0 0 1}",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 vx 3 z 1}",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1v 3 z 1}",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1}v",
                                 "S 1\nv 3 z v 3",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1}x v 3 z 1",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1} }v 3 z 1",
                                 "S 1\nv 3 z 0 {0 0 1 0,,v 0 1}",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1}\nv3z1}v {0 0 1 0 0 1}",
                                 "S 1\nv v 3 z 1",
                                 "S 1\nv 0 z 1 }v23456789012345678901234567890123456789012345",

                                 "S 1\nv 3 v 3 z 1",
                                 "S 1\nv 3 z 0 {0 0 1 0 0 1}\n\n\n}v 3 z 1"}) {
    EXPECT_EQ(expect_as_whole(text), Outcome::refused);
    EXPECT_EQ(expect_as_whole(text + std::string(100, 'v')), Outcome::refused);
  }
}

TEST(CntSectionStream, OfFilesWithSlipsAnywhereAreThoseOfTheWhole) {
  constexpr std::string_view kBytes = "vVzsS{}#,; \n\r0123.e-x";
  Prng prng(2501);
  int outcomes[3] = {};
  for (int round = 0; round < 4000; ++round) {
    std::string text = kRich;
    for (std::uint64_t slips = 1 + prng.below(3); slips > 0; --slips) {
      const auto at = static_cast<std::size_t>(prng.below(text.size()));
      const char byte = kBytes[static_cast<std::size_t>(prng.below(kBytes.size()))];
      const std::uint64_t what = prng.below(3);
      if (what == 0) text[at] = byte;
      if (what == 1) text.insert(at, 1, byte);
      if (what == 2) text.erase(at, 1 + static_cast<std::size_t>(prng.below(4)));
    }
    const CntBlocks blocks{.read = 1 + static_cast<std::size_t>(prng.below(64)),
                           .validated = 1 + static_cast<std::size_t>(prng.below(200))};
    ++outcomes[static_cast<int>(expect_as_whole(text, blocks, false))];
    if (HasFailure()) FAIL() << "seed 2501, round " << round;
  }
  for (const int count : outcomes) EXPECT_GT(count, 100);
}

TEST(CntSectionStream, OfDataAreThoseOfTheWhole) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TETLOFT_DATA_DIR)) {
    const std::string path = entry.path().string();
    if (entry.path().extension() != ".cnt" || entry.file_size() > 400'000) continue;
    SCOPED_TRACE(path);
    ++files;
    const auto whole = read_valid_stack(path);
    const auto opened = open_sections(path);
    ASSERT_EQ(whole.ok(), opened.ok());
    if (!whole) {
      EXPECT_EQ(to_string(whole.error()), to_string(opened.error()));
      continue;
    }
    EXPECT_FALSE(opened->in_memory);
    EXPECT_EQ(opened->count, whole->stack.stack().sections.size());
    expect_same(opened->warnings, whole->warnings);
    expect_sections(*opened->sections, whole->stack.stack());
  }
  EXPECT_GT(files, 10U);
}

}  // namespace
}  // namespace tetloft
