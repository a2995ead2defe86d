// The user's decisions on single links.
#include "correspondence/decisions.hpp"

#include <gtest/gtest.h>

#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

SectionStack two_pairs() {
  return stack_of_boxes(
      {{box(0, 0, 4, 4), box(20, 0, 24, 4)}, {box(0, 0, 4, 4), box(20, 0, 24, 4)}});
}

CorrespondenceOptions decided(std::vector<LinkDecision> decisions) {
  CorrespondenceOptions options;
  options.decisions = std::move(decisions);
  return options;
}

LinkDecision decision(std::size_t lower, std::size_t upper, bool join) {
  return {SlabId(0), ContourId(lower), ContourId(upper), join};
}

std::string refusal(const SectionStack& stack, const CorrespondenceOptions& options) {
  const Result<StackLinks> found = find_links(stack, {options, {}});
  if (found) return "";
  EXPECT_EQ(found.error().code, ErrorCode::invalid_input);
  return to_string(found.error());
}

TEST(Decisions, JoinAndPart) {
  const SectionStack stack = two_pairs();
  EXPECT_EQ(components_by(stack, {}), 2U);
  EXPECT_EQ(components_by(stack, decided({decision(0, 1, true)})), 1U);
  EXPECT_EQ(components_by(stack, decided({decision(0, 0, false)})), 3U);
  EXPECT_EQ(components_by(stack, decided({decision(0, 0, true), decision(1, 1, true)})), 2U);
  const auto parted = link_between(stack, 0, 0, 0, decided({decision(0, 0, false)}));
  ASSERT_TRUE(parted);
  EXPECT_EQ(parted->fate, LinkFate::decided_part);
  EXPECT_EQ(parted->evidence, Evidence::overlap);
  const auto joined = link_between(stack, 0, 0, 1, decided({decision(0, 1, true)}));
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->evidence, Evidence::decision);
  EXPECT_EQ(joined->margin, 1);
  EXPECT_EQ(joined->distance, 16);
}

TEST(Decisions, ComeAfterLoneRegionsChose) {
  // What is parted from its nearest does not look for another.
  SectionStack stack = stack_of_boxes({{box(0, 0, 4, 4), box(10, 0, 14, 4)}, {box(5, 0, 8, 4)}});
  stack.sections[SectionId(1)].z = 8;
  EXPECT_EQ(components_by(stack, decided({})), 1U);
  CorrespondenceOptions options = decided({decision(0, 0, false), decision(1, 0, false)});
  EXPECT_EQ(components_by(stack, options), 3U);
}

TEST(Decisions, OfContoursCountForTheirRegions) {
  SectionStack stack = two_pairs();
  stack.sections[SectionId(0)].contours.push_back(box(1, 1, 3, 3));
  EXPECT_EQ(components_by(stack, decided({decision(2, 1, true)})), 1U);
  EXPECT_NE(refusal(stack, decided({decision(2, 1, true), decision(0, 1, false)})), "");
}

TEST(Decisions, ThatNameNothingOrContradictAreRefused) {
  const SectionStack stack = two_pairs();
  EXPECT_NE(refusal(stack, decided({decision(2, 0, true)})).find("contour 2"), std::string::npos);
  EXPECT_NE(refusal(stack, decided({decision(0, 7, true)})).find("contour 7"), std::string::npos);
  EXPECT_NE(refusal(stack, decided({{SlabId(1), ContourId(0), ContourId(0), true}})), "");
  EXPECT_NE(refusal(stack, decided({decision(0, 0, true), decision(0, 0, false)})), "");
  EXPECT_EQ(refusal(stack, decided({decision(0, 0, true), decision(0, 0, true)})), "");
}

TEST(Decisions, ThatJoinDifferentLabelsAreRefused) {
  CorrespondenceOptions options = decided({decision(0, 1, true)});
  options.labels = labels_from("0 0 1\n1 1 2");
  EXPECT_NE(refusal(two_pairs(), options).find("labels, 1 and 2"), std::string::npos);
}

TEST(Decisions, PartedPairsAreNoWayForALabel) {
  // The label would take the pair itself; without it a way round.
  CorrespondenceOptions options = decided({decision(0, 0, false)});
  options.labels = labels_from("0 0 1\n1 0 1");
  const SectionStack stack = two_pairs();
  EXPECT_EQ(components_by(stack, options), 1U);
  const auto direct = link_between(stack, 0, 0, 0, options);
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->fate, LinkFate::decided_part);
  const auto round = link_between(stack, 0, 0, 1, options);
  ASSERT_TRUE(round);
  EXPECT_EQ(round->evidence, Evidence::label);
}

}  // namespace
}  // namespace tetloft::testing
