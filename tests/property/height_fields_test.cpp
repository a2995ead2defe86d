// Height fields from level lines, open at the frame, to solids: against the field itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/repair.hpp>

#include "support/stacks/height_fields.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// What of the field lies between its lowest and its highest level, and at least as high.
double volume_between(const HeightField& field, const SectionStack& stack) {
  constexpr int kSteps = 64;
  double sum = 0;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    const double low = stack.sections[SectionId(s)].z;
    const double step = (stack.sections[SectionId(s + 1)].z - low) / kSteps;
    for (int i = 0; i < kSteps; ++i) sum += step * area_above(field, low + (i + 0.5) * step);
  }
  return sum;
}

// Without any regard to what lies between: the areas at the levels, upper and lower ones.
double volume_of_steps(const HeightField& field, const SectionStack& stack, std::size_t upper) {
  double sum = 0;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    const double gap = stack.sections[SectionId(s + 1)].z - stack.sections[SectionId(s)].z;
    sum += gap * area_above(field, stack.sections[SectionId(s + upper)].z);
  }
  return sum;
}

TEST(HeightFields, BecomeSolidsOfTheirVolume) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; errors.size() < 60; ++seed) {
    Prng prng(seed);
    const HeightField field = random_field(prng);
    const LevelLines lines = level_lines(prng, field);
    FrameOptions options;
    options.corners = {Point2{0, 0}, Point2{field.width(), field.height_of_frame()}};
    const Result<ClosedOnFrame> closed = close_on_frame(lines.stack, lines.open, options);
    ASSERT_TRUE(closed.ok()) << to_string(closed.error());
    if (lines.open.empty() || !validate(closed->stack)) continue;
    const bool told =
        std::none_of(closed->changes.begin(), closed->changes.end(), [](const Warning& warning) {
          return warning.message.find("nothing tells") != std::string::npos;
        });
    if (!told) continue;
    const Result<Reconstruction> solid = reconstruct(closed->stack, {});
    ASSERT_TRUE(solid.ok()) << "seed " << seed << ": " << to_string(solid.error());
    const Result<CheckReport> checked = check(solid->model, closed->stack);
    ASSERT_TRUE(checked.ok() && checked->pass()) << "seed " << seed;
    const double truth = volume_between(field, closed->stack);
    EXPECT_LT(solid->report.volume, volume_of_steps(field, closed->stack, 0)) << "seed " << seed;
    errors.push_back(std::abs(solid->report.volume - truth) / truth);
  }
  std::sort(errors.begin(), errors.end());
  std::printf("error of volume: %.4f in the middle, %.4f of nine in ten\n",
              errors[errors.size() / 2], errors[errors.size() * 9 / 10]);
  EXPECT_LT(errors[errors.size() / 2], 0.05);
}

}  // namespace
}  // namespace tetloft::testing
