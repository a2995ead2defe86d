// Stacks from the shared data folder conform; skipped where there is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::testing {
namespace {

namespace fs = std::filesystem;

// The smaller stacks of a folder, in order of their names.
std::vector<fs::path> stacks_in(const std::string& folder, std::uintmax_t most_bytes) {
  std::vector<fs::path> result;
  std::error_code none;
  for (const auto& entry :
       fs::directory_iterator(fs::path(TETLOFT_SHARED_DATA_DIR) / folder, none)) {
    if (entry.path().extension() == ".cnt" && entry.file_size() <= most_bytes) {
      result.push_back(entry.path());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_conforming(const std::string& folder, std::uintmax_t most_bytes) {
  const std::vector<fs::path> files = stacks_in(folder, most_bytes);
  if (files.empty()) GTEST_SKIP() << "no shared data";
  for (const fs::path& file : files) {
    const Result<ReadStack> read = read_cnt(file.string());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    for (std::size_t s = 0; s < read->stack.sections.size(); ++s) {
      const Section& section = read->stack.sections[SectionId(s)];
      const Result<ConformingSection> conforming = conform(section, SectionId(s));
      ASSERT_TRUE(conforming.ok()) << file << ' ' << to_string(conforming.error());
    }
  }
}

TEST(SharedData, CasesConform) { expect_conforming("cases", 1 << 20); }
TEST(SharedData, SyntheticStacksConform) { expect_conforming("synth", 60 << 10); }
TEST(SharedData, RealStacksConform) { expect_conforming("real", 60 << 10); }

}  // namespace
}  // namespace tetloft::testing
