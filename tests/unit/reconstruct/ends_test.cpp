// Where a model ends: first and last sections, single ones, empty ones, options out of range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

std::pair<double, double> extent_in_z(const Model& model) {
  const auto [low, high] =
      std::minmax_element(model.points.begin(), model.points.end(),
                          [](const Point3& a, const Point3& b) { return a.z < b.z; });
  return {low->z, high->z};
}

SectionStack column(const std::vector<double>& z) {
  std::vector<std::vector<Contour>> sections(z.size(), {box(0, 0, 4, 2)});
  SectionStack stack = stack_of_boxes(sections);
  for (std::size_t s = 0; s < z.size(); ++s) stack.sections[SectionId(s)].z = z[s];
  return stack;
}

TEST(Ends, FlatOnesLieInTheFirstAndLastSection) {
  const auto checked = reconstruct_and_check(column({1, 3, 7}));
  ASSERT_TRUE(checked);
  EXPECT_EQ(extent_in_z(checked->result.model), std::pair(1.0, 7.0));
  EXPECT_EQ(fired(checked->result, Rule::prism), 0U);
  EXPECT_NEAR(checked->report.volume, 8 * 6, 1e-9);
}

TEST(Ends, HalfOnesLieHalfAGapBeyond) {
  ReconstructOptions options;
  options.ends = Ends::half;
  const auto checked = reconstruct_and_check(column({1, 3, 7}), options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(extent_in_z(checked->result.model), std::pair(0.0, 9.0));
  EXPECT_EQ(fired(checked->result, Rule::prism), 2U);
  EXPECT_EQ(checked->result.model.component_count, 1U);
  EXPECT_NEAR(checked->report.volume, 8 * 9, 1e-9);
}

TEST(Ends, OfASingleSectionLieHalfTheThicknessOffItsPlane) {
  ReconstructOptions options;
  options.thickness = 3;
  const auto checked = reconstruct_and_check(column({10}), options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(extent_in_z(checked->result.model), std::pair(8.5, 11.5));
  EXPECT_TRUE(checked->result.warnings.empty());
  EXPECT_EQ(checked->result.model.component_count, 1U);
}

TEST(Ends, ASingleSectionWithoutThicknessGetsATenthOfItsLargerSideAndAWarning) {
  const auto checked = reconstruct_and_check(column({0}));
  ASSERT_TRUE(checked);
  const auto [low, high] = extent_in_z(checked->result.model);
  EXPECT_DOUBLE_EQ(high - low, 0.4);
  ASSERT_EQ(checked->result.warnings.size(), 1U);
  EXPECT_EQ(checked->result.warnings.front().where.section, 0U);
}

TEST(Ends, AnEmptySectionBetweenPartsTheModelMidway) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 4, 2)}, {}, {box(0, 0, 4, 2)}});
  const auto checked = reconstruct_and_check(stack);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->result.model.component_count, 2U);
  std::set<double> heights;
  for (const Point3& p : checked->result.model.points) heights.insert(p.z);
  EXPECT_EQ(heights, (std::set<double>{0, 0.5, 1.5, 2}));
}

TEST(Ends, EmptySectionsAtBothEndsAndInARowAreAccepted) {
  const auto checked = reconstruct_and_check(stack_of_boxes({{}, {}, {box(0, 0, 1, 1)}, {}}));
  ASSERT_TRUE(checked);
  EXPECT_EQ(extent_in_z(checked->result.model), std::pair(1.5, 2.5));
}

TEST(Ends, AStackOfEmptySectionsIsRefused) {
  for (const std::size_t sections : {std::size_t{1}, std::size_t{3}}) {
    for (const Ends ends : {Ends::flat, Ends::half}) {
      ReconstructOptions options;
      options.ends = ends;
      const auto result =
          reconstruct(stack_of_boxes(std::vector<std::vector<Contour>>(sections)), options);
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
    }
  }
}

TEST(Ends, AStackWithoutSectionsIsRefused) {
  const Result<Reconstruction> result = reconstruct(SectionStack{});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
}

TEST(Options, ThicknessMustBePositiveAndFinite) {
  for (const double thickness : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
    ReconstructOptions options;
    options.thickness = thickness;
    const Result<Reconstruction> result = reconstruct(column({0}), options);
    ASSERT_FALSE(result.ok()) << thickness;
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
}

TEST(Options, TauMustBeAtLeastZeroAndBelowOne) {
  for (const double tau : {-0.1, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    ReconstructOptions options;
    options.correspondence.tau = tau;
    const Result<Reconstruction> result = reconstruct(column({0, 1}), options);
    ASSERT_FALSE(result.ok()) << tau;
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
  ReconstructOptions options;
  options.correspondence.tau = 0;
  EXPECT_TRUE(reconstruct(column({0, 1}), options).ok());
}

TEST(Ends, ThicknessThatNoDoubleResolvesIsRefused) {
  ReconstructOptions options;
  options.thickness = 1e-3;
  const Result<Reconstruction> result = reconstruct(column({1e15}), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
}

TEST(Ends, SectionsWithoutADoubleBetweenThemAreRefused) {
  const Result<Reconstruction> result = reconstruct(column({1, std::nextafter(1.0, 2.0)}));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
  EXPECT_EQ(result.error().where.slab, 0U);
}

}  // namespace
}  // namespace tetloft::testing
