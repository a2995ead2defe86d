// What users decide of voids: V4 and V5 of the rule, and what is refused.
#include "correspondence/asked_of_voids.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/slabs/cases.hpp"
#include "void_links_of.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

const Contour kOutline = box(-100, -100, 100, 100);

// Solid ends; between them two columns of holes 40 apart, contours 1 and 2 of sections 1 to 3.
SectionStack two_columns() {
  const std::vector<Contour> holes{kOutline, box(0, 0, 4, 4), box(40, 0, 44, 4)};
  SectionStack stack = stack_of_boxes({{kOutline}, holes, holes, holes, {kOutline}});
  for (Section& section : stack.sections) section.z *= 10;
  return stack;
}

CorrespondenceOptions asked(std::vector<Label> labels, std::vector<LinkDecision> decisions = {}) {
  CorrespondenceOptions options;
  options.voids.labels = std::move(labels);
  options.voids.decisions = std::move(decisions);
  return options;
}
CorrespondenceOptions decided(std::vector<LinkDecision> decisions) {
  return asked({}, std::move(decisions));
}

const ContourId kExteriorHole;

LinkDecision opened(std::size_t slab, ContourId lower, ContourId upper) {
  return {SlabId(slab), lower, upper, true};
}
LinkDecision closed(std::size_t slab, ContourId lower, ContourId upper) {
  return {SlabId(slab), lower, upper, false};
}

const VoidLink* link_in(const StackLinks& found, std::size_t slab, ContourId lower,
                        ContourId upper) {
  return find_link(found, SlabId(slab), lower, upper);
}

TEST(DecisionsOnVoids, OpenAndClose) {
  const SectionStack stack = two_columns();
  EXPECT_EQ(cavities_of(stack), 2U);
  const auto across = decided({opened(1, ContourId(1), ContourId(2))});
  EXPECT_EQ(cavities_of(stack, across), 1U);
  const StackLinks found = found_links(stack, across);
  const VoidLink* const link = link_in(found, 1, ContourId(1), ContourId(2));
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->evidence, Evidence::decision);
  EXPECT_EQ(link->fate, LinkFate::made);
  EXPECT_EQ(link->distance, 3.6);
  EXPECT_EQ(link->margin, 1);
  const auto parted = decided({closed(1, ContourId(1), ContourId(1))});
  EXPECT_EQ(cavities_of(stack, parted), 3U);
  EXPECT_EQ(link_in(found_links(stack, parted), 1, ContourId(1), ContourId(1))->fate,
            LinkFate::decided_part);
}

TEST(DecisionsOnVoids, OpenToTheOutsideAndCloseThat) {
  const SectionStack stack = two_columns();
  // Upwards into the solid end: the exterior is 56 away.
  const auto up = decided({opened(3, ContourId(2), kExteriorHole)});
  EXPECT_EQ(cavities_of(stack, up), 1U);
  const StackLinks found = found_links(stack, up);
  const VoidLink* const link = link_in(found, 3, ContourId(2), kExteriorHole);
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->distance, 5.6);
  EXPECT_EQ(link->ratio, 0);
  EXPECT_EQ(cavities_of(stack, decided({opened(1, kExteriorHole, ContourId(2))})), 1U);
  SectionStack open = stack;
  open.sections[SectionId(2)].contours = IdVector<ContourId, Contour>({box(-100, -100, 42, 100)});
  EXPECT_EQ(made(open), (Pairs3{{1, 2, kOutside}, {2, kOutside, 2}}));
  EXPECT_EQ(made(open, decided({closed(1, ContourId(2), kExteriorHole)})),
            (Pairs3{{2, kOutside, 2}}));
}

TEST(DecisionsOnVoids, ComeAfterRims) {
  // What is closed to the outside does not look for another void.
  CorrespondenceOptions options = decided({closed(0, ContourId(1), kExteriorHole)});
  options.voids.rule = VoidRule::near;
  options.voids.reach = 2;
  SectionStack stack =
      stack_of_boxes({{kOutline, box(0, 0, 4, 4)}, {box(-100, -100, 5, 100), box(-9, 0, -7, 4)}});
  stack.sections[SectionId(1)].z = 10;
  EXPECT_EQ(made(stack, options), (Pairs3{{0, 1, 1}}));  // the one above chose it
  options.voids.decisions.push_back(closed(0, ContourId(1), ContourId(1)));
  EXPECT_EQ(made(stack, options), Pairs3{});
}

std::string refusal(const SectionStack& stack, const CorrespondenceOptions& options,
                    ErrorCode code = ErrorCode::invalid_input) {
  const Result<StackLinks> found = find_links(stack, {options, {}});
  if (found) return "";
  EXPECT_EQ(found.error().code, code);
  const Result<Reconstruction> made = reconstruct(stack, {options});
  EXPECT_FALSE(made.ok());
  if (!made) {
    EXPECT_EQ(to_string(made.error()), to_string(found.error()));
  }
  return to_string(found.error());
}

void expect_refusal(const CorrespondenceOptions& options, const std::vector<std::string>& words,
                    ErrorCode code = ErrorCode::invalid_input) {
  const std::string text = refusal(two_columns(), options, code);
  EXPECT_NE(text, "") << words.front();
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << text << " without " << word;
  }
}

TEST(DecisionsOnVoids, ThatNameNoHoleOrContradictAreRefused) {
  const ContourId one(1);
  expect_refusal(decided({opened(1, ContourId(3), one)}), {"section 1", "contour 3", "exist"});
  expect_refusal(decided({opened(1, one, ContourId(3))}), {"section 2", "contour 3", "exist"});
  expect_refusal(decided({opened(1, ContourId(0), one)}), {"contour 0", "no hole"});
  expect_refusal(decided({closed(1, kExteriorHole, ContourId(0))}), {"section 2", "no hole"});
  expect_refusal(decided({opened(4, one, one)}), {"section 4", "none above"});
  expect_refusal(decided({opened(400, one, one)}), {"section"});
  expect_refusal(decided({opened(1, kExteriorHole, kExteriorHole)}), {"nothing to decide"});
  expect_refusal(decided({opened(1, one, one), closed(1, one, one)}),
                 {"section 1", "contour 1", "both joined", "parted from contour 1"});
  expect_refusal(decided({opened(1, one, kExteriorHole), closed(1, one, kExteriorHole)}),
                 {"contour 1", "parted from the outside"});
  EXPECT_EQ(refusal(two_columns(), decided({opened(1, one, one), opened(1, one, one)})), "");
}

TEST(DecisionsOnVoids, AreRefusedWithoutHolesAndWhereVoidsAreFree) {
  const SectionStack solid = stack_of_boxes({{kOutline}, {kOutline}});
  EXPECT_NE(refusal(solid, asked({{SectionId(0), ContourId(0), 1}})).find("no hole"),
            std::string::npos);
  CorrespondenceOptions options = asked({{SectionId(1), ContourId(1), 1}});
  options.voids.rule = VoidRule::free;
  expect_refusal(options, {"free"}, ErrorCode::usage);
  options = decided({opened(1, ContourId(1), ContourId(1))});
  options.voids.rule = VoidRule::free;
  expect_refusal(options, {"free"}, ErrorCode::usage);
}

TEST(LabelsOfHoles, UniteAndPart) {
  const SectionStack stack = two_columns();
  EXPECT_EQ(
      cavities_of(stack, asked({{SectionId(1), ContourId(1), 7}, {SectionId(2), ContourId(2), 7}})),
      1U);
  const auto parted = asked({{SectionId(1), ContourId(1), 7}, {SectionId(2), ContourId(1), 8}});
  EXPECT_EQ(cavities_of(stack, parted), 3U);
  EXPECT_EQ(link_in(found_links(stack, parted), 1, ContourId(1), ContourId(1))->fate,
            LinkFate::labels_part);
}

TEST(LabelsOfHoles, MayTakeTheWayThroughTheOutside) {
  // Holes of two sections with a solid one between: no other way.
  SectionStack stack = two_columns();
  stack.sections[SectionId(2)].contours.resize(1);
  const auto options = asked({{SectionId(1), ContourId(1), 7}, {SectionId(3), ContourId(2), 7}});
  const StackLinks found = found_links(stack, options);
  EXPECT_EQ(found.cavities, 2U);
  EXPECT_EQ(made(stack, options).size(), 2U);
  for (const VoidLink& link : found.void_links) {
    if (link.fate != LinkFate::made) continue;
    EXPECT_EQ(link.evidence, Evidence::label);
    EXPECT_NE(link.lower.valid(), link.upper.valid());
  }
}

TEST(LabelsOfHoles, CannotDivideTheOutside) {
  // Two holes that open to the outside, in different sections; the first takes it with its label.
  SectionStack stack = two_columns();
  stack.sections[SectionId(0)].contours[ContourId(0)] = box(-100, -100, -10, 100);
  stack.sections[SectionId(4)].contours[ContourId(0)] = box(-100, -100, -10, 100);
  const auto options = asked({{SectionId(1), ContourId(1), 1}, {SectionId(3), ContourId(2), 2}});
  const StackLinks found = found_links(stack, options);
  EXPECT_EQ(link_in(found, 0, kExteriorHole, ContourId(1))->fate, LinkFate::made);
  EXPECT_EQ(link_in(found, 3, ContourId(2), kExteriorHole)->fate, LinkFate::labels_part);
  // Nor can decisions: whichever section they are about.
  CorrespondenceOptions both = options;
  both.voids.decisions = {opened(0, kExteriorHole, ContourId(1)),
                          opened(3, ContourId(2), kExteriorHole)};
  const std::string text = refusal(stack, both);
  EXPECT_NE(text.find("section 3"), std::string::npos) << text;
  EXPECT_NE(text.find("the outside"), std::string::npos) << text;
}

TEST(LabelsOfHoles, ThatNameNoHoleOrContradictAreRefused) {
  const auto label = [](std::size_t section, ContourId contour, std::uint32_t value) {
    return Label{SectionId(section), contour, value};
  };
  expect_refusal(asked({label(1, ContourId(0), 1)}), {"section 1", "contour 0", "no hole"});
  expect_refusal(asked({label(1, ContourId(3), 1)}), {"section 1", "contour 3", "exist"});
  expect_refusal(asked({label(0, ContourId(1), 1)}), {"section 0", "contour 1", "exist"});
  expect_refusal(asked({label(5, ContourId(1), 1)}), {"section 5", "exist"});
  expect_refusal(asked({label(1, kExteriorHole, 1)}), {"section 1", "outside"});
  expect_refusal(asked({label(1, ContourId(1), 1), label(1, ContourId(1), 2)}),
                 {"section 1", "contour 1", "two labels"});
  EXPECT_EQ(refusal(two_columns(), asked({label(1, ContourId(1), 1), label(1, ContourId(1), 1)})),
            "");
}

TEST(LabelsOfHoles, ThatCannotBeRealisedAreRefused) {
  // Every link of the hole is closed.
  SectionStack stack = two_columns();
  auto options = asked({{SectionId(1), ContourId(1), 1}, {SectionId(1), ContourId(2), 1}});
  for (const ContourId other : {ContourId(1), ContourId(2), ContourId()}) {
    options.voids.decisions.push_back(closed(1, ContourId(2), other));
  }
  options.voids.decisions.push_back(closed(0, kExteriorHole, ContourId(2)));
  expect_refusal(options,
                 {"label 1", "no way through voids", "from section 1 contour 1 to section 1"},
                 ErrorCode::unrepresentable);
}

}  // namespace
}  // namespace tetloft::testing
