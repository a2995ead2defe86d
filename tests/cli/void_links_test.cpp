// Links of voids on the command line: --voids, their listing, and what files of labels say of them.
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

// Solid ends. Two holes of which the first overlaps that above by a sixteenth; beside the second
// nothing.
constexpr const char* kHoles =
    "S 4\nv 4 z 0\n{ -40 -40 40 -40 40 40 -40 40 }\n"
    "v 12 z 3\n{ -40 -40 40 -40 40 40 -40 40 }\n{ -4 -4 4 -4 4 4 -4 4 }\n{ 20 0 22 0 22 2 20 2 }\n"
    "v 8 z 6\n{ -40 -40 40 -40 40 40 -40 40 }\n{ 2 2 10 2 10 10 2 10 }\n"
    "v 4 z 9\n{ -40 -40 40 -40 40 40 -40 40 }\n";

std::vector<std::string> void_lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    for (const char* word : {"open ", "close ", "hole "}) {
      if (line.starts_with(word)) lines.push_back(line.substr(0, line.find("  #")));
    }
  }
  return lines;
}

class VoidLinksOnTheCommandLine : public testing::Test {
 protected:
  VoidLinksOnTheCommandLine() { test::put(in_, kHoles); }

  [[nodiscard]] double cavities(std::vector<std::string> extra) const {
    extra.insert(extra.begin(), {"links", in_});
    return run_json(extra).at("voids").at("cavities").number;
  }
  [[nodiscard]] double cavities_by(const std::string& labels) const {
    test::put(labels_, labels);
    return cavities({"--labels", labels_});
  }

  TempFolder folder_;
  std::string in_ = folder_.file("a.cnt");
  std::string model_ = folder_.file("m.vtu");
  std::string labels_ = folder_.file("l.labels");
};

TEST_F(VoidLinksOnTheCommandLine, AreListedBehindThoseOfRegions) {
  const Outcome told = run({"links", in_, "--voids", "near=2"});
  EXPECT_EQ(told.code, 0) << told.err;
  // Near: the first pair overlaps; of the other hole both the solid end below and the hole across
  // are too far, the hole across is nearer.
  EXPECT_EQ(void_lines_in(told.out), (std::vector<std::string>{"open 1 1 1"})) << told.out;
  EXPECT_NE(told.out.find("open 1 1 1  # overlap: ratio 0.0625, moved 0.0625, distance 0, margin "
                          "0.0425\n"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("# 2 cavities, links of voids: 1 made (1 by overlap); 0 nearly\n"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("# S 1: 1 made (1 by overlap); 0 nearly\n"), std::string::npos);
  EXPECT_GT(told.out.find("open 1 1 1"), told.out.rfind("join "));
  const Outcome far = run({"links", in_, "--voids=near=4", "--quiet"});
  EXPECT_EQ(void_lines_in(far.out), (std::vector<std::string>{"open 1 1 1", "open 1 2 1"}));
  EXPECT_NE(far.out.find("open 1 2 1  # rim: "), std::string::npos) << far.out;
  EXPECT_EQ(run({"links", in_, "--threads", "3"}).out, run({"links", in_}).out);
}

TEST_F(VoidLinksOnTheCommandLine, AreNotMentionedWhereThereAreNone) {
  for (const std::string& text : {run({"links", in_, "--voids", "free"}).out, [] {
                                    TempFolder folder;
                                    test::put(folder.file("t.cnt"), test::kTube);
                                    return run({"links", folder.file("t.cnt")}).out;
                                  }()}) {
    EXPECT_NE(text.find("join 0 0 0"), std::string::npos);
    EXPECT_EQ(text.find("void"), std::string::npos) << text;
  }
}

TEST_F(VoidLinksOnTheCommandLine, AreTakenBackUnchanged) {
  for (const std::string name :
       {"", "cases/voids/hole_at_border.cnt", "cases/nested_hole.cnt",
        "cases/voids/oblique_tunnel.cnt", "tooth.cnt", "cases/voids/rings_unlinked.cnt"}) {
    const std::string stack = name.empty() ? in_ : std::string(TETLOFT_DATA_DIR) + '/' + name;
    for (const char* rule : {"overlap", "near=1.5"}) {
      SCOPED_TRACE(stack + ' ' + rule);
      const JsonValue before = run_json({"links", stack, "--voids", rule});
      ASSERT_EQ(run({"links", stack, "--voids", rule, "-o", labels_}).code, 0);
      auto lines = void_lines_in(test::get(labels_));
      ASSERT_FALSE(lines.empty());
      const Outcome again = run({"links", stack, "--voids", rule, "--labels", labels_});
      ASSERT_EQ(again.code, 0) << again.err;
      auto decided = void_lines_in(again.out);
      std::sort(lines.begin(), lines.end());
      std::sort(decided.begin(), decided.end());
      EXPECT_EQ(decided, lines);
      const JsonValue after = run_json({"links", stack, "--voids", rule, "--labels", labels_});
      EXPECT_EQ(after.at("voids").at("cavities").number, before.at("voids").at("cavities").number);
      for (const JsonValue& link : after.at("voids").at("links").array) {
        EXPECT_TRUE(!link.at("made").boolean || link.at("evidence").string == "decision");
      }
    }
  }
}

TEST_F(VoidLinksOnTheCommandLine, AreOverruledLineByLine) {
  EXPECT_EQ(cavities({}), 2);
  EXPECT_EQ(cavities_by("close 1 1 1\n"), 3);
  EXPECT_EQ(cavities_by("open 1 2 1 # a link that nothing suggests\n"), 1);
  EXPECT_EQ(cavities_by("open 0 outside 2\n"), 1);
  EXPECT_EQ(cavities_by("open 1 2 outside\nopen 2 1 outside\n"), 0);
  EXPECT_EQ(cavities_by("hole 1 2 7\nhole 2 1 7\n"), 1);
  EXPECT_EQ(cavities_by("hole 1 1 7\nhole 2 1 8\n"), 3);
}

TEST_F(VoidLinksOnTheCommandLine, KeepWhatTheUserDecided) {
  test::put(labels_, "hole 1 2 7 # mine\nclose 1 1 1\n");
  const std::string next = folder_.file("next.labels");
  ASSERT_EQ(run({"links", in_, "--labels", labels_, "--first", "1", "-o", next}).code, 0);
  EXPECT_EQ(void_lines_in(test::get(next)),
            (std::vector<std::string>{"hole 1 2 7", "close 1 1 1"}));
  test::put(labels_, test::get(next));
  EXPECT_EQ(cavities({"--labels", labels_}), 3);
}

TEST_F(VoidLinksOnTheCommandLine, AreToldInJson) {
  test::put(labels_, "open 0 outside 2\nclose 1 1 1\n");
  const JsonValue json = run_json({"links", in_, "--labels", labels_});
  const JsonValue& voids = json.at("voids");
  EXPECT_EQ(voids.at("cavities").number, 2);
  EXPECT_EQ(voids.at("made").at("decision").number, 1);
  EXPECT_EQ(voids.at("not_made").at("parted_by_decision").number, 1);
  const auto& links = voids.at("links").array;
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].at("slab").number, 0);
  EXPECT_EQ(links[0].at("lower").string, "outside");
  EXPECT_EQ(links[0].at("upper").number, 2);
  EXPECT_EQ(links[0].at("evidence").string, "decision");
  EXPECT_EQ(links[1].at("lower").number, 1);
  EXPECT_EQ(links[1].at("ratio").number, 0.0625);
  EXPECT_EQ(links[1].at("fate").string, "parted_by_decision");
  EXPECT_EQ(voids.at("least_sure").array.size(), 2U);
  const JsonValue first = run_json({"links", in_, "--labels", labels_, "--first", "1"});
  EXPECT_EQ(first.at("voids").at("least_sure").array.size(), 1U);
}

TEST_F(VoidLinksOnTheCommandLine, AreDataOfTheModel) {
  const Outcome made = run({"reconstruct", in_, "-o", model_});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("links of voids: 1 made (1 by overlap); 0 nearly; the least sure: open 1 "
                          "1 1 (overlap: "),
            std::string::npos)
      << made.out;
  const auto model = read_vtu(model_);
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->void_links.size(), 1U);
  EXPECT_EQ(model->void_links[0].lower, ContourId(1));
  const JsonValue json = run_json({"reconstruct", in_, "-o", model_}).at("void_links");
  EXPECT_EQ(json.at("made").at("overlap").number, 1);
  EXPECT_EQ(json.at("least_sure").array.size(), 1U);
  ASSERT_EQ(run({"reconstruct", in_, "-o", model_, "--voids", "free"}).code, 0);
  EXPECT_TRUE(read_vtu(model_)->void_links.empty());
}

TEST_F(VoidLinksOnTheCommandLine, RefuseOptionsThatMakeNoSense) {
  for (const char* command : {"links", "reconstruct", "check"}) {
    const auto refused = [&](const std::string& value, const std::string& word) {
      std::vector<std::string> words{command, in_};
      if (command == std::string("reconstruct")) words.insert(words.end(), {"-o", model_});
      if (command == std::string("check")) words.push_back(in_);
      words.insert(words.end(), {"--voids", value});
      expect_failure(words, 2, "usage", word);
    };
    refused("nearest", "'nearest' is not overlap, near or free");
    refused("overlop", "did you mean overlap?");
    refused("overlap=0.1", "overlap takes no reach");
    refused("near=", "--voids");
    refused("near=-1", "'-1' is below 0");
    refused("near=inf", "--voids");
    refused("near=1x", "--voids");
  }
  expect_failure({"reconstruct", in_, "-o", model_, "--method", "geiger", "--voids", "near"}, 2,
                 "usage", "--voids has no meaning");
}

TEST_F(VoidLinksOnTheCommandLine, RefuseLinesThatNameNoHole) {
  const auto expect = [&](const std::string& text, const std::string& word) {
    test::put(labels_, text);
    for (const char* command : {"reconstruct", "links"}) {
      const std::string out = folder_.file(command == std::string("links") ? "o.txt" : "o.vtu");
      expect_failure({command, in_, "-o", out, "--labels", labels_}, 3, "invalid_input", word,
                     {out});
    }
  };
  expect("hole 1 0 7\n", labels_ + ": section 1, contour 0: the label names a contour that is no");
  expect("hole 1 3 7\n", labels_ + ": section 1, contour 3: the label names a contour that the");
  expect("hole 9 0 7\n", labels_ + ": section 9, contour 0: the label names a contour that the");
  expect("open 1 0 1\n", labels_ + ": section 1, contour 0: open names a contour that is no hole");
  expect("close 1 1 0\n", labels_ + ": section 2, contour 0: close names a contour that is no");
  expect("close 1 outside 2\n", labels_ + ": section 2, contour 2: close names a contour that the");
  expect("open 3 outside 0\n", "open names the last section");
  expect("open 0 outside outside\n", labels_ + ":1: the outside is the same");
  expect("open 1 1 1\nclose 1 1 1\n", labels_ + ":2: open and close of the same contours");
  expect("hole 1 1 7\nhole 1 1 8\n", "two labels");
  expect("hole 1 1 7\nhole 2 1 8\nopen 1 1 1\n", "labels, 7 and 8, part them");
  test::put(labels_, "open 1 1 1\n");
  expect_failure({"links", in_, "--labels", labels_, "--voids", "free"}, 3, "invalid_input",
                 "--voids free");
}

}  // namespace
}  // namespace tetloft
