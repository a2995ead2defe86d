// tetloft links, and the decisions that labels files hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::TempFolder;

/// Two towers; a third that starts beside the second and is joined to it, for it is lone.
constexpr const char* kTowers =
    "S 3\nv 8 z 0\n{ 0 0 4 0 4 4 0 4 }\n{ 10 0 14 0 14 4 10 4 }\n"
    "v 8 z 2\n{ 0 0 4 0 4 4 0 4 }\n{ 11 0 15 0 15 4 11 4 }\n"
    "v 12 z 4\n{ 0 0 4 0 4 4 0 4 }\n{ 11 0 15 0 15 4 11 4 }\n{ 15.5 1 17 1 17 2 15.5 2 }\n";

std::vector<std::string> decisions_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.front() != '#') lines.push_back(line.substr(0, line.find("  #")));
  }
  return lines;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << text;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

template <class Row>
void expect_same_links(const std::vector<Row>& a, const std::vector<Row>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].slab, b[i].slab);
    EXPECT_EQ(a[i].lower, b[i].lower);
    EXPECT_EQ(a[i].upper, b[i].upper);
    EXPECT_EQ(a[i].fate == LinkFate::made, b[i].fate == LinkFate::made);
  }
}

class LinksCommand : public testing::Test {
 protected:
  LinksCommand() { test::put(in_, kTowers); }

  [[nodiscard]] double components(const std::vector<std::string>& extra) const {
    std::vector<std::string> words{"reconstruct", in_, "-o", model_, "--verify"};
    words.insert(words.end(), extra.begin(), extra.end());
    return run_json(words).at("components").number;
  }

  TempFolder folder_;
  std::string in_ = folder_.file("a.cnt");
  std::string model_ = folder_.file("m.vtu");
  std::string labels_ = folder_.file("l.labels");
};

TEST_F(LinksCommand, ListsTheLeastSureFirst) {
  const Outcome told = run({"links", in_, "--correspondence", "overlap"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(told.err.empty()) << told.err;
  const auto lines = decisions_in(told.out);
  ASSERT_EQ(lines.size(), 5U) << told.out;
  EXPECT_EQ(lines[0], "join 1 1 2") << told.out;
  EXPECT_NE(
      told.out.find("join 1 1 2  # lone: ratio 0, moved 0, distance 0.25, margin 0.25, lead -1.25"),
      std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("2 components, links: 5 made (4 by overlap, 1 by lone); 0 nearly"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("# S 1: 3 made (2 by overlap, 1 by lone); 0 nearly"), std::string::npos)
      << told.out;
}

TEST_F(LinksCommand, ListsWhatWasNearlyMade) {
  const Outcome told = run(
      {"links", in_, "--correspondence", "overlap", "--overlap", "0.8", "--no-chain", "--no-lone"});
  EXPECT_NE(told.out.find("part 0 1 1  # overlap, too weak: ratio 0.75"), std::string::npos)
      << told.out;
}

TEST_F(LinksCommand, IsTakenBackUnchanged) {
  for (const std::string name : {"", "bifurcation.cnt", "cases/ring.cnt", "cases/fork.cnt",
                                 "figures/fig18_drifting.cnt", "tooth.cnt"}) {
    const std::string stack = name.empty() ? in_ : std::string(TETLOFT_DATA_DIR) + '/' + name;
    for (const char* rule : {"overlap", "moved", "reverse"}) {
      SCOPED_TRACE(stack + ' ' + rule);
      ASSERT_EQ(run({"reconstruct", stack, "-o", model_, "--correspondence", rule}).code, 0);
      auto before = read_vtu(model_);
      ASSERT_EQ(run({"links", stack, "-o", labels_, "--correspondence", rule}).code, 0);
      const Outcome again =
          run({"reconstruct", stack, "-o", model_, "--correspondence", rule, "--labels", labels_});
      ASSERT_EQ(again.code, 0) << again.err;
      auto after = read_vtu(model_);
      ASSERT_TRUE(before.ok() && after.ok());
      // All is the same, but that it is the user who says so.
      for (const RegionLink& link : after->links) {
        EXPECT_TRUE(link.fate != LinkFate::made || link.evidence == Evidence::decision);
      }
      expect_same_links(before->links, after->links);
      expect_same_links(before->void_links, after->void_links);
      after->links = before->links;
      after->void_links = before->void_links;
      test::expect_same(*before, *after);
      EXPECT_EQ(run({"check", model_, stack, "--correspondence", rule, "--labels", labels_}).code,
                0);
      // What was decided is decided still, whatever the rule.
      const auto decided =
          decisions_in(run({"links", stack, "--correspondence", rule, "--labels", labels_}).out);
      auto sorted = decisions_in(test::get(labels_));
      EXPECT_EQ(decided.size(), sorted.size());
      EXPECT_TRUE(std::is_permutation(decided.begin(), decided.end(), sorted.begin()));
    }
  }
}

TEST_F(LinksCommand, IsTakenBackWithAnotherDecision) {
  EXPECT_EQ(components({}), 2);
  ASSERT_EQ(run({"links", in_, "-o", labels_}).code, 0);
  const std::string listing = test::get(labels_);
  test::put(labels_, replaced(listing, "join 1 1 2", "part 1 1 2"));
  EXPECT_EQ(components({"--labels", labels_}), 3);
  EXPECT_EQ(run({"check", model_, in_, "--labels", labels_}).code, 0);
  EXPECT_EQ(run({"check", model_, in_}).code, 1);
  test::put(labels_, replaced(listing, "join 0 0 0", "part 0 0 0"));
  EXPECT_EQ(components({"--labels", labels_}), 3);
  // A line alone: the others stay as the rule has them.
  test::put(labels_, "join 1 0 2 # a link that nothing suggests\n");
  EXPECT_EQ(components({"--labels", labels_}), 1);
}

TEST_F(LinksCommand, KeepsWhatTheUserDecided) {
  test::put(labels_, "1 0 7 # mine\n2 0 7\npart 1 1 2\n");
  const std::string next = folder_.file("next.labels");
  ASSERT_EQ(run({"links", in_, "--labels", labels_, "--first", "1", "-o", next}).code, 0);
  const auto lines = decisions_in(test::get(next));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "1 0 7");
  EXPECT_EQ(lines[1], "2 0 7");
  EXPECT_EQ(lines[3], "part 1 1 2");
  EXPECT_NE(test::get(next).find("listed: 2 of 5"), std::string::npos) << test::get(next);
  EXPECT_EQ(components({"--labels", next}), 3);
}

TEST_F(LinksCommand, TellsInJson) {
  const JsonValue json = run_json({"links", in_, "--correspondence", "overlap", "--first", "2"});
  EXPECT_EQ(json.at("slices").number, 3);
  EXPECT_EQ(json.at("contours").number, 7);
  EXPECT_EQ(json.at("components").number, 2);
  EXPECT_EQ(json.at("made").at("overlap").number, 4);
  EXPECT_EQ(json.at("made").at("lone").number, 1);
  EXPECT_EQ(json.at("not_made").at("too_weak").number, 0);
  EXPECT_FALSE(json.at("not_made").has("made"));
  const auto& links = json.at("links").array;
  ASSERT_EQ(links.size(), 5U);
  const JsonValue& lone = links[4];
  EXPECT_EQ(lone.at("slab").number, 1);
  EXPECT_EQ(lone.at("lower").number, 1);
  EXPECT_EQ(lone.at("upper").number, 2);
  EXPECT_TRUE(lone.at("made").boolean);
  EXPECT_EQ(lone.at("evidence").string, "lone");
  EXPECT_EQ(lone.at("fate").string, "made");
  EXPECT_EQ(lone.at("distance").number, 0.25);
  EXPECT_EQ(lone.at("margin").number, 0.25);
  EXPECT_EQ(lone.at("lead").number, -1.25);
  EXPECT_FALSE(links[0].has("lead"));
  EXPECT_EQ(lone.at("ratio").number, 0);
  EXPECT_EQ(lone.at("moved").number, 0);
  EXPECT_TRUE(links[0].has("margin"));
  EXPECT_EQ(links[1].at("ratio").number, 0.75);
  ASSERT_EQ(json.at("least_sure").array.size(), 2U);
  EXPECT_EQ(json.at("least_sure").array[0].number, 4);
  EXPECT_TRUE(json.at("motions").array.empty());
  EXPECT_TRUE(json.at("warnings").array.empty());
}

TEST_F(LinksCommand, TellsMotionsInJson) {
  const JsonValue json = run_json({"links", in_, "--correspondence", "moved"});
  for (const JsonValue& motion : json.at("motions").array) {
    EXPECT_EQ(motion.at("by").array.size(), 2U);
    EXPECT_GE(motion.at("section").number, motion.at("slab").number);
    EXPECT_EQ(motion.at("contour").kind, JsonValue::Kind::number);
  }
  EXPECT_FALSE(json.at("motions").array.empty());
}

TEST_F(LinksCommand, WritesAFileOrStandardOutput) {
  const std::string listing = run({"links", in_}).out;
  const Outcome written = run({"links", in_, "-o", labels_});
  EXPECT_EQ(written.code, 0);
  EXPECT_EQ(test::get(labels_), listing);
  EXPECT_NE(written.out.find("written: " + labels_), std::string::npos) << written.out;
  EXPECT_NE(written.out.find("the least sure: join "), std::string::npos) << written.out;
  // Quiet: no comments but those of the lines.
  const std::string quiet = run({"links", in_, "--quiet"}).out;
  EXPECT_EQ(quiet.rfind("join ", 0), 0U) << quiet;
  EXPECT_EQ(decisions_in(quiet), decisions_in(listing));
  EXPECT_TRUE(run({"links", in_, "-o", labels_, "--quiet"}).out.empty());
  EXPECT_EQ(run({"links", in_, "--threads", "3"}).out, listing);
}

TEST_F(LinksCommand, PreparesTheStackAsReconstructDoes) {
  test::put(in_, test::kBowtie);
  EXPECT_EQ(run({"links", in_}).code, 3);
  const Outcome repaired = run({"links", in_, "--repair"});
  EXPECT_EQ(repaired.code, 0) << repaired.err;
  EXPECT_EQ(decisions_in(repaired.out).size(), 2U) << repaired.out;
  EXPECT_TRUE(run_json({"links", in_, "--repair", "--snap", "20"}).has("snap"));
}

TEST_F(LinksCommand, OfASingleSectionAreNone) {
  test::put(in_, "S 1\nv 4 z 5\n{ 0 0 2 0 2 2 0 2 }\n");
  const Outcome told = run({"links", in_});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(decisions_in(told.out).empty());
  EXPECT_NE(told.out.find("1 section, 1 component, links: 0 made; 0 nearly"), std::string::npos)
      << told.out;
}

TEST_F(LinksCommand, RefusesWhatMakesNoSense) {
  expect_failure({"links"}, 2, "usage", "missing IN");
  expect_failure({"links", in_, "-o", folder_.file("l.csv")}, 2, "usage", ".labels");
  expect_failure({"links", in_, "--first", "0"}, 2, "usage", "--first");
  expect_failure({"links", in_, "--verify"}, 2, "usage", "--verify");
  test::put(labels_, "");
  expect_failure({"links", in_, "--labels", labels_, "-o", labels_}, 2, "usage", "overwrite");
  expect_failure({"links", folder_.file("none.cnt"), "-o", folder_.file("o.txt")}, 4, "io",
                 "none.cnt", {folder_.file("o.txt")});
}

TEST_F(LinksCommand, DecisionsThatNameNothingAreRefused) {
  const auto expect = [&](const std::string& text, const std::string& word) {
    test::put(labels_, text);
    for (const char* command : {"reconstruct", "links"}) {
      const std::string out = folder_.file(command == std::string("links") ? "o.txt" : "o.vtu");
      expect_failure({command, in_, "-o", out, "--labels", labels_}, 3, "invalid_input", word,
                     {out});
    }
  };
  expect("join 0 1 1\nunite 0 0 0\n", labels_ + ":2: 'unite' is neither join, part");
  expect("join 0 1\n", labels_ + ":1: expected \"join section contour contour_above\"");
  expect("part 0 9 0\n", labels_ + ": section 0, contour 9: part names a contour that");
  expect("join 1 0 3\n", labels_ + ": section 2, contour 3: join names a contour that");
  expect("join 2 0 0\n", "section 2, contour 0: join names the last section");
  expect("join 7 0 0\n", "section 7, contour 0: join names a contour that");
  expect("join 1 0 0\npart 1 0 0\n",
         labels_ + ":2: join and part of the same contours: see line 1");
  expect("0 0 1\n1 1 2\njoin 0 0 1\n", "labels, 1 and 2, part them");
}

TEST_F(LinksCommand, ReconstructTellsThemToo) {
  const Outcome made = run({"reconstruct", in_, "-o", model_, "--correspondence", "overlap"});
  EXPECT_NE(made.out.find("links: 5 made (4 by overlap, 1 by lone); 0 nearly; the least sure: "
                          "join 1 1 2 (lone: "),
            std::string::npos)
      << made.out;
  const JsonValue links = run_json({"reconstruct", in_, "-o", model_}).at("links");
  EXPECT_EQ(links.at("made").at("lone").number, 1);
  EXPECT_EQ(links.at("not_made").at("unrealisable").number, 0);
  ASSERT_EQ(links.at("least_sure").array.size(), 5U);
  EXPECT_EQ(links.at("least_sure").array[0].at("evidence").string, "lone");
}

}  // namespace
}  // namespace tetloft
