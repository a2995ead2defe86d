// tetloft between: the longer stack as a file, and what is decided about it.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <tetloft/between.hpp>
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

// Two towers that lean; solid below, the first with a hole above.
constexpr const char* kTowers =
    "S 3\nv 8 z 0\n{ 0 0 8 0 8 8 0 8 }\n{ 20 0 24 0 24 4 20 4 }\n"
    "v 12 z 2\n{ 1 0 9 0 9 8 1 8 }\n{ 3 2 6 2 6 5 3 5 }\n{ 21 0 25 0 25 4 21 4 }\n"
    "v 12 z 4\n{ 2 0 10 0 10 8 2 8 }\n{ 4 2 7 2 7 5 4 5 }\n{ 22 0 26 0 26 4 22 4 }\n";

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::size_t lines_of(const std::string& text, const std::string& word) {
  const auto lines = lines_in(text);
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(),
                    [&](const std::string& line) { return line.starts_with(word + ' '); }));
}

class BetweenCommand : public testing::Test {
 protected:
  BetweenCommand() { test::put(in_, kTowers); }

  // The words that make the longer stack mean what the shorter one did.
  [[nodiscard]] std::vector<std::string> decided(std::vector<std::string> words) const {
    for (const std::string& word :
         {std::string("--correspondence"), std::string("overlap"), std::string("--no-chain"),
          std::string("--no-lone"), std::string("--labels"), labels_}) {
      words.push_back(word);
    }
    return words;
  }

  TempFolder folder_;
  std::string in_ = folder_.file("a.cnt");
  std::string out_ = folder_.file("long.cnt");
  std::string labels_ = folder_.file("long.labels");
  std::string model_ = folder_.file("m.vtu");
};

TEST_F(BetweenCommand, WritesTheLongerStackOfTheLibrary) {
  const Outcome told =
      run({"between", in_, "-o", out_, "--sections", "2", "--labels-out", labels_});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_NE(told.out.find("7 sections, 4 of them put between"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("2 components"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("written: " + out_ + ", " + labels_), std::string::npos) << told.out;
  const auto given = read_cnt(in_);
  ASSERT_TRUE(given.ok());
  const auto made = between(given->stack, {.sections = 2});
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(test::get(out_), format_cnt(made->stack).value());
  Labels labels;
  labels.decisions = made->correspondence.decisions;
  labels.void_decisions = made->correspondence.voids.decisions;
  EXPECT_EQ(test::get(labels_), format_labels(labels).value());
  EXPECT_GE(lines_of(test::get(labels_), "join"), 12U);
  EXPECT_GE(lines_of(test::get(labels_), "open"), 1U);
}

TEST_F(BetweenCommand, IsTakenBackAsTheSameSolid) {
  for (const std::string name : {"", "bifurcation.cnt", "cases/ring.cnt", "cases/fork.cnt",
                                 "cases/voids/one_two.cnt", "cases/voids/holes_wm4_20.cnt"}) {
    const std::string stack = name.empty() ? in_ : std::string(TETLOFT_DATA_DIR) + '/' + name;
    SCOPED_TRACE(stack);
    // Which coarse edges are divided depends on the neighbouring sections, which are others.
    const JsonValue shorter =
        run_json({"reconstruct", stack, "-o", model_, "--between", "1", "--verify", "--no-divide"});
    const JsonValue of_shorter = run_json({"check", model_, stack});
    ASSERT_EQ(run({"between", stack, "-o", out_, "--sections", "1", "--labels-out", labels_,
                   "--no-divide"})
                  .code,
              0);
    const JsonValue longer =
        run_json(decided({"reconstruct", out_, "-o", model_, "--verify", "--no-divide"}));
    EXPECT_EQ(longer.at("components").number, shorter.at("components").number);
    EXPECT_EQ(longer.at("tets").number, shorter.at("tets").number);
    EXPECT_EQ(longer.at("volume").number, shorter.at("volume").number);
    const JsonValue of_longer = run_json(decided({"check", model_, out_}));
    EXPECT_TRUE(of_longer.at("pass").boolean);
    EXPECT_EQ(of_longer.at("cavities").number, of_shorter.at("cavities").number);
  }
}

TEST_F(BetweenCommand, TellsInJson) {
  const JsonValue json = run_json({"between", in_, "-o", out_, "--sections=1"});
  EXPECT_EQ(json.at("slices").number, 5);
  EXPECT_EQ(json.at("inserted").number, 2);
  EXPECT_EQ(json.at("components").number, 2);
  EXPECT_GE(json.at("contours").number, 12);
  EXPECT_EQ(json.at("decisions").at("join").number, 8);
  EXPECT_EQ(json.at("decisions").at("part").number, 0);
  EXPECT_GE(json.at("decisions").at("open").number, 1);
  EXPECT_TRUE(json.at("decisions").has("close"));
  const auto& sections = json.at("sections").array;
  ASSERT_EQ(sections.size(), 5U);
  EXPECT_EQ(sections[1].at("z").number, 1);
  EXPECT_TRUE(sections[1].at("inserted").boolean);
  EXPECT_EQ(sections[1].at("slab").number, 0);
  EXPECT_FALSE(sections[1].has("section"));
  EXPECT_FALSE(sections[2].at("inserted").boolean);
  EXPECT_EQ(sections[2].at("section").number, 1);
  EXPECT_FALSE(sections[2].has("slab"));
  ASSERT_EQ(sections[2].at("components").array.size(), 3U);
  EXPECT_EQ(sections[2].at("components").array[1].number, 0);
  EXPECT_EQ(sections[2].at("components").array[2].number, 1);
  EXPECT_TRUE(json.has("warnings"));
}

TEST_F(BetweenCommand, TakesTheOptionsOfAReconstruction) {
  // What is asked of the shorter stack is in what is decided about the longer one.
  const std::string asked = folder_.file("asked.labels");
  test::put(asked, "part 0 1 2\n");
  ASSERT_EQ(run({"between", in_, "-o", out_, "--sections", "1", "--labels", asked, "--labels-out",
                 labels_})
                .code,
            0);
  EXPECT_EQ(
      run_json(decided({"reconstruct", out_, "-o", model_, "--verify"})).at("components").number,
      3);
  ASSERT_EQ(run({"between", in_, "-o", out_, "--voids", "free", "--labels-out", labels_}).code, 0);
  EXPECT_EQ(lines_of(test::get(labels_), "open") + lines_of(test::get(labels_), "close"), 0U);
  EXPECT_TRUE(run_json({"between", in_, "-o", out_, "--snap", "20"}).has("snap"));
  EXPECT_EQ(run_json({"between", in_, "-o", out_, "--sections", "none"}).at("inserted").number, 0);
  EXPECT_EQ(test::get(out_), format_cnt(read_cnt(in_)->stack).value());
  const std::string by_one = folder_.file("one.cnt");
  ASSERT_EQ(run({"between", in_, "-o", by_one, "--sections", "3", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"between", in_, "-o", out_, "--sections", "3", "--threads", "3"}).code, 0);
  EXPECT_EQ(test::get(out_), test::get(by_one));
}

TEST_F(BetweenCommand, PutsAsManyBetweenAsAreCalledFor) {
  EXPECT_EQ(run_json({"between", in_, "-o", out_}).at("inserted").number, 0);
  const std::string far = folder_.file("far.cnt");
  test::put(far, "S 2\nv 4 z 0\n{ 0 0 4 0 4 4 0 4 }\nv 4 z 20\n{ 1 0 5 0 5 4 1 4 }\n");
  EXPECT_EQ(run_json({"between", far, "-o", out_}).at("inserted").number, 2);
  EXPECT_EQ(run_json({"between", far, "-o", out_, "--sections", "auto"}).at("inserted").number, 2);
  EXPECT_TRUE(run({"between", far, "-o", out_, "--quiet"}).out.empty());
}

TEST_F(BetweenCommand, RefusesWhatMakesNoSense) {
  expect_failure({"between"}, 2, "usage", "missing IN");
  expect_failure({"between", in_}, 2, "usage", "missing option --output (-o) OUT");
  expect_failure({"between", in_, "-o", folder_.file("o.vtu")}, 2, "usage", ".cnt");
  expect_failure({"between", in_, "-o", in_}, 2, "usage", "overwrite");
  expect_failure({"between", in_, "-o", out_, "--labels-out", folder_.file("l.csv")}, 2, "usage",
                 ".labels", {out_});
  test::put(labels_, "");
  expect_failure({"between", in_, "-o", out_, "--labels", labels_, "--labels-out", labels_}, 2,
                 "usage", "overwrite", {out_});
  for (const char* count : {"many", "65", "-1", "1.5"}) {
    expect_failure({"between", in_, "-o", out_, "--sections", count}, 2, "usage",
                   "neither auto nor none nor a number from 0 to 64", {out_});
  }
  expect_failure({"between", in_, "-o", out_, "--verify"}, 2, "usage", "--verify", {out_});
  expect_failure({"between", folder_.file("none.cnt"), "-o", out_}, 4, "io", "none.cnt", {out_});
  test::put(in_, test::kBowtie);
  expect_failure({"between", in_, "-o", out_, "--labels-out", folder_.file("n.labels")}, 3,
                 "invalid_input", in_ + ":3", {out_, folder_.file("n.labels")});
  EXPECT_EQ(run({"between", in_, "-o", out_, "--repair"}).code, 0);
}

}  // namespace
}  // namespace tetloft
