// Coarse contours divided in whole reconstructions: volumes, what is told, and sections that cannot
// be divided.
#include "reconstruct/divide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>

#include "reconstruct/prepare.hpp"
#include "support/slabs/cases.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

ReconstructOptions as_given() {
  ReconstructOptions options;
  options.divide_coarse = false;
  return options;
}

std::size_t warned(const Reconstruction& made, const std::string& word) {
  std::size_t count = 0;
  for (const Warning& warning : made.warnings) {
    count += warning.message.find(word) != std::string::npos ? 1U : 0U;
  }
  return count;
}

// What a loft of many vertices has, within 6 %; as they are, by more than a tenth less.
TEST(DivideCoarse, ATurnedSquareIsNotGouged) {
  const SectionStack loft = sample("cases/loft.cnt");
  const auto made = reconstruct_and_check(loft, {});
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->result.report.volume, 1885, 0.06 * 1885);
  EXPECT_EQ(made->result.report.dividing_vertices, 24U);
  EXPECT_GE(made->result.report.split_vertices, 24U);
  EXPECT_EQ(made->result.report.input_vertices, 8U);
  EXPECT_TRUE(made->result.warnings.empty());
  const auto undivided = reconstruct_and_check(loft, as_given());
  ASSERT_TRUE(undivided);
  EXPECT_LT(undivided->result.report.volume, 1600);
  EXPECT_EQ(undivided->result.report.dividing_vertices, 0U);
}

TEST(DivideCoarse, AContourThatGoesStraightUpStaysAsItIs) {
  const auto made = reconstruct(stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 4, 2)}}));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.dividing_vertices, 0U);
  EXPECT_EQ(made->report.volume, 8);
}

TEST(DivideCoarse, ReverseTetrahedraAreThoseOfTheContoursAsTheyAre) {
  ReconstructOptions options;
  options.correspondence.criterion = Criterion::reverse;
  const auto made = reconstruct(sample("cases/loft.cnt"), options);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.dividing_vertices, 0U);
}

// Rings of coarse contours, more than the limit allows to divide.
TEST(DivideCoarse, TooManyVerticesAreToldAndTheSectionIsTakenAsItIs) {
  Layer rings;
  for (int k = 1; k <= 80; ++k) {
    rings.push_back(regular_polygon({0, 0}, k, 4, 0));
  }
  Layer square{regular_polygon({0, 0}, 100, 4, 0.3)};
  const auto made = reconstruct_and_check(stack_of({rings, square}, {0, 1}), {});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->result.report.dividing_vertices, 12U);  // of the square
  ASSERT_EQ(warned(made->result, "dividing"), 1U);
  for (const Warning& warning : made->result.warnings) {
    if (warning.message.find("dividing") == std::string::npos) continue;
    EXPECT_EQ(warning.where.section, 0U);
    EXPECT_NE(warning.message.find("vertices"), std::string::npos) << warning.message;
  }
}

// Contours a few ulps wide: points on two of their edges coincide once rounded.
TEST(DivideCoarse, WhereRoundingLeavesNoRoomTheSectionIsTakenAsItIs) {
  std::size_t cases = 0;
  for (std::uint64_t seed = 1; seed <= 200 && cases < 2; ++seed) {
    const GeneratedStack generated = generate(StackKind::few_ulps, seed);
    PreparedStack prepared;
    prepared.stack = generated.stack;
    std::vector<std::size_t> refused;
    for (const SectionId s : generated.stack.sections.ids()) {
      const SectionDivision division =
          divide_section(generated.stack.sections[s], prepared.neighbours(s), 0);
      if (!division.refused) continue;
      EXPECT_TRUE(division.edges.empty());
      EXPECT_NE(division.refused->find("rounding"), std::string::npos) << *division.refused;
      refused.push_back(s.index());
    }
    if (refused.empty()) continue;
    ++cases;
    const auto made = reconstruct_and_check(generated.stack, {});
    ASSERT_TRUE(made) << "seed " << seed;
    EXPECT_EQ(warned(made->result, "rounding"), refused.size()) << "seed " << seed;
  }
  EXPECT_GT(cases, 0U);
}

// Squares of which some slab, divided, has no room for a model; its sections alone go without.
TEST(DivideCoarse, WhereASlabIsRefusedItsSectionsAreTakenAsTheyAre) {
  const GeneratedStack generated = generate(StackKind::checkerboard, 107);
  const auto made = reconstruct_and_check(generated.stack, {.between = 0});
  ASSERT_TRUE(made);
  ASSERT_GT(generated.stack.sections.size(), 2U);
  ASSERT_EQ(warned(made->result, "dividing"), 2U);
  std::vector<std::size_t> sections;
  for (const Warning& warning : made->result.warnings) {
    if (warning.message.find("dividing") == std::string::npos) continue;
    EXPECT_NE(warning.message.find("room"), std::string::npos) << warning.message;
    sections.push_back(warning.where.section.value());
  }
  EXPECT_EQ(sections, (std::vector<std::size_t>{1, 2}));
  EXPECT_GT(made->result.report.dividing_vertices, 0U);
}

}  // namespace
}  // namespace tetloft::testing
