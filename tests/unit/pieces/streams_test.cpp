// Stacks streamed into files: the bytes of the single run, and what it tells.
#include <tetloft/pieces.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "support/slabs/cases.hpp"
#include "support/stacks/generate.hpp"
#include "support/stacks/shapes.hpp"
#include "unit/pieces/pieces_support.hpp"

namespace tetloft::testing {
namespace {

// A random stack over itself, four times.
SectionStack tall_stack(StackKind kind, std::uint64_t seed) {
  const SectionStack once = generate(kind, seed).stack;
  SectionStack stack;
  for (int k = 0; k < 4; ++k) {
    for (Section section : once.sections) {
      section.z = static_cast<double>(stack.sections.size());
      stack.sections.push_back(std::move(section));
    }
  }
  return stack;
}

std::vector<std::string> sorted_texts(const std::vector<Warning>& warnings) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings) texts.push_back(to_string(warning));
  std::sort(texts.begin(), texts.end());
  return texts;
}

void expect_streamed(const SectionStack& stack, const ReconstructOptions& options,
                     const std::vector<unsigned>& thread_counts = {1, 3}) {
  const Folder folder;
  const auto direct = reconstruct(stack, options);
  for (const unsigned threads : thread_counts) {
    ReconstructOptions with = options;
    with.execution.threads = threads;
    const auto made = write_streamed(folder / "streamed.vtu", stack, with);
    ASSERT_EQ(made.ok(), direct.ok());
    if (!direct) {
      EXPECT_EQ(made.error().code, direct.error().code);
      EXPECT_EQ(made.error().message, direct.error().message);
      EXPECT_FALSE(std::filesystem::exists(folder / "streamed.vtu"));
      continue;
    }
    EXPECT_EQ(bytes_of(folder / "streamed.vtu"), *format_vtu(direct->model));
    EXPECT_EQ(sorted_texts(made->warnings), sorted_texts(direct->warnings));
    expect_same_figures(made->report, direct->report);
    EXPECT_EQ(made->report.contours, direct->report.contours);
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
    EXPECT_EQ(entry.path().filename(), "streamed.vtu");
    ++files;
  }
  EXPECT_LE(files, 1U);
}

TEST(Streams, AreTheFileOfTheSingleRun) {
  expect_streamed(sample("torus.cnt"), {});
  expect_streamed(sample("torus.cnt"), with_ends_between_and_label());
  expect_streamed(stack_of_boxes({{box(0, 0, 4, 2)}}), {});
  expect_streamed({}, {});
  SectionStack elsewhere = sample("torus.cnt");
  elsewhere.frame.origin = {1, 2, 3};
  expect_streamed(elsewhere, {});
}

// Mended slabs in all places of windows, chains longer than a window.
TEST(Streams, GoBackWhereMendingReachesBelow) {
  for (std::size_t before = 0; before < 9; ++before) {
    for (const std::size_t chain : {1U, 2U, 12U}) {
      const StackToMend mended = stack_of_mends(std::string(before, '-') +
                                                std::string(chain + 1, 'x') + std::string(5, '-'));
      expect_streamed(mended.stack, mended.options);
    }
  }
}

TEST(Streams, OfRandomStacksAreTheFileOfTheSingleRun) {
  constexpr std::uint64_t kSeed = 25;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind) || has_large_triangulations(kind)) continue;
    SCOPED_TRACE(std::string(name_of(kind)) + ", seed " + std::to_string(kSeed));
    expect_streamed(tall_stack(kind, kSeed), {}, {2});
  }
}

// Rings of coarse contours that are too many to be divided, in the section of two windows.
TEST(Streams, TellOnceWhatTwoWindowsFindOut) {
  Layer rings;
  for (int k = 1; k <= 80; ++k) rings.push_back(regular_polygon({0, 0}, k, 4, 0));
  std::vector<Layer> layers(9, Layer{regular_polygon({0, 0}, 100, 4, 0.3)});
  layers[4] = rings;
  const SectionStack stack = stack_of(layers, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  ASSERT_FALSE(reconstruct(stack)->warnings.empty());
  expect_streamed(stack, {}, {1});
}

TEST(Streams, AreVtuAlone) {
  const Folder folder;
  const auto made = write_streamed(folder / "streamed.vtk", sample("torus.cnt"));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace tetloft::testing
