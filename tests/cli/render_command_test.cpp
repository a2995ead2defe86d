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

// Nothing but points and a tet.
const std::string kOneTet =
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
    "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
    "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray>"
    "</Cells></Piece></UnstructuredGrid></VTKFile>\n";

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

TEST_F(RenderCommand, APageIsCutAcrossAnyAxis) {
  const std::string page = drawn("a.html");
  for (const char* cut : {"x=1", "y=0", "z=0.5"}) {
    EXPECT_NE(drawn("b.html", {"--cut", cut}), page) << cut;
  }
}

TEST_F(RenderCommand, SeveralModelsAreOnePageUnderTheirNames) {
  const std::string other = folder_.file("a < b.vtu"), page = folder_.file("both.html");
  ASSERT_EQ(run({"reconstruct", in_, "--ends", "flat", "-o", other}).code, 0);
  const std::string stack = folder_.file("in.cnt");
  const test::Outcome outcome =
      run({"render", model_, other, "--contours", stack, "-o", page, "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string text = test::get(page);
  EXPECT_NE(text.find("<title>fork, a &lt; b</title>"), std::string::npos);
  EXPECT_NE(text.find("\"name\":\"fork\""), std::string::npos);
  EXPECT_NE(text.find("\"name\":\"a \\u003c b\""), std::string::npos);
  EXPECT_NE(text.find("id=\"array-1-points\""), std::string::npos);
  EXPECT_EQ(text.find("id=\"array-2-points\""), std::string::npos);
}

// The first tells no unit.
TEST_F(RenderCommand, SeveralModelsOfDifferentUnitsAreToldOf) {
  std::vector<std::string> models{model_};
  for (const std::string unit : {"mm", "cm", "mm"}) {
    models.push_back(folder_.file(unit + std::to_string(models.size()) + ".msh"));
    ASSERT_EQ(run({"convert", model_, models.back(), "--ascii"}).code, 0);
    test::put(models.back(),
              "$Comments\n# unit: " + unit + "\n$EndComments\n" + test::get(models.back()));
  }
  std::vector<std::string> words{"render", "-o", folder_.file("all.html")};
  words.insert(words.end(), models.begin(), models.end());
  const auto told = run_json(words);
  ASSERT_EQ(told.at("warnings").array.size(), 1U);
  const std::string message = told.at("warnings").array[0].at("message").string;
  EXPECT_NE(message.find("'mm' of '" + models[1] + "', 'cm' of '" + models[2]), std::string::npos)
      << message;
}

TEST_F(RenderCommand, SeveralModelsThatCannotBeShownLeaveNoPage) {
  const std::string page = folder_.file("both.html"), picture = folder_.file("both.png");
  expect_failure({"render", model_, model_, "-o", picture}, 2, "usage", "several models",
                 {picture});
  expect_failure({"render", model_, folder_.file("none.vtu"), "-o", page}, 4, "io", "none.vtu",
                 {page});
  expect_failure({"render", model_, in_, "-o", page}, 3, "invalid_input", "in.cnt", {page});
  const std::string taken = folder_.file("taken.html");
  test::put(taken, test::get(model_));
  expect_failure({"render", model_, taken, "-o", taken}, 2, "usage", "taken.html");
  EXPECT_EQ(test::get(taken), test::get(model_));
  // Of a model that does not tell what its colours are asked to.
  const std::string bare = folder_.file("bare.vtu");
  test::put(bare, kOneTet);
  expect_failure({"render", model_, bare, "--colour", "kind", "-o", page}, 2, "usage", "bare",
                 {page});
}

TEST_F(RenderCommand, RefusesWrongUse) {
  const std::string out = folder_.file("out.png");
  expect_failure({"render", model_}, 2, "usage", "--output");
  expect_failure({"render", model_, "-o", folder_.file("a.gif")}, 2, "usage", ".html");
  expect_failure({"render", folder_.file("none.vtu"), "-o", out}, 4, "io", "none.vtu", {out});
  expect_failure({"render", in_, "-o", out}, 3, "invalid_input", "in.cnt", {out});
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
