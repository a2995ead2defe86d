// Formats on the command line: help lists the table, contents decide, --format forces.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include <tetloft/formats.hpp>

#include "cli/runner.hpp"
#include "core/little_endian.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::expect_failure;
using test::kTube;
using test::run;
using test::run_json;
using test::TempFolder;

// What help says of an option, from its name to that of the next.
std::string help_of(const std::string& command, const std::string& option) {
  const std::string help = run({command, "--help"}).out;
  const std::size_t from = help.find(option + ' ');
  if (from == std::string::npos) return {};
  const std::size_t to = help.find("\n  -", from);
  return help.substr(from, to - from);
}

TEST(FormatsInHelp, AreThoseOfTheTable) {
  using Row = std::pair<std::vector<std::string>, std::string>;
  const auto expect = [](Contents contents, bool reading, const std::vector<Row>& rows) {
    for (const FormatInfo& format : formats()) {
      if (!(reading ? format.reads : format.writes).has(contents)) continue;
      for (const auto& [commands, option] : rows) {
        for (const std::string& command : commands) {
          const std::string help = help_of(command, option);
          for (const std::string_view extension : format.extensions) {
            EXPECT_NE(help.find(extension), std::string::npos)
                << command << option << extension << '\n'
                << help;
          }
          const std::string_view name = reading ? format.name : "";
          EXPECT_NE(help.find(name), std::string::npos) << help;
        }
      }
    }
  };
  expect(Contents::stack, true,
         {{{"reconstruct", "check", "skeleton", "render", "info"}, "--format"}});
  expect(Contents::model, true, {{{"check", "render"}, "--model-format"}});
  expect(Contents::points, true, {{{"delaunay"}, "--format"}});
  expect(Contents::model, false, {{{"reconstruct", "delaunay"}, "--output"}});
  expect(Contents::surface, false, {{{"reconstruct"}, "--surface"}});
  expect(Contents::lines, false, {{{"skeleton"}, "--output"}});
}

TEST(FormatOption, IsCheckedBeforeAFileIsRead) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", "none"},
        {"reconstruct", "none", "-o", "a.vtu"},
        {"reconstruct", "none", "-o", "a.vtu", "--method", "geiger"},
        {"skeleton", "none", "-o", "a.vtp"},
        {"check", "none", "none"},
        {"render", "none", "-o", "a.png"},
        {"delaunay", "none"}}) {
    std::vector<std::string> wrong = words;
    wrong.insert(wrong.end(), {"--format", "psychic"});
    expect_failure(wrong, 2, "usage", "option --format: 'psychic' is not ");
  }
  expect_failure({"render", "none", "-o", "a.png", "--model-format", "vtx"}, 2, "usage",
                 "did you mean vtu?");
  expect_failure({"check", "none", "none", "--model-format", "cnt"}, 2, "usage", "is not vtu, ");
}

TEST(FormatOption, ForcesAFormat) {
  TempFolder folder;
  std::string bytes;
  for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.}) {
    append_little(bytes, value);
  }
  test::put(folder.file("p.dat"), bytes);
  expect_failure({"delaunay", folder.file("p.dat")}, 3, "invalid_input", "points are read as ");
  EXPECT_EQ(run_json({"delaunay", folder.file("p.dat"), "--format", "bin"}).at("tets").number, 1);
  expect_failure({"delaunay", folder.file("p.dat"), "--format", "xyz"}, 3, "invalid_input",
                 "p.dat:1");
}

TEST(Formats, AreRecognisedUnderAnyName) {
  TempFolder folder;
  const std::string stack = folder.file("a.dcm");
  test::put(stack, kTube);
  EXPECT_EQ(run_json({"info", stack}).at("slices").number, 2);
  const std::string solid = folder.file("a.vtu");
  EXPECT_EQ(run({"reconstruct", stack, "-o", solid}).code, 0);
  const std::string renamed = folder.file("model");
  test::put(renamed, test::get(solid));
  EXPECT_EQ(run({"check", renamed, stack}).code, 0);
  EXPECT_EQ(run({"render", renamed, "-o", folder.file("a.svg"), "--contours", stack}).code, 0);
  expect_failure({"info", renamed}, 3, "invalid_input", "format vtu");
  expect_failure({"check", stack, stack}, 3, "invalid_input", "format cnt");
}

TEST(Formats, ThatNothingTellsAreRefusedWithTheList) {
  TempFolder folder;
  test::put(folder.file("a.dat"), std::string("DICM\0\1", 6));
  expect_failure({"info", folder.file("a.dat")}, 3, "invalid_input", "a stack is read as ");
  expect_failure({"render", folder.file("a.dat"), "-o", folder.file("a.png")}, 3, "invalid_input",
                 "a model is read as vtu (");
  // Its extension, or text, makes it a .cnt with an error.
  test::put(folder.file("a.cnt"), std::string("DICM\0\1", 6));
  test::put(folder.file("b.dat"), "DICM");
  for (const char* name : {"a.cnt", "b.dat"}) {
    expect_failure({"info", folder.file(name)}, 3, "invalid_input", "expected 'S'");
  }
}

}  // namespace
}  // namespace tetloft
