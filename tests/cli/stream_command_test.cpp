// tetloft reconstruct --stream: the file and the report of the plain run.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/pieces_fixture.hpp"

namespace tetloft {
namespace {

using test::data;
using test::expect_failure;
using test::JsonValue;
using test::run_json;
using test::TempFolder;
using test::with;
using test::Words;

TEST(StreamCommand, WritesTheFileOfThePlainRun) {
  const TempFolder folder;
  const std::string plain = folder.file("plain.vtu");
  const std::string streamed = folder.file("streamed.vtu");
  for (const Words& how :
       std::vector<Words>{{data("torus.cnt")},
                          {data("torus.cnt"), "--ends", "half", "--ascii", "--threads", "3"},
                          {data("bifurcation.cnt"), "--between", "2", "--compress"},
                          {data("figures/fig17_branches.cnt"), "--voids", "free"}}) {
    const Words words = with({"reconstruct"}, how);
    const JsonValue whole = run_json(with(words, {"-o", plain}));
    const JsonValue told = run_json(with(words, {"-o", streamed, "--stream"}));
    EXPECT_TRUE(test::get(plain) == test::get(streamed)) << how[0];
    for (const char* const member :
         {"slices", "sections_between", "contours", "input_vertices", "split_vertices", "vertices",
          "tets", "components", "volume"}) {
      EXPECT_EQ(told.at(member).number, whole.at(member).number) << member;
    }
  }
}

// Sections that are read one after the other are warned of, and refused, in the words of those that
// are read as a whole.
TEST(StreamCommand, TellsWhatThePlainRunTells) {
  const TempFolder folder;
  const std::string square = "{0 0 4 0 4 4 0 4}";
  const std::string arc = "{0 0 1 1 2 1.5 3 1.7 4 1.7 5 1.5 6 1 7 .05}";
  const std::string files[] = {
      "S 7\nv 9 z 0\n{0 0 4 0 4 4 0 4 0 0}\nv 4 z 5\n" + square,                  // slips
      "S 4\nv 4 z 0" + square + "v 4 z 10" + square + "v 4 z 10.001" + square +   // two planes of
          "v 4 z 20" + square,                                                    // one slice
      "S 2\nv 8 z 0\n" + arc + "\nv 8 z 1\n" + arc,                               // open lines
      "S 1\nv 4 z 0\n{0 0 0 4 0 0 4 4 0 0 4 0}",                                  // triples
      "S 1\nv 4 z 0" + square,                                                    // flat
      "S 2\nv 4 z 5\n" + square + "\nv 4 z 0\n" + square,                         // descending
      "S 3\nv 4 z 0\n" + square + "\nv 4 z 0\n" + square + "\nv 4 z 1" + square,  // the same
      "S 2\nv 4 z 0\n" + square + "\nv 4 z 1\n{0 0 4 4 4 0 0 4}",                 // crossing
      "S 1\nv 9 z 0\n{0 0 1 0 2 0 3 0 2 0.5 3 0.5 9 9 0 1 9 8 1 1}",              // an open one
      "S 1\nv 4 z 0\n{0 0 4 0 4 x 0 4}",
      "S 2\nv 0 z 0\nv 0 z 1",
      "S 0\n",
      ""};
  const std::string path = folder.file("stack.cnt");
  const std::string plain = folder.file("plain.vtu");
  const std::string streamed = folder.file("streamed.vtu");
  int made = 0;
  int refused = 0;
  for (const std::string& text : files) {
    SCOPED_TRACE(text);
    test::put(path, text);
    for (const Words& how : {Words{}, Words{"--json"}, Words{"--thickness", "2", "--quiet"}}) {
      const Words words = with({"reconstruct", path}, how);
      const test::Outcome whole = test::run(with(words, {"-o", plain}));
      const test::Outcome told = test::run(with(words, {"-o", streamed, "--stream"}));
      const test::Outcome planned = test::run({"plan", path, "-o", folder.file("plan"), "--quiet"});
      EXPECT_EQ(told.code, whole.code);
      EXPECT_EQ(told.err, whole.err);
      if (whole.code != 0) {
        EXPECT_EQ(told.out, whole.out);
        EXPECT_EQ(planned.code, whole.code);
        EXPECT_EQ(planned.err, whole.err);
        ++refused;
        continue;
      }
      EXPECT_TRUE(test::get(plain) == test::get(streamed));
      ++made;
    }
  }
  EXPECT_EQ(made, 15);
  EXPECT_EQ(refused, 24);
}

TEST(StreamCommand, RefusesWhatTakesAllOfTheSolid) {
  const TempFolder folder;
  const std::string solid = folder.file("solid.vtu");
  const Words words{"reconstruct", data("torus.cnt"), "--stream"};
  expect_failure(with(words, {"-o", solid, "--verify"}), 2, "usage", "--verify", {solid});
  expect_failure(with(words, {"-o", folder.file("solid.msh")}), 2, "usage", ".vtu", {solid});
  expect_failure(with(words, {"-o", solid, "--surface", folder.file("s.ply")}), 2, "usage",
                 "--surface", {solid});
  expect_failure(with(words, {"-o", solid, "--method", "geiger"}), 2, "usage", "geiger", {solid});
}

}  // namespace
}  // namespace tetloft
