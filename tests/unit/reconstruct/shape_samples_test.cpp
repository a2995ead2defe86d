// Lofts of few vertices and thin parts that were reported: how many bodies and handles are due, and
// what volume, by their README.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

struct Shape {
  const char* name;
  const char* labels;  // a file, or none
  std::size_t components, cavities;
  long genus;
  double volume, error;  // relative; 0: not asked
};

constexpr Shape kShapes[] = {
    {"loft_sq10", "", 1, 0, 0, 1987, 0.03},
    {"loft_sq45", "", 1, 0, 0, 1885, 0.05},
    {"loft_rects25", "", 1, 0, 0, 7634, 0.03},
    {"thin_cone_min", "", 1, 0, 1, 0, 0},
    {"thin_shell_4_5", "", 1, 1, 0, 0, 0},
    {"thin_shell_4_5", "thin_labs.txt", 1, 1, 0, 0, 0},
    {"thin_cap_min", "thin_lab2.txt", 1, 0, 0, 0, 0},
    {"thin_tube", "", 1, 0, 0, 0, 0},
    {"thin_sheet", "", 1, 0, 0, 550, 0.03},
};

TEST(ShapeSamples, ReportedOnesAreAsTheyAreDue) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "reported";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (const Shape& due : kShapes) {
    SCOPED_TRACE(due.name);
    const auto read = read_cnt((folder / (std::string(due.name) + ".cnt")).string());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    ReconstructOptions options;
    if (*due.labels != 0) {
      options.correspondence.labels = read_labels((folder / due.labels).string()).value().labels;
    }
    const auto checked = reconstruct_and_check(read->stack, options);
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->report.components, due.components);
    EXPECT_EQ(checked->report.cavities, due.cavities);
    const auto& genus = checked->report.genus;
    EXPECT_EQ(std::accumulate(genus.begin(), genus.end(), 0L), due.genus);
    if (due.error > 0) {
      EXPECT_NEAR(checked->result.report.volume, due.volume, due.error * due.volume);
    }
  }
}

// What leans has the volume of what stands (Cavalieri), and sections between come nearer to it.
TEST(ShapeSamples, SheetsThatLeanAreWholeBetweenSections) {
  std::vector<std::vector<Contour>> layers;
  for (int k = 0; k < 6; ++k) layers.push_back({box(-50, 2 * k, 50, 2 * k + 0.5)});
  const SectionStack stack = stack_of_boxes(layers);
  const double truth = 100 * 0.5 * 5;
  double before = 0;
  for (const std::size_t between : {0U, 1U, 3U}) {
    const auto checked = reconstruct_and_check(stack, {.between = between});
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->report.components, 1U);
    EXPECT_EQ(checked->result.report.sections_between, 5 * between);
    const double volume = checked->result.report.volume;
    EXPECT_GT(volume, before);
    EXPECT_NEAR(volume, truth, 0.03 * truth);
    before = volume;
  }
}

}  // namespace
}  // namespace tetloft::testing
