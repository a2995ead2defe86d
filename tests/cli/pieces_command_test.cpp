// tetloft plan, reconstruct --plan --slabs, join: the solid of the single run, byte for byte.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/pieces_fixture.hpp"

namespace tetloft {
namespace {

using test::Cuts;
using test::data;
using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::with;
using test::Words;

class PiecesCommand : public test::PiecesCommand {};
class OpenSlabs : public test::OpenSlabs {};

TEST_F(PiecesCommand, JoinedAreTheFileOfTheSingleRun) {
  make_plan(data("torus.cnt"));
  for (const Cuts& cuts : {Cuts{0, 19}, Cuts{0, 1, 19}, Cuts{0, 18, 19}, Cuts{0, 4, 9, 13, 19}}) {
    expect_joined(cuts, "vtu");
  }
  make_plan(data("bifurcation.cnt"), {"--between", "2", "--ends", "half"});
  const std::size_t slabs = read_stack(stack_)->stack.sections.size() - 1;
  expect_joined({0, slabs / 2, slabs}, "vtu");
  make_plan(data("figures/fig17_branches.cnt"), {"--between", "none", "--voids", "free"});
  expect_joined({0, 1, read_stack(stack_)->stack.sections.size() - 1}, "vtu");
}

TEST_F(PiecesCommand, AreWrittenInAnyWayAndJoinedInAnyOther) {
  const std::string labels = folder_.file("torus.labels");
  test::put(labels, "3 0 5\n9 0 6\npart 12 0 0\n");
  make_plan(data("torus.cnt"), {"--labels", labels});
  const Cuts cuts{0, 7, 12, 19};
  expect_joined(cuts, "vtu", {"--ascii"}, {"--compress"});
  expect_joined(cuts, "vtu", {"--compress"}, {"--ascii", "--threads", "2"});
  expect_joined(cuts, "msh");
  make_pieces(cuts);
  const std::string surface = folder_.file("surface.ply");
  ASSERT_EQ(run({"join", piece(0), piece(1), piece(2), "--surface", surface}).code, 0);
  const std::string other = folder_.file("other.ply");
  ASSERT_EQ(run({"reconstruct", stack_, "--labels", labels, "--surface", other}).code, 0);
  EXPECT_EQ(test::get(surface), test::get(other));
}

TEST_F(PiecesCommand, ASingleSectionIsAPiece) {
  test::put(folder_.file("one.cnt"), "S 1\nv 4 z 5\n{ 0 0 2 0 2 2 0 2 }\n");
  make_plan(folder_.file("one.cnt"), {"--thickness", "0.5"});
  expect_joined({0, 0}, "vtu");
}

TEST_F(PiecesCommand, APieceThatIsBuiltTwiceHasTheSameBytes) {
  make_plan(data("torus.cnt"));
  make_pieces({0, 7, 19});
  const std::string first = test::get(piece(1));
  make_pieces({0, 7, 19}, {"--threads", "2"});
  EXPECT_TRUE(test::get(piece(1)) == first);
  const std::string plan = test::get(plan_);
  make_plan(data("torus.cnt"), {"--threads", "2"});
  EXPECT_TRUE(test::get(plan_) == plan);
}

// Decisions, though there are none, are about the whole.
TEST_F(PiecesCommand, PlansOfSectionsReadOneByOneAreThoseOfTheWhole) {
  test::put(folder_.file("none.labels"), "");
  for (const char* name : {"torus.cnt", "bifurcation.cnt", "figures/fig17_branches.cnt"}) {
    make_plan(data(name));
    const std::string plan = test::get(plan_);
    make_plan(data(name), {"--labels", folder_.file("none.labels")});
    EXPECT_TRUE(test::get(plan_) == plan) << name;
  }
}

TEST_F(PiecesCommand, TellWhatTheyAre) {
  const JsonValue plan = run_json({"plan", data("torus.cnt"), "-o", plan_});
  EXPECT_EQ(plan.at("sections").number, 20);
  EXPECT_EQ(plan.at("slabs").number, 19);
  EXPECT_EQ(plan.at("components").number, 1);
  EXPECT_EQ(plan.at("identity").string.size(), 16U);
  EXPECT_EQ(plan.at("written").string, plan_);
  const std::string told = run({"plan", data("torus.cnt"), "-o", plan_}).out;
  EXPECT_NE(told.find("20 sections, slabs 0:19, 1 component"), std::string::npos) << told;
  const JsonValue low = run_json(
      {"reconstruct", data("torus.cnt"), "--plan", plan_, "--slabs", "0:7", "-o", piece(0)});
  EXPECT_EQ(low.at("slabs").array[1].number, 7);
  EXPECT_EQ(low.at("of").number, 19);
  EXPECT_TRUE(low.at("open").array.empty());
  EXPECT_GT(low.at("tets").number, 0);
  const Outcome high =
      run({"reconstruct", data("torus.cnt"), "--plan", plan_, "--slabs=7:19", "-o", piece(1)});
  EXPECT_NE(high.out.find("slabs 7:19 of 19: "), std::string::npos) << high.out;
  const std::string out = folder_.file("out.vtu");
  const JsonValue joined = run_json({"join", piece(1), piece(0), "-o", out});
  EXPECT_EQ(joined.at("pieces").number, 2);
  EXPECT_EQ(joined.at("settled").number, 0);
  EXPECT_EQ(joined.at("slices").number, 20);
  EXPECT_EQ(joined.at("written").array.front().string, out);
  const Outcome again = run({"join", piece(1), piece(0), "-o", out});
  EXPECT_NE(again.out.find("2 pieces: "), std::string::npos) << again.out;
  EXPECT_EQ(run({"check", out, data("torus.cnt")}).code, 0);
}

TEST_F(OpenSlabs, AreBuiltFromThePlan) {
  for (const Cuts& cuts : {Cuts{0, 9}, Cuts{0, 2, 7, 9}, Cuts{0, 4, 9}, Cuts{0, 4, 5, 9},
                           Cuts{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    expect_joined(cuts, "vtu");
  }
}

TEST_F(OpenSlabs, AreToldAndNeedThePlan) {
  const Words pieces = make_pieces({0, 4, 9});
  const JsonValue high =
      run_json({"reconstruct", stack_, "--plan", plan_, "--slabs", "4:9", "-o", piece(1)});
  ASSERT_EQ(high.at("open").array.size(), 2U);
  EXPECT_EQ(high.at("open").array[0].number, 4);
  const std::string told =
      run({"reconstruct", stack_, "--plan", plan_, "--slabs", "4:9", "-o", piece(1)}).out;
  EXPECT_NE(told.find("2 slabs left open"), std::string::npos) << told;
  const std::string out = folder_.file("out.vtu");
  expect_failure(with({"join", "-o", out}, pieces), 2, "usage", "--plan", {out});
  const std::string other = folder_.file("other.plan");
  ASSERT_EQ(run({"plan", data("torus.cnt"), "-o", other}).code, 0);
  expect_failure(with({"join", "-o", out, "--plan", other}, pieces), 2, "usage", "other.plan",
                 {out});
  EXPECT_EQ(run_json(with({"join", "-o", out, "--plan", plan_}, pieces)).at("settled").number, 3);
  const std::string joined = run(with({"join", "-o", out, "--plan", plan_}, pieces)).out;
  EXPECT_NE(joined.find("3 slabs built from the plan"), std::string::npos) << joined;
}

TEST_F(PiecesCommand, ThatDoNotBelongTogetherAreNamed) {
  make_plan(data("torus.cnt"));
  make_pieces({0, 7, 12, 19});
  const std::string out = folder_.file("out.vtu");
  const auto refused = [&](const Words& pieces, int code, const std::string& name,
                           const std::string& word) {
    test::put(out, "old");
    const std::size_t before = folder_.names().size();
    Words words = with({"join", "-o", out}, pieces);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
    EXPECT_EQ(run_json(words, code).at("error").at("code").string, name);
    EXPECT_EQ(test::get(out), "old");
    EXPECT_EQ(folder_.names().size(), before);
  };
  refused({piece(0), piece(2)}, 3, "invalid_input", "slabs 7:12");
  refused({piece(1), piece(2)}, 3, "invalid_input", "slabs 0:7");
  refused({piece(0), piece(1)}, 3, "invalid_input", "slabs 12:19");
  refused({piece(0), piece(1), piece(1), piece(2)}, 3, "invalid_input", "slabs 7:12 is twice");
  refused({piece(0), folder_.file("none.vtu"), piece(2)}, 4, "io", "none.vtu");
  refused({piece(0), data("torus.cnt"), piece(2)}, 3, "invalid_input", "torus.cnt");

  const std::string foreign = folder_.file("foreign.vtu");
  const std::string other = folder_.file("other.plan");
  ASSERT_EQ(run({"plan", stack_, "-o", other, "--ends", "half"}).code, 0);
  ASSERT_EQ(run({"reconstruct", stack_, "--plan", other, "--slabs", "7:12", "-o", foreign}).code,
            0);
  refused({piece(0), foreign, piece(2)}, 3, "invalid_input", "foreign.vtu");
  const std::string solid = folder_.file("solid.vtu");
  ASSERT_EQ(run({"reconstruct", stack_, "-o", solid}).code, 0);
  refused({piece(0), solid, piece(2)}, 3, "invalid_input", "solid.vtu");

  // Damaged in its solid, where the file is well formed still; cut off.
  const std::string whole = test::get(piece(1));
  const std::string damaged = folder_.file("damaged.vtu");
  std::string bytes = whole;
  bytes[whole.size() / 2] = static_cast<char>(bytes[whole.size() / 2] ^ 1);
  test::put(damaged, bytes);
  refused({piece(0), damaged, piece(2)}, 3, "invalid_input", "damaged.vtu");
  test::put(damaged, whole.substr(0, whole.size() / 2));
  refused({piece(0), damaged, piece(2)}, 3, "invalid_input", "damaged.vtu");
}

// Of a large file samples are compared.
TEST_F(PiecesCommand, AreOfThePlannedStackHoweverLargeItsFile) {
  const std::string large = folder_.file("large.cnt");
  test::put(large, "");
  std::filesystem::resize_file(large, (std::uintmax_t{1} << 26) + 1);
  const auto source = plan_source(large);
  ASSERT_TRUE(source.ok());
  const auto stack = parse_cnt(test::kTube, "tube");
  ASSERT_TRUE(stack.ok() && write_plan(plan_, stack->stack, {}, *source).ok());
  const Words words{"reconstruct", large, "--plan", plan_, "--slabs", "0:1", "-o", piece(0)};
  EXPECT_EQ(run(words).code, 0);
  std::filesystem::remove(piece(0));
  std::fstream(large, std::ios::in | std::ios::out | std::ios::binary).seekp(1 << 26).put('!');
  expect_failure(words, 3, "invalid_input", "not the stack of the plan", {piece(0)});
}

TEST_F(PiecesCommand, AreOfThePlannedStack) {
  test::put(folder_.file("a.cnt"), test::kTube);
  test::put(folder_.file("longer.cnt"), test::kTube + ' ');
  std::string changed = test::kTube;
  changed.replace(changed.find("0 2\n}"), 3, "0 3");
  test::put(folder_.file("changed.cnt"), changed);
  make_plan(folder_.file("a.cnt"));
  const auto refused = [&](const std::string& stack, int code, const std::string& name,
                           const std::string& word) {
    expect_failure({"reconstruct", stack, "--plan", plan_, "--slabs", "0:1", "-o", piece(0)}, code,
                   name, word, {piece(0)});
  };
  refused(folder_.file("longer.cnt"), 3, "invalid_input", "not the stack of the plan");
  refused(folder_.file("changed.cnt"), 3, "invalid_input", "changed.cnt");
  refused(folder_.file("none.cnt"), 4, "io", "none.cnt");
  // The same stack by another name.
  std::filesystem::copy_file(folder_.file("a.cnt"), folder_.file("b.cnt"));
  EXPECT_EQ(
      run({"reconstruct", folder_.file("b.cnt"), "--plan", plan_, "--slabs", "0:1", "-o", piece(0)})
          .code,
      0);
}

TEST_F(PiecesCommand, TakeAPlanThatWasWrittenIntoAPipe) {
  make_plan(data("torus.cnt"));
  const Outcome piped = run({"plan", data("torus.cnt"), "-o", "/dev/stdout", "--quiet"});
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_TRUE(piped.out == test::get(plan_));
}

TEST_F(PiecesCommand, AreMadeWithoutTheStack) {
  test::put(folder_.file("a.cnt"), test::kTube);
  make_plan(folder_.file("a.cnt"));
  const Words words{"--plan", plan_, "--slabs", "0:1", "-o", piece(0)};
  ASSERT_EQ(run(with({"reconstruct", folder_.file("a.cnt")}, words)).code, 0);
  const std::string with_stack = test::get(piece(0));
  std::filesystem::remove(piece(0));
  std::filesystem::remove(folder_.file("a.cnt"));
  const JsonValue told = test::run_json(with({"reconstruct"}, words));
  EXPECT_EQ(told.at("written").string, piece(0));
  EXPECT_TRUE(test::get(piece(0)) == with_stack);
  // Only a plan stands for the stack.
  expect_failure({"reconstruct", "--slabs", "0:1", "-o", piece(0)}, 2, "usage", "missing IN", {});
  expect_failure({"reconstruct", "-o", piece(0)}, 2, "usage", "missing IN", {});
  expect_failure({"reconstruct", "--plan", plan_, "--slabs", "0:1", "-o", plan_ + ".vtu", "a", "b"},
                 2, "usage", "unexpected argument", {plan_ + ".vtu"});
  expect_failure({"reconstruct", "--plan", plan_, "--slabs", "0:1", "-o", plan_}, 2, "usage",
                 ".vtu", {});
}

// A stream is read once: its plan tells no file that pieces could be compared with.
TEST_F(PiecesCommand, AreOfAnyStackWhereThePlannedOneWasAStream) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(write(ends[1], test::kTube.data(), test::kTube.size()),
            static_cast<ssize_t>(test::kTube.size()));
  close(ends[1]);
  make_plan("/dev/fd/" + std::to_string(ends[0]));
  close(ends[0]);
  stack_ = folder_.file("tube.cnt");
  test::put(stack_, test::kTube);
  expect_joined({0, 1}, "vtu");
}

TEST_F(PiecesCommand, RefuseWhatMakesNoSense) {
  make_plan(data("torus.cnt"));
  const auto refused = [&](const Words& more, const std::string& word) {
    expect_failure(with({"reconstruct", stack_}, more), 2, "usage", word, {piece(0)});
  };
  refused({"--plan", plan_, "-o", piece(0)}, "--slabs is missing");
  refused({"--slabs", "0:7", "-o", piece(0)}, "--plan is missing");
  refused({"--plan", plan_, "--slabs", "0:7"}, "--output is missing");
  const Words all{"--plan", plan_, "-o", piece(0)};
  for (const char* slabs : {"0", "7:", ":7", "0:7:9", "-1:7", "a:b", "0:7x", "",
                            "0:99999999999999999999", "0-7", " 0:7"}) {
    refused(with(all, {std::string("--slabs=") + slabs}), "--slabs");
  }
  for (const char* slabs : {"0:0", "7:7", "9:7", "0:20", "19:20", "25:26"}) {
    refused(with(all, {"--slabs", slabs}), "0:19");
  }
  const Words piece_words = with(all, {"--slabs", "0:7"});
  for (const Words& option :
       {Words{"--ends", "half"}, Words{"--labels", "x"}, Words{"--between=2"}, Words{"--verify"},
        Words{"--surface", folder_.file("s.ply")}, Words{"--method", "geiger"}, Words{"--snap=20"},
        Words{"--correspondence", "overlap"}, Words{"--roi", "all"}, Words{"--work-limit", "5"}}) {
    refused(with(piece_words, option), option.front().substr(0, option.front().find('=')));
  }
  refused(with(piece_words, {"--ascii", "--compress"}), "exclude");
  // What is behind -- is no option.
  const Outcome none = run(with(with({"reconstruct"}, piece_words), {"--", "--none.cnt"}));
  EXPECT_EQ(none.code, 4) << none.err;
  EXPECT_NE(none.err.find("--none.cnt: "), std::string::npos) << none.err;
  refused({"--plan", plan_, "--slabs", "0:7", "-o", folder_.file("p.msh")}, ".vtu");
  refused({"--plan", plan_, "--slabs", "0:7", "-o", plan_}, ".vtu");
  expect_failure({"reconstruct", stack_, "--plan", stack_, "--slabs", "0:7", "-o", piece(0)}, 3,
                 "invalid_input", "no plan", {piece(0)});
  expect_failure(
      {"reconstruct", stack_, "--plan", folder_.file("none"), "--slabs", "0:7", "-o", piece(0)}, 4,
      "io", "none", {piece(0)});

  expect_failure({"plan", stack_}, 2, "usage", "PLAN");
  expect_failure({"plan", stack_, "-o", stack_}, 2, "usage", "overwrite");
  const std::string labels = folder_.file("torus.labels");
  test::put(labels, "3 0 5\n");
  expect_failure({"plan", stack_, "--labels", labels, "-o", labels}, 2, "usage", "overwrite");
  EXPECT_EQ(test::get(labels), "3 0 5\n");
  expect_failure({"plan", stack_, "-o", folder_.file("p"), "--roi", "all"}, 2, "usage",
                 "one structure", {folder_.file("p")});
  expect_failure({"plan", folder_.file("none.cnt"), "-o", folder_.file("p")}, 4, "io", "none.cnt",
                 {folder_.file("p")});
  test::put(folder_.file("bowtie.cnt"), test::kBowtie);
  expect_failure({"plan", folder_.file("bowtie.cnt"), "-o", folder_.file("p")}, 3, "invalid_input",
                 "bowtie.cnt:3", {folder_.file("p")});
  make_pieces({0, 19});
  expect_failure({"join"}, 2, "usage", "PIECE");
  expect_failure({"join", piece(0)}, 2, "usage", "-o");
  expect_failure({"join", piece(0), "-o", piece(0)}, 2, "usage", "overwrite");
  expect_failure({"join", piece(0), "-o", folder_.file("o.doc")}, 2, "usage", ".vtu");
  const std::string plan = folder_.file("plan.vtu");
  std::filesystem::copy_file(plan_, plan);
  expect_failure({"join", piece(0), "--plan", plan, "-o", plan}, 2, "usage", "overwrite");
  EXPECT_TRUE(test::get(plan) == test::get(plan_));
}

TEST_F(PiecesCommand, OfDamagedPlansAreNotMade) {
  make_plan(data("torus.cnt"));
  const std::string whole = test::get(plan_);
  std::string bytes = whole;
  bytes[whole.size() / 2] = static_cast<char>(bytes[whole.size() / 2] ^ 1);
  test::put(plan_, bytes);
  expect_failure({"reconstruct", stack_, "--plan", plan_, "--slabs", "0:19", "-o", piece(0)}, 3,
                 "invalid_input", "stack.plan", {piece(0)});
  test::put(plan_, whole.substr(0, whole.size() - 1));
  expect_failure({"reconstruct", stack_, "--plan", plan_, "--slabs", "0:19", "-o", piece(0)}, 3,
                 "invalid_input", "stack.plan", {piece(0)});
}

}  // namespace
}  // namespace tetloft
