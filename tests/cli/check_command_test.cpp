// tetloft check.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::TempFolder;

// The cube of side 2 over two equal squares, in five tets, made without reconstruct.
Model cube() {
  Model model;
  for (int i = 0; i < 8; ++i) {
    model.points.push_back(
        {(i & 1) != 0 ? 2.0 : 0.0, (i & 2) != 0 ? 2.0 : 0.0, (i & 4) != 0 ? 1.0 : 0.0});
  }
  const auto add = [&](int a, int b, int c, int d) {
    model.tets.push_back({VertexId(a), VertexId(b), VertexId(c), VertexId(d)});
  };
  add(0, 1, 2, 4);
  add(3, 2, 1, 7);
  add(5, 4, 7, 1);
  add(6, 7, 4, 2);
  add(1, 2, 4, 7);
  return model;
}

class CheckCommand : public testing::Test {
 protected:
  CheckCommand() { test::put(in_, test::kTube); }

  void write(const Model& model) { ASSERT_TRUE(write_vtu(model_, model).ok()); }

  TempFolder folder_;
  std::string in_ = folder_.file("a.cnt");
  std::string model_ = folder_.file("m.vtu");
};

TEST_F(CheckCommand, PassesAHandMadeCube) {
  write(cube());
  const Outcome outcome = run({"check", model_, in_});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  for (const char* line : {"1 ", "2 ", "3 ", "4 "}) {
    const std::size_t at = outcome.out.find(std::string("\n") + line);
    EXPECT_TRUE(at != std::string::npos || outcome.out.rfind(line, 0) == 0) << outcome.out;
  }
  EXPECT_NE(outcome.out.find("PASS"), std::string::npos);
  EXPECT_EQ(outcome.out.find("FAIL"), std::string::npos);
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
}

TEST_F(CheckCommand, ReportsInJson) {
  write(cube());
  const JsonValue json = run_json({"check", model_, in_});
  EXPECT_TRUE(json.at("pass").boolean);
  ASSERT_EQ(json.at("guarantees").array.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const JsonValue& guarantee = json.at("guarantees").array[i];
    EXPECT_EQ(guarantee.at("number").number, static_cast<double>(i + 1));
    EXPECT_FALSE(guarantee.at("name").string.empty());
    EXPECT_TRUE(guarantee.at("pass").boolean);
    EXPECT_EQ(guarantee.at("not_asked").string, "");
    EXPECT_TRUE(guarantee.at("failures").array.empty());
  }
  for (const char* none : {"cavities", "expected_cavities", "least_genus", "most_genus",
                           "deviations", "forced_voids", "unrealisable_voids"}) {
    EXPECT_EQ(json.at(none).number, 0) << none;
  }
  EXPECT_EQ(json.at("components").number, 1);
  ASSERT_EQ(json.at("genus").array.size(), 1U);
  EXPECT_EQ(json.at("genus").array[0].number, 0);
  EXPECT_NEAR(json.at("volume").number, 4, 1e-12);
  EXPECT_EQ(json.at("overshoot").number, 0);
  EXPECT_GT(json.at("smallest_dihedral_degrees").number, 10);
  EXPECT_EQ(json.at("largest_split_ulps").number, 0);
  EXPECT_EQ(json.at("inner_vertices").number, 0);
}

TEST_F(CheckCommand, TakesStrict) {
  write(cube());
  EXPECT_TRUE(run_json({"check", "--strict", model_, in_}).at("pass").boolean);
}

// Refined by a mesher: a vertex in the middle of each triangle of its bottom.
TEST_F(CheckCommand, TellsOfVerticesInsideSections) {
  Model model = cube();
  std::vector<TetVertices> tets;
  std::size_t inserted = 0;
  for (const TetVertices& tet : model.tets) {
    std::vector<std::size_t> bottom;
    for (std::size_t i = 0; i < 4; ++i) {
      if (model.points[tet[i]].z == model.points[VertexId(0)].z) bottom.push_back(i);
    }
    if (bottom.size() < 3) {
      tets.push_back(tet);
      continue;
    }
    Point3 middle = model.points[tet[bottom[0]]];
    middle.x = (middle.x + model.points[tet[bottom[1]]].x + model.points[tet[bottom[2]]].x) / 3;
    middle.y = (middle.y + model.points[tet[bottom[1]]].y + model.points[tet[bottom[2]]].y) / 3;
    const VertexId v = model.points.push_back(middle);
    ++inserted;
    for (const std::size_t i : bottom) {
      tets.push_back(tet);
      tets.back()[i] = v;
    }
  }
  ASSERT_GT(inserted, 0U);
  Model refined;
  refined.points = model.points;
  refined.tets = IdVector<TetId, TetVertices>(tets);
  write(refined);
  const Outcome outcome = run({"check", model_, in_});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("not as reconstruct makes it: " + std::to_string(inserted) + " vert"),
            std::string::npos)
      << outcome.out;
  const JsonValue json = run_json({"check", model_, in_});
  EXPECT_EQ(json.at("inner_vertices").number, static_cast<double>(inserted));
}

TEST_F(CheckCommand, FailsAModelOfAnotherStack) {
  write(cube());
  test::put(in_, test::kFork);
  const Outcome outcome = run({"check", model_, in_});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("2 re-sampling: FAIL"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("guarantee"), std::string::npos) << outcome.err;
  const JsonValue json = run_json({"check", model_, in_}, 1);
  EXPECT_FALSE(json.at("pass").boolean);
  const JsonValue& guarantee = json.at("guarantees").array[1];
  EXPECT_FALSE(guarantee.at("pass").boolean);
  ASSERT_FALSE(guarantee.at("failures").array.empty());
  const JsonValue& failure = guarantee.at("failures").array[0];
  EXPECT_FALSE(failure.at("what").string.empty());
  EXPECT_GT(failure.at("count").number, 0);
  EXPECT_FALSE(failure.at("places").array.empty());
}

TEST_F(CheckCommand, FailsAnInvertedTet) {
  Model model = cube();
  std::swap(model.tets[TetId(4)][0], model.tets[TetId(4)][1]);
  write(model);
  EXPECT_EQ(run({"check", model_, in_}).code, 1);
  EXPECT_EQ(run({"check", model_, in_, "--quiet"}).out, "");
}

TEST_F(CheckCommand, TakesChainsAndLoneRegionsAsReconstructDoes) {
  test::put(in_, test::kLeaning);
  const auto made = [&](const std::vector<std::string>& extra) {
    std::vector<std::string> words{"reconstruct",      in_,      "-o", model_, "--verify",
                                   "--correspondence", "overlap"};
    words.insert(words.end(), extra.begin(), extra.end());
    return run_json(words).at("components").number;
  };
  EXPECT_EQ(made({"--no-chain", "--no-lone"}), 2);
  EXPECT_EQ(made({"--no-lone"}), 1);
  EXPECT_EQ(made({"--no-chain"}), 1);
  EXPECT_EQ(made({}), 1);
  const std::vector<std::string> words{"check", model_, in_, "--correspondence", "overlap"};
  EXPECT_TRUE(run_json(words).at("pass").boolean);
  std::vector<std::string> without_links = words;
  for (const char* flag : {"--no-chain", "--no-lone"}) without_links.emplace_back(flag);
  const JsonValue without = run_json(without_links, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(without.at("guarantees").array[i].at("pass").boolean, i != 3);
  }
}

TEST_F(CheckCommand, TellsWhatCannotBeRead) {
  write(cube());
  expect_failure({"check", folder_.file("none.vtu"), in_}, 4, "io", "none.vtu");
  expect_failure({"check", model_, folder_.file("none.cnt")}, 4, "io", "none.cnt");
  expect_failure({"check", in_, in_}, 3, "invalid_input", "a.cnt:1");
  expect_failure({"check", model_, model_}, 3, "invalid_input", "m.vtu:1");
  const std::string whole = test::get(model_);
  test::put(model_, whole.substr(0, whole.size() / 2));
  expect_failure({"check", model_, in_}, 3, "invalid_input", "m.vtu");
  expect_failure({"check", model_, in_, "--snap", "99"}, 2, "usage", "--snap");
}

}  // namespace
}  // namespace tetloft
