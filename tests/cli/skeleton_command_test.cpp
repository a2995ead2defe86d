// tetloft skeleton.
#include <gtest/gtest.h>

#include <sstream>
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

// The numbers of a DataArray in an ASCII file.
std::vector<double> numbers(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + '"');
  if (at == std::string::npos) return {};
  const std::size_t begin = file.find('>', at) + 1;
  std::istringstream text(file.substr(begin, file.find('<', begin) - begin));
  std::vector<double> result;
  for (double value = 0; text >> value;) result.push_back(value);
  return result;
}

class SkeletonCommand : public ::testing::Test {
 protected:
  SkeletonCommand() {
    // A rectangle: two triangles, one internal edge, four hull edges; and a triangle.
    test::put(in_, "S 2\nv 4 z 0\n{ 0 0 4 0 4 3 0 3 }\nv 3 z 2\n{ 0 0 4 0 1 3 }\n");
  }
  TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string out_ = folder_.file("out.vtp");
};

TEST_F(SkeletonCommand, WritesDualEdgesLabelledByContour) {
  test::put(in_, "S 1\nv 8 z 5\n{ 0 0 4 0 4 4 0 4 }\n{ 10 0 14 0 14 4 10 4 }\n");
  const JsonValue json = run_json({"skeleton", in_, "-o", out_, "--ascii"});
  const std::string file = test::get(out_);
  const std::vector<double> section = numbers(file, "section");
  const std::vector<double> kind = numbers(file, "kind");
  const std::vector<double> a = numbers(file, "contour_a");
  const std::vector<double> b = numbers(file, "contour_b");
  const std::vector<double> points = numbers(file, "Points");
  ASSERT_EQ(points.size(), 6 * section.size());
  EXPECT_EQ(static_cast<double>(section.size()),
            json.at("internal").number + json.at("external").number - json.at("outside").number);
  EXPECT_EQ(json.at("internal").number, 2);  // a diagonal in each square
  bool between = false;
  for (std::size_t k = 0; k < section.size(); ++k) {
    EXPECT_EQ(section[k], 0);
    EXPECT_EQ(points[6 * k + 2], 5);
    EXPECT_EQ(points[6 * k + 5], 5);
    if (kind[k] == 0) {
      EXPECT_EQ(a[k], b[k]);
    }
    if (kind[k] != 1 || a[k] == b[k]) continue;
    // Between the squares the skeleton is the line halfway.
    between = true;
    EXPECT_EQ(points[6 * k], 7);
    EXPECT_EQ(points[6 * k + 3], 7);
  }
  EXPECT_TRUE(between);
}

TEST_F(SkeletonCommand, SelectsKinds) {
  ASSERT_EQ(run({"skeleton", in_, "-o", out_, "--ascii", "--kind", "internal"}).code, 0);
  for (const double kind : numbers(test::get(out_), "kind")) EXPECT_EQ(kind, 0);
  const JsonValue json = run_json({"skeleton", in_, "-o", out_, "--kind", "external"});
  EXPECT_EQ(json.at("internal").number, 0);
}

// Rhombi: a flat one; above it one that stands across it and one far away; above the latter a flat
// one again, whose skeleton ends that of the standing one.
TEST_F(SkeletonCommand, TellsWhichContoursAreWellPositioned) {
  test::put(in_,
            "S 3\nv 4 z 0\n{ -4 0 0 -1 4 0 0 1 }\n"
            "v 8 z 1\n{ 100 -4 101 0 100 4 99 0 }\n{ 0 -4 1 0 0 4 -1 0 }\n"
            "v 4 z 2\n{ 96 1.875 100 0.875 104 1.875 100 2.875 }\n");
  const JsonValue json = run_json({"skeleton", in_, "-o", out_});
  std::ostringstream pairs;
  for (const JsonValue& pair : json.at("well_positioned").array) {
    EXPECT_EQ(pair.object.size(), 4U);
    pairs << pair.at("slab").number << ' ' << pair.at("below").number << ' '
          << pair.at("above").number << (pair.at("proper").boolean ? " proper\n" : " touch\n");
  }
  EXPECT_EQ(pairs.str(), "0 0 1 proper\n1 0 0 touch\n");
  const test::Outcome text = run({"skeleton", in_, "-o", out_, "--kind", "internal"});
  EXPECT_NE(text.out.find("2 well positioned pairs of contours (1 whose skeletons only touch)\n"),
            std::string::npos)
      << text.out;
}

TEST_F(SkeletonCommand, FindsNoWellPositionedContoursInOneSection) {
  test::put(in_, "S 1\nv 4 z 0\n{ -4 0 0 -1 4 0 0 1 }\n");
  const JsonValue json = run_json({"skeleton", in_, "-o", out_});
  EXPECT_EQ(json.at("well_positioned").kind, JsonValue::Kind::array);
  EXPECT_TRUE(json.at("well_positioned").array.empty());
}

TEST_F(SkeletonCommand, RefusesWrongUse) {
  expect_failure({"skeleton", in_}, 2, "usage", "--output");
  expect_failure({"skeleton", in_, "-o", out_, "--kind", "medial"}, 2, "usage", "medial", {out_});
  expect_failure({"skeleton", in_, "-o", folder_.file("a.vtu")}, 2, "usage", ".vtp");
  expect_failure({"skeleton", folder_.file("none.cnt"), "-o", out_}, 4, "io", "none.cnt", {out_});
  test::put(in_, test::kBowtie);
  expect_failure({"skeleton", in_, "-o", out_}, 3, "invalid_input", "", {out_});
  EXPECT_EQ(run({"skeleton", in_, "-o", out_, "--repair"}).code, 0);
}

}  // namespace
}  // namespace tetloft
