// Help, version, and command lines that make no sense.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include <tetloft/version.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::Outcome;
using test::run;
using test::TempFolder;

TEST(Help, IsPrintedByEveryCommand) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                {"reconstruct", "--help"},
                                                {"check", "--help"},
                                                {"links", "--help"},
                                                {"between", "--help"},
                                                {"delaunay", "--help"},
                                                {"info", "--help"},
                                                {"plan", "--help"},
                                                {"join", "--help"},
                                                {"reconstruct", "x.cnt", "--help"}}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 0) << words.back();
    EXPECT_NE(outcome.out.find("usage: tetloft"), std::string::npos);
    EXPECT_TRUE(outcome.err.empty()) << outcome.err;
  }
}

TEST(Help, NamesEveryOption) {
  const std::string help = run({"reconstruct", "--help"}).out;
  for (const char* option :
       {"-o",        "--surface",         "--correspondence", "--overlap", "--no-chain",
        "--no-lone", "--voids",           "--labels",         "--ends",    "--thickness",
        "--repair",  "--repair-distance", "--snap",           "--threads", "--verify",
        "--plan",    "--slabs",           "--ascii",          "--json",    "--quiet",
        "--help"}) {
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
  const std::string general = run({"--help"}).out;
  for (const char* command :
       {"reconstruct", "check", "links", "between", "delaunay", "info", "plan", "join"}) {
    EXPECT_NE(general.find(command), std::string::npos) << command;
  }
}

TEST(Version, IsTheLibrarys) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, std::string("tetloft ") + version() + '\n');
}

TEST(Usage, NeedsACommand) {
  expect_failure({}, 2, "usage", "command");
  expect_failure({"frobnicate"}, 2, "usage", "'frobnicate'");
  expect_failure({"--frobnicate"}, 2, "usage", "--frobnicate");
}

TEST(Usage, ShowsTheHelpWhereNothingIsAsked) {
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("usage: tetloft COMMAND"), std::string::npos);
  EXPECT_TRUE(outcome.out.empty());
}

TEST(Help, OfACommandByItsName) {
  for (const char* command : {"reconstruct", "check", "links", "between", "delaunay", "skeleton",
                              "render", "info", "plan", "join"}) {
    const std::string help = run({command, "--help"}).out;
    EXPECT_EQ(run({"help", command}).out, help);
    EXPECT_EQ(run({command, "-h"}).out, help);
  }
  expect_failure({"help", "rendr"}, 2, "usage", "did you mean render?");
}

TEST(Usage, SuggestsWhatWasMeant) {
  expect_failure({"recnstruct"}, 2, "usage", "did you mean reconstruct?");
  expect_failure({"version"}, 2, "usage", "did you mean --version?");
  expect_failure({"a.cnt"}, 2, "usage", "tetloft reconstruct IN -o OUT)");
  expect_failure({"reconstruct", "a.cnt", "--srface", "a.ply"}, 2, "usage",
                 "did you mean --surface?");
  expect_failure({"reconstruct", "a.cnt", "a.vtu"}, 2, "usage", "an output needs -o");
  const std::vector<std::pair<std::vector<std::string>, std::string>> values{
      {{"reconstruct", "a.cnt", "-o", "a.vtu", "--ends", "flatt"}, "flat"},
      {{"reconstruct", "a.cnt", "-o", "a.vtu", "--method", "gieger"}, "geiger"},
      {{"reconstruct", "a.cnt", "-o", "a.vtu", "--correspondence", "rev"}, "reverse"},
      {{"reconstruct", "a.cnt", "-o", "a.vtu", "--delaunay", "incrementl"}, "incremental"},
      {{"delaunay", "a.txt", "--engine", "Slab"}, "slab"},
      {{"skeleton", "a.cnt", "-o", "a.vtp", "--kind", "internl"}, "internal"},
      {{"render", "a.vtu", "-o", "a.png", "--colour", "dihedrl"}, "dihedral"}};
  for (const auto& [words, meant] : values) {
    expect_failure(words, 2, "usage", "did you mean " + meant + '?');
  }
}

TEST(Usage, NeedsOperands) {
  expect_failure({"reconstruct"}, 2, "usage", "missing IN");
  expect_failure({"check"}, 2, "usage", "missing MODEL");
  expect_failure({"check", "a.vtu"}, 2, "usage", "missing IN");
  expect_failure({"delaunay"}, 2, "usage", "POINTS");
  expect_failure({"info"}, 2, "usage", "missing IN");
  expect_failure({"plan"}, 2, "usage", "missing STACK");
  expect_failure({"join"}, 2, "usage", "missing PIECE");
  expect_failure({"info", "a.cnt", "b.cnt"}, 2, "usage", "'b.cnt'");
  // Behind "--" nothing is an option.
  const Outcome outcome = run({"info", "--", "a.cnt", "--json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.out.empty());
}

// Found before any file is looked at: these inputs do not exist.
TEST(Usage, NamesTheOptionThatIsWrong) {
  TempFolder folder;
  const std::string out = folder.file("o.vtu");
  const auto expect = [&](const std::vector<std::string>& extra, const std::string& word) {
    std::vector<std::string> words{"reconstruct", "none.cnt", "-o", out};
    words.insert(words.end(), extra.begin(), extra.end());
    expect_failure(words, 2, "usage", word, {out});
  };
  expect({"--frobnicate"}, "--frobnicate");
  expect({"-x"}, "-x");
  expect({"--overlap"}, "--overlap");
  expect({"--overlap", "--quiet"}, "--overlap");
  for (const char* tau : {"1", "-0.1", "x", "nan", "", "0.5x"}) {
    expect({"--overlap=" + std::string(tau)}, "--overlap");
  }
  for (const char* bits : {"0", "51", "-3", "2.5", "x", ""}) {
    expect({"--snap=" + std::string(bits)}, "--snap");
  }
  for (const char* thickness : {"0", "-1", "inf", "x", "1e-400"}) {
    expect({"--thickness", thickness}, "--thickness");
  }
  for (const char* threads : {"-1", "1025", "x", "1.5", "99999999999999999999"}) {
    expect({"--threads", threads}, "--threads");
  }
  expect({"--ends", "round"}, "--ends");
  expect({"--correspondence", "psychic"}, "--correspondence");
  expect({"--drift", "0.3"}, "no option --drift any more");
  expect_failure({"check", "none.vtu", "none.cnt", "--drift=1"}, 2, "usage", "--no-chain");
  expect({"--no-chain=1"}, "takes no value");
  expect({"--verify=yes"}, "--verify");
  expect({"--ascii", "--ascii"}, "--ascii");
  expect({"--surface", folder.file("s.vtk")}, "--surface");
  expect({"--surface", folder.file("s")}, "--surface");
  expect({"--output", out}, "twice");
}

TEST(Usage, ReconstructNeedsAnOutputOfItsOwn) {
  TempFolder folder;
  const std::string in = folder.file("a.cnt");
  test::put(in, test::kTube);
  test::put(folder.file("l.vtu"), "0 0 1\n");
  expect_failure({"reconstruct", in}, 2, "usage", "-o");
  expect_failure({"reconstruct", in, "-o", folder.file("o.doc")}, 2, "usage", ".vtu");
  expect_failure({"reconstruct", in, "-o", in}, 2, "usage", ".vtu");
  std::filesystem::create_symlink(in, folder.file("link.vtu"));
  expect_failure({"reconstruct", in, "-o", folder.file("link.vtu")}, 2, "usage", "overwrite");
  expect_failure(
      {"reconstruct", in, "-o", folder.file("./x/../l.vtu"), "--labels", folder.file("l.vtu")}, 2,
      "usage", "overwrite");
  EXPECT_EQ(test::get(in), test::kTube);
  const std::string out = folder.file("o.vtu");
  test::put(out, "old");
  std::filesystem::create_symlink(out, folder.file("s.ply"));
  expect_failure({"reconstruct", in, "-o", out, "--surface", folder.file("s.ply")}, 2, "usage",
                 "overwrite");
  EXPECT_EQ(test::get(out), "old");
}

TEST(Usage, TakesValuesAfterAnEqualsSign) {
  TempFolder folder;
  test::put(folder.file("a.cnt"), test::kTube);
  const Outcome outcome = run({"reconstruct", "--output=" + folder.file("o.VTU"), "--overlap=0.1",
                               "--", folder.file("a.cnt")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder.file("o.VTU")));
}

TEST(Output, ThatReachesNobodyIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  TempFolder folder;
  test::put(folder.file("a.cnt"), test::kTube);
  const Outcome outcome = test::run_into("/dev/full", {"info", folder.file("a.cnt")});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_FALSE(outcome.err.empty());
}

}  // namespace
}  // namespace tetloft
