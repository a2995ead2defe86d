// Whole models of the small cases of voids and of inputs that were reported: how many bodies,
// cavities and handles are due, by their READMEs.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

struct Due {
  const char* name;
  std::size_t components, cavities;
  long genus;
};

void expect_due(const SectionStack& stack, const Due& due, const ReconstructOptions& options = {}) {
  SCOPED_TRACE(due.name);
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  const CheckReport& report = checked->report;
  EXPECT_EQ(report.components, due.components);
  EXPECT_EQ(report.cavities, due.cavities);
  EXPECT_EQ(report.expected_cavities, due.cavities);
  EXPECT_EQ(std::accumulate(report.genus.begin(), report.genus.end(), 0L), due.genus);
  EXPECT_EQ(report.deviations, 0U);
  EXPECT_EQ(report.forced_voids, 0U);
  EXPECT_EQ(report.unrealisable_voids, 0U);
}

SectionStack void_case(const std::string& name) { return sample("cases/voids/" + name + ".cnt"); }

ReconstructOptions with_labels(const std::string& file) {
  ReconstructOptions options;
  options.correspondence.labels =
      read_labels(TETLOFT_DATA_DIR "/cases/voids/" + file).value().labels;
  return options;
}

TEST(VoidSamples, HaveTheTopologyDue) {
  for (const Due& due :
       {Due{"bars", 1, 0, 1}, Due{"holes_edge", 1, 2, 0}, Due{"holes_leak_30", 1, 1, 0},
        Due{"holes_wm4_20", 1, 2, 0}, Due{"oblique_tunnel", 1, 0, 1},
        Due{"oblique_tunnel_touch", 1, 0, 1}, Due{"one_two", 1, 2, 0},
        Due{"parallel_slits", 1, 2, 0}, Due{"slit_over_two", 1, 1, 0}, Due{"two_over_two", 1, 1, 1},
        Due{"weak_holes", 1, 1, 0}}) {
    expect_due(void_case(due.name), due);
  }
}

// Each hole ends at the section across: nothing goes through the block.
TEST(VoidSamples, HolesWithIslandsOfOtherLabelsAreClosed) {
  for (const Due& due : {Due{"foreign_island", 2, 0, 0}, Due{"label_island_1", 2, 0, 0}}) {
    expect_due(void_case(due.name), due, with_labels("l1.txt"));
  }
  for (const Due& due : {Due{"label_island_3", 3, 0, 0}, Due{"label_island_4", 3, 0, 0}}) {
    expect_due(void_case(due.name), due, with_labels("l3.txt"));
  }
}

// Between the islands no tet has four corners of the one class until edges are divided.
TEST(VoidSamples, WallsBetweenIslandsMayNeedDividedContours) {
  ReconstructOptions as_given = with_labels("l3.txt");
  as_given.divide_coarse = false;
  const auto coarse = reconstruct(void_case("label_island_3"), as_given);
  const auto divided = reconstruct(void_case("label_island_4"), as_given);
  ASSERT_TRUE(coarse.ok() && divided.ok());
  EXPECT_EQ(coarse->report.split_vertices, 0U);
  EXPECT_GT(divided->report.split_vertices, 0U);
  EXPECT_EQ(fired(*divided, Rule::united_voids), 0U);
  EXPECT_GT(fired(*divided, Rule::closed_passage), 0U);
}

// Two rings that do not overlap and that no rule joins: hole and exterior are one void, whatever
// links say.
TEST(VoidSamples, RingsApartMakeHoleAndExteriorOne) {
  ReconstructOptions options;
  options.correspondence.chain = options.correspondence.lone = false;
  options.correspondence.criterion = Criterion::overlap;
  const auto checked = reconstruct_and_check(void_case("rings_unlinked"), options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->report.components, 2U);
  EXPECT_EQ(checked->report.cavities, 0U);
}

// By the kinds of links alone: no passage, no wall.
TEST(VoidSamples, ByFreeNothingIsClosed) {
  ReconstructOptions options;
  options.correspondence.voids.rule = VoidRule::free;
  const auto made = reconstruct(void_case("holes_wm4_20"), options);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(fired(*made, Rule::closed_passage), 0U);
  CheckOptions check_options;
  check_options.correspondence = options.correspondence;
  const auto report = check(made->model, void_case("holes_wm4_20"), check_options);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->cavities, 1U);  // joined by a tunnel 20 long
  EXPECT_FALSE(report->expected_cavities);
}

TEST(VoidSamples, ReportedOnesHaveTheTopologyDue) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "reported";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (const Due& due : {Due{"holes_leak_30", 1, 1, 0}, Due{"holes_pores_3_1", 1, 30, 0},
                         Due{"holes_pores_7_2", 1, 30, 0}, Due{"holes_specks", 1, 180, 0},
                         Due{"holes_wm4_20", 1, 2, 0}, Due{"holes_wormhole", 1, 2, 0}}) {
    const auto read = read_cnt((folder / (std::string(due.name) + ".cnt")).string());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    expect_due(read->stack, due);
  }
}

// The copies of the repository are those of the shared folder.
TEST(VoidSamples, AreThoseOfTheSharedFolder) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "voids";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cnt") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const auto read = read_cnt(entry.path().string());
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(format_cnt(read->stack).value(),
              format_cnt(void_case(entry.path().stem().string())).value());
    ++compared;
  }
  EXPECT_EQ(compared, 17U);
}

}  // namespace
}  // namespace tetloft::testing
