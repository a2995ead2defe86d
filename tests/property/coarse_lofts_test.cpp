// Lofts of contours of few vertices against the same with many: what lies between is nearly the
// same. Contours of many vertices, as from images, get none more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/repair.hpp>

#include "support/stacks/bitmap.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Reconstruction made(const SectionStack& stack, bool divide) {
  ReconstructOptions options;
  options.divide_coarse = divide;
  options.between = 0;
  auto result = reconstruct(stack, options);
  EXPECT_TRUE(result.ok()) << to_string(result.error());
  return result ? *std::move(result) : Reconstruction();
}

double typical(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() / 2];
}

TEST(CoarseLofts, HaveTheVolumeOfFineOnes) {
  std::vector<double> divided;
  std::vector<double> as_given;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const SectionStack stack = generate(StackKind::coarse_lofts, seed).stack;
    const Result<Refined> fine = refine(stack, 0.15);
    ASSERT_TRUE(fine.ok());
    const double truth = made(fine->stack, false).report.volume;
    const Reconstruction coarse = made(stack, true);
    const Result<CheckReport> checked = check(coarse.model, stack);
    ASSERT_TRUE(checked.ok() && checked->pass()) << "seed " << seed;
    divided.push_back(std::abs(coarse.report.volume - truth) / truth);
    as_given.push_back(std::abs(made(stack, false).report.volume - truth) / truth);
  }
  std::printf("error of volume in the middle: %.4f divided, %.4f as given\n", typical(divided),
              typical(as_given));
  EXPECT_LT(typical(divided), 0.05);
  EXPECT_LT(typical(divided), typical(as_given) / 2);
}

TEST(CoarseLofts, ContoursOfImagesStayAsTheyAre) {
  Prng prng(77);
  for (int round = 0; round < 20; ++round) {
    std::vector<Layer> layers;
    Bitmap bitmap = random_bitmap(prng, 40, 40, 0.5, 2);
    for (int s = 0; s < 4; ++s) {
      bitmap = flipped(prng, bitmap, 0.02);
      layers.push_back(round % 2 == 0 ? marching_squares(bitmap, round % 4 == 0)
                                      : staircase(without_diagonals(bitmap), round % 4 == 1));
    }
    const SectionStack stack = stack_of(layers, {0, 1, 2, 3});
    EXPECT_EQ(made(stack, true).report.dividing_vertices, 0U) << "round " << round;
  }
}

}  // namespace
}  // namespace tetloft::testing
