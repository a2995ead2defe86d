// Files of several structures, from outside: what info tells, choosing one, a solid of each, and
// other formats of the same stack.
#include <gtest/gtest.h>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

// A square of side 2 in the plane x = `height`, from (y, 0).
std::string square(const std::string& structure, const std::string& y, const std::string& height) {
  std::string text = structure + "||4|||";
  for (const char* corner : {"0\\0", "2\\0", "2\\2", "0\\2"}) {
    const std::string yz(corner);
    const double at = std::stod(y) + std::stod(yz.substr(0, 1));
    text += (text.back() == '|' ? "" : "\\") + height + '\\' + std::to_string(at) + yz.substr(1);
  }
  return text + '\n';
}

std::size_t warnings_with(const JsonValue& told, const std::string& words) {
  std::size_t count = 0;
  for (const JsonValue& warning : told.at("warnings").array) {
    if (warning.at("message").string.find(words) != std::string::npos) ++count;
  }
  return count;
}

class StructuresCommand : public ::testing::Test {
 protected:
  StructuresCommand() {
    std::string text =
        "ROI_NAMES\n1||left lung\n2||../Left Lung\n3||tilted\n4||empty\nEND_OF_ROI_NAMES\n";
    for (const char* height : {"0", "1", "3"}) text += square("1", "0", height);
    for (const char* height : {"0", "1"}) text += square("2", "7", height);
    text += square("3", "0", "0") + "3||3|||0\\0\\0\\1\\5\\0\\4\\0\\5\n";
    // A slip of the file, not of any structure.
    text.replace(text.find("1||4|"), 5, "1||5|");
    test::put(in_, text);
  }

  TempFolder folder_;
  std::string in_ = folder_.file("in.cxt");
  std::string out_ = folder_.file("out.vtu");
};

TEST_F(StructuresCommand, AreListedByInfo) {
  const JsonValue told = run_json({"info", in_});
  EXPECT_EQ(told.at("format").string, "cxt");
  EXPECT_EQ(told.at("unit").string, "mm");
  const std::vector<JsonValue>& structures = told.at("structures").array;
  ASSERT_EQ(structures.size(), 4U);
  EXPECT_EQ(structures[0].at("number").number, 1);
  EXPECT_EQ(structures[0].at("name").string, "left lung");
  EXPECT_EQ(structures[0].at("contours").number, 3);
  EXPECT_EQ(structures[0].at("points").number, 12);
  EXPECT_EQ(structures[0].at("planes").number, 3);
  EXPECT_EQ(structures[0].at("types").object.size(), 1U);
  EXPECT_EQ(structures[2].at("planes").number, 0);
  EXPECT_FALSE(told.has("sections"));
  EXPECT_EQ(run_json({"info", in_, "--roi", "1"}).at("sections").array.size(), 3U);
  EXPECT_NE(run({"info", in_}).out.find("left lung"), std::string::npos);
}

TEST_F(StructuresCommand, MustBeChosenWhereThereAreSeveral) {
  expect_failure({"reconstruct", in_, "-o", out_}, 2, "usage", "--roi NUMBER or NAME", {out_});
  expect_failure({"reconstruct", in_, "--roi", "lung", "-o", out_}, 2, "usage", "'left lung'",
                 {out_});
  expect_failure({"reconstruct", in_, "--roi", "3", "-o", out_}, 3, "invalid_input", "parallel",
                 {out_});
  expect_failure({"check", out_, in_, "--roi", "1", "--label", "1"}, 2, "usage", "--label");
  expect_failure({"convert", in_, "--roi", "all", "-o", folder_.file("a.cnt")}, 2, "usage",
                 "reconstruct alone");
  const JsonValue made = run_json({"reconstruct", in_, "--roi", "LEFT LUNG", "-o", out_});
  EXPECT_EQ(made.at("slices").number, 3);
  EXPECT_EQ(made.at("volume").number, 12);
  EXPECT_EQ(run({"check", out_, in_, "--roi", "1"}).code, 0);
}

TEST_F(StructuresCommand, AllBecomeSolidsButThoseThatFail) {
  const JsonValue told = run_json({"reconstruct", in_, "--roi", "all", "-o", out_}, 3);
  const std::vector<JsonValue>& structures = told.at("structures").array;
  ASSERT_EQ(structures.size(), 3U);
  EXPECT_EQ(structures[0].at("written").array.at(0).string, folder_.file("out-left_lung.vtu"));
  EXPECT_EQ(structures[1].at("written").array.at(0).string, folder_.file("out-.._Left_Lung.vtu"));
  EXPECT_EQ(structures[1].at("volume").number, 4);
  EXPECT_EQ(structures[2].at("error").at("code").string, "invalid_input");
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"in.cxt", "out-.._Left_Lung.vtu", "out-left_lung.vtu"}));
  EXPECT_EQ(warnings_with(told, "'empty' has no closed contour"), 1U);
  EXPECT_EQ(warnings_with(told, "another number of points"), 1U);
  EXPECT_EQ(run({"check", folder_.file("out-left_lung.vtu"), in_, "--roi", "1"}).code, 0);
  const test::Outcome plain = run({"reconstruct", in_, "--roi", "all", "-o", out_});
  EXPECT_NE(plain.err.find("structure 3 'tilted'"), std::string::npos) << plain.err;
  expect_failure({"reconstruct", in_, "--roi", "all", "--labels", in_, "-o", out_}, 2, "usage",
                 "--labels");
}

TEST_F(StructuresCommand, AreConvertedWhereTheyLie) {
  // Only .csl and .vtp know planes of any direction: the others say so.
  for (const char* name : {"a.csl", "a.vtp"}) {
    const std::string there = folder_.file(name);
    EXPECT_EQ(warnings_with(run_json({"convert", in_, "--roi", "1", "-o", there}), "directions"),
              0U);
    EXPECT_EQ(run_json({"reconstruct", there, "-o", out_}).at("volume").number, 12) << name;
    EXPECT_EQ(run({"check", out_, in_, "--roi", "1"}).code, 0) << name;
  }
  const JsonValue flat =
      run_json({"convert", in_, "--roi", "1", "-o", folder_.file("a.cnt"), "--quiet"});
  EXPECT_EQ(warnings_with(flat, "directions"), 1U);
  EXPECT_EQ(flat.at("name").string, "left lung");
}

TEST_F(StructuresCommand, LabelsOfTheFileDecideAndAreKept) {
  // Two bars that overlap from section to section, but bear different labels.
  std::string text = "CSLC\n2 3\n";
  for (int plane = 1; plane <= 2; ++plane) {
    const std::string z = std::to_string(plane);
    text += '\n' + z + " 3 1 0 0 1 -" + z + "\n\n0 0 " + z + "\n4 0 " + z + "\n0 4 " + z +
            "\n\n3 " + z + " 0 1 2\n";
  }
  const std::string labelled = folder_.file("a.csl");
  test::put(labelled, text);
  EXPECT_EQ(run_json({"info", labelled}).at("labels").array.size(), 2U);
  EXPECT_EQ(run_json({"reconstruct", labelled, "-o", out_}).at("components").number, 2);
  EXPECT_EQ(run({"check", out_, labelled}).code, 0);
  const std::string labels = folder_.file("a.labels");
  EXPECT_EQ(run({"convert", labelled, "-o", folder_.file("a.cnt"), "--labels-out", labels}).code,
            0);
  EXPECT_EQ(test::get(labels), "0 0 1\n1 0 2\n");
  const JsonValue all = run_json({"reconstruct", labelled, "--label", "all", "-o", out_});
  ASSERT_EQ(all.at("structures").array.size(), 2U);
  EXPECT_EQ(all.at("structures").array[1].at("number").number, 2);
}

}  // namespace
}  // namespace tetloft
