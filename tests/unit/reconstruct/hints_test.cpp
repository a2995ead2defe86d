// Hints: told where a stack shows signs of needing a remedy, not of sound stacks.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/links.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/repair.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr double kTurn = 6.283185307179586;

Contour polygon(std::size_t n, double x, double radius, double turned = 0) {
  Contour contour;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = kTurn * (static_cast<double>(i) + turned) / static_cast<double>(n);
    contour.vertices.push_back({x + radius * std::cos(angle), radius * std::sin(angle)});
  }
  return contour;
}

std::vector<Warning> warnings_of(const SectionStack& stack, bool divide_coarse = true) {
  const Result<Reconstruction> made =
      reconstruct(stack, {.between = 0, .divide_coarse = divide_coarse});
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  return made ? made->warnings : std::vector<Warning>();
}

std::size_t telling(const std::vector<Warning>& warnings, const std::string& word) {
  std::size_t count = 0;
  for (const Warning& warning : warnings) {
    count += warning.message.find(word) != std::string::npos ? 1U : 0U;
  }
  return count;
}

SectionStack times(SectionStack stack, double factor) {
  for (Section& section : stack.sections) {
    section.z *= factor;
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) p = {factor * p.x, factor * p.y};
    }
  }
  return stack;
}

TEST(Hints, AreNotGivenOfSoundStacks) {
  for (const char* name : {"bifurcation.cnt", "bunny.cnt", "tooth.cnt", "torus.cnt",
                           "cases/triangular_prism.cnt", "figures/fig18_drifting.cnt"}) {
    EXPECT_TRUE(warnings_of(sample(name)).empty()) << name;
  }
  EXPECT_TRUE(warnings_of(stack_of_boxes({{box(0, 0, 2, 2)}, {box(0, 0, 2, 2)}})).empty());
}

TEST(Hints, NameALengthForCoarseContours) {
  const SectionStack turned = stack_of_boxes({{polygon(4, 0, 10)}, {polygon(4, 0, 10, 0.5)}});
  EXPECT_TRUE(warnings_of(turned).empty());  // they are divided
  const auto warnings = warnings_of(turned, false);
  ASSERT_EQ(warnings.size(), 1U);
  // An eighth of the side of 14.14.
  EXPECT_NE(warnings[0].message.find("at most 1.8 (--refine)"), std::string::npos)
      << warnings[0].message;
  const Result<Refined> refined = refine(turned, 1.8);
  ASSERT_TRUE(refined.ok());
  EXPECT_TRUE(warnings_of(refined->stack, false).empty());
  // In the unit of the stack.
  EXPECT_NE(warnings_of(times(turned, 0x1p10), false)[0].message.find("at most 1.8e+03 "),
            std::string::npos);
}

TEST(Hints, OfCoarseContoursAreNotGivenWhereNothingIsLost) {
  // More vertices; the same contours; edges that lie on those of the neighbour; no link.
  for (const SectionStack& stack :
       {stack_of_boxes({{polygon(16, 0, 10)}, {polygon(16, 3, 10, 0.5)}}),
        stack_of_boxes({{polygon(5, 0, 10)}, {polygon(5, 0, 10)}, {}}),
        stack_of_boxes({{box(0, 0, 2, 8)}, {box(0, 0, 2, 7.9)}}),
        stack_of_boxes({{box(0, 0, 2, 2)}, {box(50, 0, 52, 2)}})}) {
    EXPECT_EQ(telling(warnings_of(stack, false), "--refine"), 0U);
  }
}

TEST(Hints, TellThatMostRegionsHaveNoPartner) {
  const SectionStack apart = stack_of_boxes(
      {{box(0, 0, 2, 2), box(20, 0, 22, 2)}, {box(6, 0, 8, 2), box(14, 0, 16, 2)}, {}});
  const auto warnings = warnings_of(apart);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].message.find("4 of 4 regions meet none"), std::string::npos)
      << warnings[0].message;
  EXPECT_NE(warnings[0].message.find("the gap, 1, over the size of a region, 2, is 0.5;"),
            std::string::npos)
      << warnings[0].message;
  const Result<StackLinks> links = find_links(apart);
  ASSERT_TRUE(links.ok());
  ASSERT_EQ(links->warnings.size(), 1U);
  EXPECT_EQ(links->warnings[0].message, warnings[0].message);
  // A region beside empty sections alone misses nothing; half of the regions are not most.
  EXPECT_TRUE(
      find_links(stack_of_boxes({{box(0, 0, 2, 2)}, {}, {box(50, 0, 52, 2)}}))->warnings.empty());
  EXPECT_TRUE(find_links(stack_of_boxes({{box(0, 0, 2, 2), box(20, 0, 22, 2)},
                                         {box(0, 0, 2, 2), box(50, 0, 52, 2)}}))
                  ->warnings.empty());
}

TEST(Hints, TellOfManyTetsWhereSnappingHelps) {
  const SectionStack round = stack_of_boxes(
      {{polygon(6, 0, 10)}, {polygon(200, 0, 10)}, {polygon(200, 0.1, 10)}, {polygon(200, 5, 1)}});
  const auto warnings = warnings_of(round);
  ASSERT_EQ(telling(warnings, "--snap"), 1U);
  for (const Warning& warning : warnings) {
    if (warning.message.find("--snap") != std::string::npos) {
      EXPECT_EQ(warning.where.slab, 1U);
    }
  }
  const Result<Snapped> snapped = snap(round, 12);
  ASSERT_TRUE(snapped.ok());
  EXPECT_EQ(telling(warnings_of(snapped->stack), "--snap"), 0U);
}

}  // namespace
}  // namespace tetloft::testing
