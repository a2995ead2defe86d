// tetloft render.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

class RenderCommand : public ::testing::Test {
 protected:
  RenderCommand() {
    test::put(in_, test::kFork);
    EXPECT_EQ(run({"reconstruct", in_, "-o", model_}).code, 0);
  }
  // Draws with these options; the bytes.
  std::string drawn(const std::string& name, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{"render", model_, "-o", folder_.file(name), "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    const test::Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return test::get(folder_.file(name));
  }
  TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string model_ = folder_.file("fork.vtu");
};

TEST_F(RenderCommand, WritesThePictureThatTheExtensionAsksFor) {
  EXPECT_EQ(drawn("a.png").substr(1, 3), "PNG");
  EXPECT_EQ(drawn("a.svg").substr(0, 4), "<svg");
  const std::string page = drawn("a.html");
  EXPECT_EQ(page.substr(0, 15), "<!doctype html>");
  EXPECT_NE(page.find("<title>fork</title>"), std::string::npos);
  const JsonValue json = run_json({"render", model_, "-o", folder_.file("b.html")});
  EXPECT_EQ(json.at("bytes").number, static_cast<double>(page.size()));
  EXPECT_EQ(test::get(folder_.file("b.html")), page);
}

TEST_F(RenderCommand, EveryOptionChangesThePicture) {
  const std::vector<std::string> size{"--size", "120x90"};
  const std::string plain = drawn("a.png", size);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--no-contours"},
           {"--contours", folder_.file("in.cnt"), "--view", "0,10"},
           {"--colour", "slab"},
           {"--colour", "kind"},
           {"--colour", "dihedral"},
           {"--colour", "evidence"},
           {"--view", "10,80"},
           {"--cut", "z=0.5"},
           {"--cut", "x=0"},
           {"--stretch", "2"},
           {"--edges"},
           {"--white"}}) {
    std::vector<std::string> all = size;
    all.insert(all.end(), option.begin(), option.end());
    EXPECT_NE(drawn("b.png", all), plain) << option.front();
  }
  EXPECT_NE(drawn("b.png", {"--size", "100x90"}), plain);
  EXPECT_NE(drawn("a.html", {"--title", "x"}), drawn("b.html", {"--title", "y"}));
}

TEST_F(RenderCommand, RefusesWrongUse) {
  const std::string out = folder_.file("out.png");
  expect_failure({"render", model_}, 2, "usage", "--output");
  expect_failure({"render", model_, "-o", folder_.file("a.gif")}, 2, "usage", ".html");
  expect_failure({"render", folder_.file("none.vtu"), "-o", out}, 4, "io", "none.vtu", {out});
  expect_failure({"render", in_, "-o", out}, 3, "invalid_input", "in.cnt", {out});
  expect_failure({"render", model_, "-o", folder_.file("a.html"), "--cut", "x=1"}, 2, "usage",
                 "z only", {folder_.file("a.html")});
  for (const auto& [option, value] :
       {std::pair{"--colour", "weight"}, std::pair{"--view", "10"}, std::pair{"--view", "10,95"},
        std::pair{"--cut", "w=1"}, std::pair{"--cut", "z"}, std::pair{"--size", "0x10"},
        std::pair{"--size", "10"}, std::pair{"--size", "10.5x10"}, std::pair{"--explode", "-1"},
        std::pair{"--stretch", "0"}, std::pair{"--stretch", "much"}}) {
    expect_failure({"render", model_, "-o", out, option, value}, 2, "usage", "", {out});
  }
}

}  // namespace
}  // namespace tetloft
