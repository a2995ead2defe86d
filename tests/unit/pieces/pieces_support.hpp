// Stacks and folders of the tests of pieces and streams.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <tetloft/reconstruct.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

class Folder {
 public:
  Folder()
      : path_(std::filesystem::path(::testing::TempDir()) /
              (std::string("tetloft_pieces_") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What is told of the whole is that of another run's.
inline void expect_same_figures(const ReconstructReport& made, const ReconstructReport& direct) {
  EXPECT_EQ(made.volume, direct.volume);
  EXPECT_EQ(made.vertices, direct.vertices);
  EXPECT_EQ(made.tets, direct.tets);
  EXPECT_EQ(made.components, direct.components);
  EXPECT_EQ(made.slices, direct.slices);
  EXPECT_EQ(made.input_vertices, direct.input_vertices);
  EXPECT_EQ(made.split_vertices, direct.split_vertices);
  EXPECT_EQ(made.sections_between, direct.sections_between);
}

struct StackToMend {
  SectionStack stack;
  ReconstructOptions options;
};

inline ReconstructOptions with_ends_between_and_label() {
  ReconstructOptions options;
  options.ends = Ends::half;
  options.between = 0;
  options.correspondence.labels = {{SectionId(3), ContourId(0), 5}};
  return options;
}

// Sections that are plates, '-', or those of cases/shielded.cnt in turn, 'x': each slab between two
// of these needs refined contours, so that its neighbours are built again.
inline StackToMend stack_of_mends(const std::string& kinds) {
  const SectionStack slab = sample("cases/shielded.cnt");
  const Section plate = stack_of_boxes({{box(-1000, 0, 200, 100)}}).sections[SectionId(0)];
  StackToMend made;
  made.options.divide_coarse = false;
  made.options.correspondence.criterion = Criterion::overlap;
  std::uint32_t body = 0;  // of the 'x' next to each other
  std::size_t first = 0;   // of these
  for (std::size_t s = 0; s < kinds.size(); ++s) {
    const bool shielded = kinds[s] == 'x';
    if (shielded && (s == 0 || kinds[s - 1] != 'x')) {
      first = s;
      ++body;
    }
    made.stack.sections.push_back(shielded ? slab.sections[SectionId((s - first) % 2)] : plate);
    made.stack.sections[SectionId(s)].z = static_cast<double>(s);
    if (!shielded) continue;
    auto& labels = made.options.correspondence.labels;
    labels.push_back({SectionId(s), ContourId(0), body});
    labels.push_back({SectionId(s), ContourId(1), static_cast<std::uint32_t>(100 + s)});
  }
  return made;
}

}  // namespace tetloft::testing
