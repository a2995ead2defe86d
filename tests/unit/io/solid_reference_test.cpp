// Solids of other programs, where they are there: what is read of each is what an independent
// reader found, in NAME.truth.json beside it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include <tetloft/formats.hpp>

#include "cli/json_value.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

std::string solid_samples() {
  const char* const set = std::getenv("TETLOFT_SHARED_DATA");
  return std::string(set != nullptr ? set : TETLOFT_SHARED_DATA_DIR) + "/formats/mesh-output/";
}

void expect_as_found(const std::string& read_name, const std::string& truth_name) {
  SCOPED_TRACE(read_name);
  const auto truth = test::parse_json(test::get(solid_samples() + truth_name + ".truth.json"));
  ASSERT_TRUE(truth.has_value());
  const auto read = read_model(solid_samples() + read_name);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  const auto number = [](const test::JsonValue& value) {
    return static_cast<std::size_t>(value.number);
  };
  EXPECT_EQ(read->model.points.size(), number(truth->at("points")));
  EXPECT_EQ(read->model.tets.size(), number(truth->at("cells").at("tetra")));
  EXPECT_NEAR(volume(read->model), truth->at("tetra_volume").number, 1e-12);
  // Two boxes, 1 and 0.7 high.
  EXPECT_EQ(read->model.component_count, 2U);
  std::map<ComponentId, Model> parts;
  for (const TetId t : read->model.tets.ids()) {
    Model& part = parts[read->model.component[t]];
    part.points = read->model.points;
    part.tets.push_back(read->model.tets[t]);
  }
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(volume(parts[ComponentId(0)]), 1, 1e-12);
  EXPECT_NEAR(volume(parts[ComponentId(1)]), 0.7, 1e-12);
}

TEST(SolidSamples, OfMeditAreReadAsOthersReadThem) {
  if (!std::filesystem::exists(solid_samples()))
    GTEST_SKIP() << "no samples at " << solid_samples();
  expect_as_found("two.mesh", "two.mesh");
  expect_as_found("two_meshio.mesh", "two_meshio.mesh");
}

TEST(SolidSamples, OfTetgenAreReadAsOthersReadThem) {
  if (!std::filesystem::exists(solid_samples()))
    GTEST_SKIP() << "no samples at " << solid_samples();
  expect_as_found("two_tet.ele", "two_tet.node");
}

}  // namespace
}  // namespace tetloft
