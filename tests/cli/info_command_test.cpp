// tetloft info.
#include <gtest/gtest.h>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::TempFolder;

// A square with a hole with an island, and an empty section above.
constexpr const char* kNested =
    "S 2\nv 12 z -1\n{ 0 0 10 0 10 10 0 10 }\n{ 2 2 2 8 8 8 8 2 }\n{ 4 4 6 4 6 6 4 6 }\n"
    "v 0 z 3\n";

TEST(InfoCommand, DescribesNesting) {
  TempFolder folder;
  test::put(folder.file("a.cnt"), kNested);
  const JsonValue json = run_json({"info", folder.file("a.cnt")});
  EXPECT_EQ(json.at("slices").number, 2);
  EXPECT_EQ(json.at("contours").number, 3);
  EXPECT_EQ(json.at("regions").number, 2);
  EXPECT_EQ(json.at("vertices").number, 12);
  EXPECT_EQ(json.at("depth").number, 2);
  EXPECT_EQ(json.at("extents").at("x").array[1].number, 10);
  EXPECT_EQ(json.at("extents").at("z").array[0].number, -1);
  ASSERT_EQ(json.at("sections").array.size(), 2U);
  const JsonValue& section = json.at("sections").array[0];
  EXPECT_NEAR(section.at("area").number, 100 - 36 + 4, 1e-12);
  ASSERT_EQ(section.at("contours").array.size(), 3U);
  const JsonValue& hole = section.at("contours").array[1];
  EXPECT_EQ(hole.at("depth").number, 1);
  EXPECT_EQ(hole.at("parent").number, 0);
  EXPECT_EQ(hole.at("signed_area").number, -36);
  EXPECT_EQ(section.at("contours").array[0].at("parent").kind, JsonValue::Kind::null);
  EXPECT_EQ(hole.at("region").number, section.at("contours").array[0].at("region").number);
  EXPECT_TRUE(json.at("sections").array[1].at("contours").array.empty());
}

TEST(InfoCommand, PrintsALinePerSection) {
  TempFolder folder;
  test::put(folder.file("a.cnt"), kNested);
  const Outcome outcome = run({"info", folder.file("a.cnt")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("2 sections, 3 contours"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("nested 2 deep"), std::string::npos) << outcome.out;
  EXPECT_TRUE(outcome.err.empty());
}

TEST(InfoCommand, TellsWhatIsWrong) {
  TempFolder folder;
  test::put(folder.file("a.cnt"), test::kBowtie);
  expect_failure({"info", folder.file("a.cnt")}, 3, "invalid_input", "a.cnt:3");
  expect_failure({"info", folder.file("none.cnt")}, 4, "io", "none.cnt");
  // File names of any bytes give valid JSON.
  expect_failure({"info", folder.file("\xFF\x01\"\\")}, 4, "io", "");
}

}  // namespace
}  // namespace tetloft
