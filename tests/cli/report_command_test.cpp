// tetloft report.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/runner.hpp"
#include "unit/report/markup_reader.hpp"

namespace tetloft {
namespace {

using test::Element;
using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

class ReportCommand : public ::testing::Test {
 protected:
  ReportCommand() {
    test::put(in_, test::kFork);
    EXPECT_EQ(run({"reconstruct", in_, "-o", model_}).code, 0);
  }
  [[nodiscard]] Element page() const {
    std::string why;
    const auto page = test::parse_markup(test::get(out_), why);
    EXPECT_TRUE(page.has_value()) << why;
    return page.value_or(Element{});
  }
  [[nodiscard]] std::string labels(const std::string& text) const {
    const std::string path = folder_.file("labels.txt");
    test::put(path, text);
    return path;
  }
  TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string model_ = folder_.file("fork.vtu");
  std::string out_ = folder_.file("out.html");
};

TEST_F(ReportCommand, WritesAPageAndSaysWhatWasChecked) {
  const test::Outcome outcome = run({"report", model_, in_, "-o", out_});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 manifold: holds\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("5 cavities and tunnels: holds\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("written: " + out_), std::string::npos);
  EXPECT_EQ(page().all("h1").front()->text, "fork");
  EXPECT_EQ(page().all("span", "holds").size(), 5U);
  EXPECT_NE(page().all("code").front()->text.find("tetloft report "), std::string::npos);
  EXPECT_EQ(run({"report", model_, in_, "-o", out_, "--quiet"}).out, "");
}

TEST_F(ReportCommand, NeedsNoStack) {
  const JsonValue json = run_json({"report", model_, "-o", out_});
  EXPECT_TRUE(json.at("pass").boolean);
  EXPECT_EQ(json.at("guarantees").array[0].at("verdict").string, "holds");
  EXPECT_EQ(json.at("guarantees").array[1].at("verdict").string, "unchecked");
  EXPECT_EQ(json.at("guarantees").array[1].at("why").string, "no stack was given");
  EXPECT_EQ(json.at("frustum_volume").kind, JsonValue::Kind::null);
}

TEST_F(ReportCommand, JsonHasTheNumbersThatCheckHas) {
  const JsonValue json = run_json({"report", model_, in_, "-o", out_});
  const JsonValue check = run_json({"check", model_, in_});
  EXPECT_EQ(json.at("volume").number, check.at("volume").number);
  EXPECT_EQ(json.at("cavities").number, check.at("cavities").number);
  EXPECT_EQ(json.at("quality").at("dihedral_degrees").at("least").number,
            check.at("smallest_dihedral_degrees").number);
  EXPECT_EQ(static_cast<double>(json.at("components").array.size()), check.at("components").number);
  EXPECT_EQ(json.at("written").string, out_);
  EXPECT_EQ(json.at("bytes").number, static_cast<double>(test::get(out_).size()));
  double kinds = 0;
  for (const auto& [name, count] : json.at("kinds").object) kinds += count.number;
  EXPECT_EQ(kinds, json.at("tets").number);
  double angles = 0;
  for (const JsonValue& n : json.at("quality").at("dihedral_histogram").at("counts").array) {
    angles += n.number;
  }
  EXPECT_EQ(angles, 6 * json.at("tets").number);
}

TEST_F(ReportCommand, OfAModelThatFailsIsWrittenAndTheExitCodeSaysSo) {
  test::put(in_, test::kTube);
  const test::Outcome outcome = run({"report", model_, in_, "-o", out_});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("check failed: guarantee 2 (re-sampling)"), std::string::npos);
  EXPECT_EQ(page().all("div", "fails").size(), 1U);
  const JsonValue json = run_json({"report", model_, in_, "-o", out_}, 1);
  EXPECT_FALSE(json.at("pass").boolean);
  EXPECT_FALSE(json.at("guarantees").array[1].at("failures").array.empty());
}

TEST_F(ReportCommand, OptionsAreHeard) {
  const std::string title = "<Leber> & \"Milz\"";
  EXPECT_EQ(run({"report", model_, in_, "-o", out_, "--title", title, "--date", "heute",
                 "--sections", "1"})
                .code,
            0);
  EXPECT_EQ(page().all("h1").front()->text, title);
  EXPECT_NE(page().all("p", "sub").front()->text.find("heute"), std::string::npos);
  EXPECT_EQ(page().all("path", "contour").size(), 1U);
  // Other rules, other components.
  const JsonValue parted =
      run_json({"report", model_, in_, "-o", out_, "--labels", labels("0 0 1\n1 0 1\n1 1 2\n")}, 1);
  EXPECT_EQ(parted.at("guarantees").array[3].at("verdict").string, "fails");
}

TEST_F(ReportCommand, NamesOfFilesAreShownWithoutTheirFolders) {
  const std::string odd = folder_.file("a<b>&'c'.cnt");
  test::put(odd, test::kFork);
  EXPECT_EQ(run({"report", model_, odd, "-o", out_}).code, 0);
  const std::string sub = page().all("p", "sub").front()->text;
  EXPECT_EQ(sub, "solid fork.vtu of the sections a<b>&'c'.cnt");
}

TEST_F(ReportCommand, RefusesWrongUseAndLeavesNothing) {
  expect_failure({"report", model_, in_}, 2, "usage", "--output");
  expect_failure({"report", "-o", out_}, 2, "usage", "MODEL");
  expect_failure({"report", model_, in_, in_, "-o", out_}, 2, "usage", "unexpected", {out_});
  expect_failure({"report", model_, in_, "-o", folder_.file("a.pdf")}, 2, "usage", ".html");
  expect_failure({"report", model_, in_, "-o", folder_.file("no/a.html")}, 4, "io", "folder");
  for (const char* wrong : {"0", "13", "some"}) {
    expect_failure({"report", model_, in_, "-o", out_, "--sections", wrong}, 2, "usage",
                   "--sections", {out_});
  }
  expect_failure({"report", model_, folder_.file("none.cnt"), "-o", out_}, 4, "io", "none.cnt",
                 {out_});
  expect_failure({"report", in_, "-o", out_}, 3, "invalid_input", "in.cnt", {out_});
  test::put(in_, test::kBowtie);
  expect_failure({"report", model_, in_, "-o", out_}, 3, "invalid_input", "in.cnt", {out_});
  test::put(in_, test::kFork);
  expect_failure({"report", model_, in_, "-o", out_, "--labels", labels("7 0 1\n")}, 3,
                 "invalid_input", "label", {out_});
}

TEST_F(ReportCommand, HelpTellsOfTheStackThatMayBeLeftOut) {
  EXPECT_NE(run({"report", "--help"}).out.find("usage: tetloft report MODEL.vtu [IN"),
            std::string::npos);
}

}  // namespace
}  // namespace tetloft
