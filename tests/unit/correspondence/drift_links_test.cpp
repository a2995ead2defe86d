// Drift: oblique tubes whose neighbouring sections do not overlap.
#include "correspondence/drift_links.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "correspondence/overlap_links.hpp"
#include "support/guarantee_oracle.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// The further candidates of slab k, as pairs of regions.
Pairs drifting(const SectionStack& stack, std::size_t k, double drift) {
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  IdVector<SlabId, std::vector<Link>> overlap;
  for (std::size_t s = 0; s + 1 < nestings.size(); ++s) {
    const SectionId low(s);
    const SectionId high(s + 1);
    overlap.push_back(overlap_links(SlabId(s), stack.sections[low], nestings[low],
                                    stack.sections[high], nestings[high], kDefaultOverlap));
  }
  Pairs pairs;
  for (const Link& link : drift_links(SlabId(k), stack, nestings, overlap, drift)) {
    EXPECT_EQ(link.slab, SlabId(k));
    pairs.emplace_back(link.lower.index(), link.upper.index());
  }
  return pairs;
}

Contour disc(double x, double y, int corners = 16) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    contour.vertices.push_back({x + std::cos(angle), y + std::sin(angle)});
  }
  return contour;
}

// Discs of radius 1 that move by 1.5, then more and more: the first two overlap only.
SectionStack leaning_tube() {
  SectionStack stack;
  double z = 0;
  for (const double x : {0.0, 1.5, 3.6, 5.8, 8.2}) {
    stack.sections.push_back({z, {}});
    stack.sections[SectionId(stack.sections.size() - 1)].contours.push_back(disc(x, x / 4));
    z += 1;
  }
  return stack;
}

SectionStack upside_down(SectionStack stack) {
  std::reverse(stack.sections.begin(), stack.sections.end());
  for (Section& section : stack.sections) section.z = -section.z;
  return stack;
}

ReconstructOptions with_drift(double drift) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.drift = drift;
  return options;
}

std::size_t components(const SectionStack& stack, const ReconstructOptions& options) {
  const auto checked = reconstruct_and_check(stack, options);
  return checked ? checked->result.model.component_count : 0;
}

// Three squares of side 4: one over the other, shifted by 2, then by `step`.
SectionStack squares(double step, double gap = 1) {
  SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4)}, {box(2, 0, 6, 4)}, {box(2 + step, 0, 6 + step, 4)}});
  stack.sections[SectionId(2)].z = 1 + gap;
  return stack;
}

TEST(DriftLinks, OnlyOverlapTellsADrift) {
  // From the third section on no region has a link that would tell how it moves.
  const SectionStack stack = leaning_tube();
  EXPECT_EQ(drifting(stack, 0, 0.3), Pairs{});
  EXPECT_EQ(drifting(stack, 1, 0.3), (Pairs{{0, 0}}));
  EXPECT_EQ(drifting(stack, 2, 0.3), Pairs{});
  EXPECT_EQ(drifting(stack, 3, 0.3), Pairs{});
  const SectionStack mirrored = upside_down(stack);
  EXPECT_EQ(drifting(mirrored, 2, 0.3), (Pairs{{0, 0}}));
  EXPECT_EQ(drifting(mirrored, 1, 0.3), Pairs{});
}

TEST(DriftLinks, ARatioOfExactlyDriftDoesNotUnite) {
  // Moved by 2 the middle square covers 1/4 of what lies at 5.
  const SectionStack stack = squares(5);
  EXPECT_EQ(drifting(stack, 1, 0.25), Pairs{});
  EXPECT_EQ(drifting(stack, 1, std::nextafter(0.25, 0.0)), (Pairs{{0, 0}}));
  EXPECT_EQ(drifting(squares(6), 1, 0), Pairs{});
}

TEST(DriftLinks, MoveInProportionToTheGaps) {
  EXPECT_EQ(drifting(squares(9, 1), 1, 0), Pairs{});
  EXPECT_EQ(drifting(squares(9, 4), 1, 0.7), (Pairs{{0, 0}}));
  EXPECT_EQ(drifting(squares(9, 8), 1, 0), Pairs{});
  EXPECT_EQ(drifting(upside_down(squares(9, 4)), 0, 0.7), (Pairs{{0, 0}}));
}

TEST(DriftLinks, RegionsOfTwoCandidatesDoNotDrift) {
  SectionStack stack = squares(5);
  stack.sections[SectionId(0)].contours.push_back(box(5, 0, 9, 4));
  EXPECT_EQ(drifting(stack, 1, 0), Pairs{});
}

TEST(DriftLinks, RegionsWithACandidateInTheSlabAreLeftAlone) {
  // What lies above is covered already: by a second region below.
  SectionStack stack = squares(5);
  stack.sections[SectionId(1)].contours.push_back(box(8, 0, 12, 4));
  EXPECT_EQ(drifting(stack, 1, 0), Pairs{});
}

TEST(DriftLinks, EitherSideMayTell) {
  // Down from the upper two alone; and both ways, which is one link.
  EXPECT_EQ(
      drifting(stack_of_boxes({{box(0, 0, 4, 4)}, {box(5, 0, 9, 4)}, {box(8, 0, 12, 4)}}), 0, 0.4),
      (Pairs{{0, 0}}));
  EXPECT_EQ(
      drifting(stack_of_boxes(
                   {{box(-3, 0, 1, 4)}, {box(0, 0, 4, 4)}, {box(4, 0, 8, 4)}, {box(7, 0, 11, 4)}}),
               1, 0.5),
      (Pairs{{0, 0}}));
}

TEST(DriftLinks, HolesMoveWithTheirRegions) {
  // The frame moved on surrounds the small square above without meeting it.
  const std::vector<Contour> low{box(0, 0, 8, 8), box(1, 1, 7, 7)};
  const std::vector<Contour> high{box(5, 0, 13, 8), box(6, 1, 12, 7)};
  EXPECT_EQ(drifting(stack_of_boxes({low, high, {box(13.5, 3, 15, 5)}}), 1, 0), Pairs{});
  EXPECT_EQ(drifting(stack_of_boxes({low, high, {box(13.5, 3, 17.5, 5)}}), 1, 0), (Pairs{{0, 0}}));
}

TEST(DriftLinks, OrderStartAndDirectionOfContoursDoNotMatter) {
  SectionStack stack = leaning_tube();
  for (Section& section : stack.sections) {
    section.contours.push_back(disc(-20, 0));
    section.contours.push_back(disc(-20 - section.z, 20, 7));
  }
  SectionStack other = stack;
  for (Section& section : other.sections) {
    auto& contours = section.contours.raw();
    std::rotate(contours.begin(), contours.begin() + 1, contours.end());
    for (Contour& contour : contours) {
      std::rotate(contour.vertices.begin(), contour.vertices.begin() + 3, contour.vertices.end());
      std::reverse(contour.vertices.begin(), contour.vertices.end());
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    // Regions are numbered independently of the order of contours.
    EXPECT_EQ(drifting(other, k, 0.3), drifting(stack, k, 0.3));
  }
}

TEST(DriftLinks, CoordinatesOfAnySizeDoNotFail) {
  for (const double s : {0x1p-1060, 0x1p-500, 0x1p990}) {
    SectionStack stack = squares(5);
    for (Section& section : stack.sections) {
      for (Contour& contour : section.contours) {
        for (Point2& p : contour.vertices) p = {s * p.x, s * p.y};
      }
    }
    EXPECT_EQ(drifting(stack, 1, 0.2), (Pairs{{0, 0}})) << s;
    EXPECT_EQ(drifting(stack, 1, 0.25), Pairs{}) << s;
  }
  // Moved beyond all doubles, or by a drift that swallows the region's own size.
  EXPECT_EQ(drifting(squares(9, 0x1p1010), 1, 0), Pairs{});
  EXPECT_EQ(drifting(squares(9, 0x1p100), 1, 0), Pairs{});
  SectionStack thin = squares(9, 0x1p1010);
  thin.sections[SectionId(1)].z = 0x1p-1060;
  EXPECT_EQ(drifting(thin, 1, 0), Pairs{});
  SectionStack swallowed = squares(9, 0x1p69);
  swallowed.sections[SectionId(2)].contours[ContourId(0)] = box(0x1p69, -0x1p70, 0x1p71, 0x1p70);
  EXPECT_EQ(drifting(swallowed, 1, 0), Pairs{});
}

TEST(Drift, UnitesATubeThatLeansMoreAndMore) {
  for (const SectionStack& stack : {leaning_tube(), upside_down(leaning_tube())}) {
    EXPECT_EQ(components(stack, {}), 4U);
    EXPECT_EQ(components(stack, with_drift(0.3)), 3U);
  }
}

TEST(Drift, UnitesASteadyTubeWithUnevenGaps) {
  // Pairs of sections that overlap, with wider gaps between them.
  SectionStack stack;
  for (const double z : {0.0, 1.0, 4.0, 5.0, 7.5}) {
    stack.sections.push_back({z, {}});
    stack.sections[SectionId(stack.sections.size() - 1)].contours.push_back(disc(1.5 * z, 0));
  }
  EXPECT_EQ(components(stack, {}), 3U);
  EXPECT_EQ(components(stack, with_drift(0.9)), 1U);
  EXPECT_EQ(components(upside_down(stack), with_drift(0.9)), 1U);
}

TEST(Drift, IsWhatCheckExpectsOnlyWhereItIsAskedFor) {
  const SectionStack stack = leaning_tube();
  const auto made = reconstruct(stack, with_drift(0.3));
  ASSERT_TRUE(made.ok());
  CheckOptions options;
  options.correspondence.drift = 0.3;
  EXPECT_TRUE(check(made->model, stack, options)->pass());
  const auto without = check(made->model, stack);
  ASSERT_TRUE(without.ok());
  for (const GuaranteeVerdict& verdict : without->guarantees) {
    EXPECT_EQ(verdict.pass, verdict.number != 4);
  }
}

TEST(Drift, IsWhatTheDefinitionSays) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const SectionStack stack = generate(StackKind::oblique, seed).stack;
    if (stack.vertex_count() > 60) continue;
    SCOPED_TRACE(seed);
    const auto made = reconstruct(stack, with_drift(0));
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    CheckOptions options;
    options.correspondence.drift = 0;
    const auto verdicts = oracle::guarantees(made->model, stack, options);
    EXPECT_TRUE(verdicts.holds[3].value_or(false)) << verdicts.reasons;
    ++compared;
  }
  EXPECT_GT(compared, 3U);
}

TEST(Drift, YieldsToLabels) {
  const SectionStack stack = squares(5);
  ReconstructOptions options = with_drift(0.1);
  EXPECT_EQ(components(stack, options), 1U);
  options.correspondence.labels = labels_from("0 0 1\n2 0 2");
  EXPECT_EQ(components(stack, options), 2U);
  options.correspondence.labels = labels_from("0 0 1\n2 0 1");
  EXPECT_EQ(components(stack, options), 1U);
}

TEST(Drift, BelongsToOverlapAndIsARatio) {
  const SectionStack stack = squares(5);
  const auto made = reconstruct(stack);
  ASSERT_TRUE(made.ok());
  const auto expect_usage = [&](const CorrespondenceOptions& correspondence) {
    ReconstructOptions options;
    options.correspondence = correspondence;
    const auto refused = reconstruct(stack, options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    CheckOptions check_options;
    check_options.correspondence = correspondence;
    const auto unchecked = check(made->model, stack, check_options);
    ASSERT_FALSE(unchecked.ok());
    EXPECT_EQ(unchecked.error().code, ErrorCode::usage);
  };
  CorrespondenceOptions correspondence;
  for (const double drift : {-0.1, 1.0, std::nan("")}) {
    correspondence.drift = drift;
    expect_usage(correspondence);
  }
  correspondence.drift = 0.3;
  correspondence.criterion = Criterion::reverse;
  expect_usage(correspondence);
}

}  // namespace
}  // namespace tetloft::testing
