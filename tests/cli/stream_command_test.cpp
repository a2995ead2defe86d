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
