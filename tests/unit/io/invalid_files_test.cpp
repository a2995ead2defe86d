// The collection of deliberately invalid stacks, where it is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include <tetloft/io.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

// Harmless slips, mended with one warning. Every other file is invalid.
const std::map<std::string, std::size_t> kMended{
    {"consecutive_dup", 1}, {"repeated_last", 1}, {"wrong_S_less", 1}, {"wrong_S_more", 1},
    {"wrong_v", 1},         {"huge_S", 1},        {"huge_v", 1}};

// Line named for the invalid ones: of the text that is wrong, or of the contour's brace.
const std::map<std::string, std::size_t> kLine{
    {"bowtie", 3},     {"self_cross", 3},    {"self_touch_vertex", 3}, {"self_touch_edge", 3},
    {"collinear", 3},  {"empty_contour", 3}, {"one_vertex", 3},        {"two_vertices", 3},
    {"spike", 3},      {"z_decreasing", 9},  {"z_equal", 9},           {"nan", 5},
    {"inf", 5},        {"text", 5},          {"odd_coords", 7},        {"no_header", 1},
    {"empty_file", 1}, {"negative_S", 1},    {"unclosed", 15}};

TEST(InvalidFiles, GetTheirRightAnswers) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "invalid";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no collection of invalid stacks";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cnt") continue;
    ++files;
    const std::string path = entry.path().string();
    const std::string name = entry.path().stem().string();
    const auto read = read_cnt(path);
    if (const auto mended = kMended.find(name); mended != kMended.end()) {
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      EXPECT_EQ(read->warnings.size(), mended->second) << name;
      EXPECT_TRUE(validate(read->stack).ok()) << name;
      continue;
    }
    ASSERT_FALSE(read.ok()) << name;
    const Error& error = read.error();
    EXPECT_EQ(error.code, ErrorCode::invalid_input) << name;
    EXPECT_EQ(error.where.file, path);
    ASSERT_TRUE(error.where.line.has_value()) << name;
    if (const auto line = kLine.find(name); line != kLine.end()) {
      EXPECT_EQ(*error.where.line, line->second) << name;
    }
    EXPECT_FALSE(error.message.empty()) << name;
  }
  EXPECT_GE(files, kMended.size() + kLine.size());
}

}  // namespace
}  // namespace tetloft
