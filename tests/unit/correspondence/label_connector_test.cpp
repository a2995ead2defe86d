// Labels: what they reunite, what they part, and what is refused.
#include "correspondence/label_connector.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <tuple>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Result<Reconstruction> reconstruct_labelled(const SectionStack& stack, std::string_view labels) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.labels = labels_from(labels);
  return reconstruct(stack, options);
}

void expect_components(const SectionStack& stack, std::string_view labels, std::size_t count) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.labels = labels_from(labels);
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->result.model.component_count, count);
}

TEST(Labels, SameLabelReunitesWhatDriftedApart) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(3, 0, 4, 1)}});
  expect_components(stack, "", 2);
  expect_components(stack, "0 0 5\n1 0 5", 1);
}

TEST(Labels, SameLabelIsNotLinkedAgainWhereAnotherSlabUnites) {
  // Far apart in the lower section, joined by the upper one.
  const SectionStack joined =
      stack_of_boxes({{box(0, 0, 1, 1), box(5, 0, 6, 1)}, {box(0, 0, 6, 1)}});
  expect_components(joined, "0 0 1\n0 1 1", 1);
}

TEST(Labels, FewestNewLinksReunite) {
  // Two columns: one link across between them rather than two over the region in the middle.
  const std::vector<Contour> both{box(0, 0, 1, 1), box(5, 0, 6, 1)};
  const std::vector<Contour> middle{box(2.5, 0, 3.5, 1)};
  const SectionStack columns = stack_of_boxes({both, both, middle});
  expect_components(columns, "", 3);
  expect_components(columns, "0 0 1\n0 1 1", 2);
  // Without a section to cross to, the unlabelled region in the middle it is.
  const SectionStack feet = stack_of_boxes({both, middle});
  expect_components(feet, "", 3);
  expect_components(feet, "0 0 1\n0 1 1", 1);
}

TEST(Labels, DifferentLabelsKeepOverlappingRegionsApart) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 2, 2)}, {box(0, 0, 2, 2)}});
  expect_components(stack, "", 1);
  expect_components(stack, "0 0 1\n1 0 2", 2);
}

TEST(Labels, DifferentLabelsPartAChainOfUnlabelledRegionsAtItsWeakestLink) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 4, 2)}, {box(3, 0, 7, 2)}});
  ReconstructOptions options;
  options.correspondence.labels = labels_from("0 0 1\n2 0 2");
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  const ContourPartition& partition = checked->result.partition;
  EXPECT_EQ(partition[SectionId(0)], partition[SectionId(1)]);
  EXPECT_NE(partition[SectionId(1)], partition[SectionId(2)]);
}

TEST(Labels, ThatContradictEachOtherInARegionAreRefused) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 9, 9), box(2, 2, 7, 7)}});
  const Result<Reconstruction> result = reconstruct_labelled(stack, "1 0 4\n1 1 5");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(result.error().where.section, 1U);
  EXPECT_EQ(result.error().where.contour, 1U);
  EXPECT_TRUE(reconstruct_labelled(stack, "1 0 4\n1 1 4").ok());
}

TEST(Labels, OfContoursThatDoNotExistAreRefused) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  for (const auto& [labels, section, contour] :
       {std::tuple("0 1 7", 0U, 1U), std::tuple("2 0 7", 2U, 0U)}) {
    const Result<Reconstruction> result = reconstruct_labelled(stack, labels);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(result.error().where.section, section);
    EXPECT_EQ(result.error().where.contour, contour);
  }
}

TEST(Labels, ThatCannotBeRealisedAreRefusedNamingContours) {
  // Two regions of one label with all that lies between them of another.
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  const Result<Reconstruction> result = reconstruct_labelled(stack, "0 0 1\n1 0 2\n2 0 1");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
  EXPECT_NE(result.error().message.find("section 0 contour 0"), std::string::npos);
  EXPECT_NE(result.error().message.find("section 2 contour 0"), std::string::npos);
  EXPECT_EQ(result.error().where.section, 2U);
}

}  // namespace
}  // namespace tetloft::testing
