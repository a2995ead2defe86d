// Samples reconstruct and pass check: those of the repository always, those of the shared
// folder where there is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> stacks_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".cnt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expect_passes(const fs::path& file) {
  SCOPED_TRACE(file.filename().string());
  const Result<ReadStack> read = read_cnt(file.string());
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(reconstruct_and_check(read->stack));
}

void expect_folder_passes(const std::string& folder, const std::vector<std::string>& without) {
  const std::vector<fs::path> files = stacks_in(fs::path(TETLOFT_SHARED_DATA_DIR) / folder);
  if (files.empty()) GTEST_SKIP() << "no shared data";
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    if (std::find(without.begin(), without.end(), name) == without.end()) expect_passes(file);
  }
}

TEST(Samples, OfTheRepositoryPass) {
  const std::vector<fs::path> files = stacks_in(TETLOFT_DATA_DIR);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) expect_passes(file);
}

TEST(Samples, SmallCasesOfTheRepositoryPass) {
  const std::vector<fs::path> files = stacks_in(fs::path(TETLOFT_DATA_DIR) / "cases");
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) expect_passes(file);
}

TEST(SharedData, CasesPass) { expect_folder_passes("cases", {}); }

// Without the one whose size is its point.
TEST(SharedData, SyntheticStacksPass) { expect_folder_passes("synth", {"contour20k"}); }

TEST(SharedData, SmallRealStacksPass) {
  bool any = false;
  for (const char* name :
       {"cgal_pipe_x20", "cgal_liver_l85_sm", "rt_tumorbed", "cgal_double-torus_x20", "em_d03sp12",
        "cgal_helmet_y20", "cgal_cow_x20", "aal_vermis_ms"}) {
    const fs::path file = fs::path(TETLOFT_SHARED_DATA_DIR) / "real" / (std::string(name) + ".cnt");
    if (!fs::exists(file)) continue;
    any = true;
    expect_passes(file);
  }
  if (!any) GTEST_SKIP() << "no shared data";
}

}  // namespace
}  // namespace tetloft::testing
