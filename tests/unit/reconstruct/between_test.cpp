// The longer stack, of stacks made by hand: what is kept, what is put between, what is decided.
#include <tetloft/between.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include <tetloft/check.hpp>

#include "support/same_rows.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

bool same_contour(const Contour& a, const Contour& b) {
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    [](const Point2& p, const Point2& q) {
                      return test::same_number(p.x, q.x) && test::same_number(p.y, q.y);
                    });
}

bool same_section(const Section& a, const Section& b) {
  return test::same_number(a.z, b.z) && a.contours.size() == b.contours.size() &&
         std::equal(a.contours.begin(), a.contours.end(), b.contours.begin(), same_contour);
}

bool same_stack(const SectionStack& a, const SectionStack& b) {
  return a.sections.size() == b.sections.size() &&
         std::equal(a.sections.begin(), a.sections.end(), b.sections.begin(), same_section);
}

std::vector<SectionId> inserted_of(const LongStack& made) {
  std::vector<SectionId> inserted;
  for (const SectionId s : made.source.ids()) {
    if (made.source[s].inserted) inserted.push_back(s);
  }
  return inserted;
}

LongStack long_of(const SectionStack& stack, const BetweenOptions& options) {
  Result<LongStack> made = tetloft::between(stack, options);
  if (!made) ADD_FAILURE() << to_string(made.error());
  return made ? std::move(*made) : LongStack{};
}

// Reconstructed by its own correspondence it keeps what is promised.
CheckReport checked(const LongStack& made) {
  const CorrespondenceOptions& correspondence = made.correspondence;
  const auto solid = reconstruct(made.stack, {.correspondence = correspondence});
  if (!solid) ADD_FAILURE() << to_string(solid.error());
  if (!solid) return {};
  const auto report = check(solid->model, made.stack, {.correspondence = correspondence});
  if (!report) ADD_FAILURE() << to_string(report.error());
  if (!report) return {};
  EXPECT_TRUE(report->pass());
  EXPECT_EQ(report->components, made.components);
  return *report;
}

std::array<std::size_t, 2> joined_and_parted(const std::vector<LinkDecision>& decisions) {
  std::array<std::size_t, 2> counts{};
  for (const LinkDecision& decision : decisions) ++counts[decision.join ? 0 : 1];
  return counts;
}

// A frame with a square hole; solid without.
std::vector<Contour> block(bool with_hole) {
  std::vector<Contour> contours{box(-8, -8, 8, 8)};
  if (with_hole) contours.push_back(box(-3, -3, 3, 3));
  return contours;
}

TEST(LongStack, KeepsGivenSectionsBitForBit) {
  SectionStack stack = stack_of_boxes({{box(-0.0, 0, 4, 4), box(10, 0, 14, 4)},
                                       {box(11, 0, 15, 4), box(1, -0.0, 5, 4)},
                                       {box(2, 0, 6, 4)}});
  auto& backwards = stack.sections[SectionId(1)].contours[ContourId(0)].vertices;
  std::reverse(backwards.begin(), backwards.end());
  std::rotate(backwards.begin(), backwards.begin() + 1, backwards.end());
  const LongStack made = long_of(stack, {.sections = 3});
  ASSERT_EQ(made.stack.sections.size(), 9U);
  ASSERT_TRUE(validate(made.stack));
  for (std::size_t s = 0; s < 9; ++s) {
    const SectionSource& source = made.source[SectionId(s)];
    EXPECT_EQ(source.inserted, s % 4 != 0);
    if (source.inserted) {
      EXPECT_EQ(source.slab, SlabId(s / 4));
      EXPECT_FALSE(source.section.valid());
    } else {
      EXPECT_EQ(source.section, SectionId(s / 4));
      EXPECT_FALSE(source.slab.valid());
      EXPECT_TRUE(
          same_section(made.stack.sections[SectionId(s)], stack.sections[SectionId(s / 4)]));
    }
    // Section i lies at z = i: quarters are doubles.
    EXPECT_EQ(made.stack.sections[SectionId(s)].z, static_cast<double>(s) / 4);
  }
  EXPECT_EQ(checked(made).components, 2U);
}

TEST(LongStack, ContoursHaveTheComponentsOfTheShorterOne) {
  // The component of contour 0 of section 1 comes second.
  const SectionStack stack = stack_of_boxes({{box(0, 0, 4, 4)},
                                             {box(10, 0, 14, 4), box(1, 0, 5, 4)},
                                             {box(2, 0, 6, 4), box(11, 0, 15, 4)}});
  const auto shorter = reconstruct(stack, {.between = 1});
  ASSERT_TRUE(shorter.ok());
  const LongStack made = long_of(stack, {.sections = 1});
  EXPECT_EQ(made.components, 2U);
  ASSERT_EQ(inserted_of(made).size(), 2U);
  for (const SectionId s : made.source.ids()) {
    const SectionSource& source = made.source[s];
    const Section& section = made.stack.sections[s];
    ASSERT_EQ(made.component[s].size(), section.contours.size());
    if (!source.inserted) {
      EXPECT_EQ(made.component[s], shorter->partition[source.section]);
      continue;
    }
    for (const ContourId c : section.contours.ids()) {
      const bool right = section.contours[c].vertices.front().x > 8;
      EXPECT_EQ(made.component[s][c], ComponentId(right ? 1 : 0)) << s.index();
    }
  }
  checked(made);
}

TEST(LongStack, BranchesAsTheShorterOne) {
  const LongStack made = long_of(sample("cases/fork.cnt"), {.sections = 2});
  EXPECT_EQ(inserted_of(made).size(), 2U);
  EXPECT_EQ(made.components, 1U);
  EXPECT_EQ(made.correspondence.criterion, Criterion::overlap);
  EXPECT_FALSE(made.correspondence.chain || made.correspondence.lone);
  EXPECT_TRUE(made.correspondence.labels.empty());
  EXPECT_TRUE(
      std::is_sorted(made.correspondence.decisions.begin(), made.correspondence.decisions.end(),
                     [](const LinkDecision& a, const LinkDecision& b) { return a.slab < b.slab; }));
  std::set<SlabId> slabs;
  for (const LinkDecision& decision : made.correspondence.decisions) slabs.insert(decision.slab);
  EXPECT_EQ(slabs.size(), 3U);
  const CheckReport report = checked(made);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.genus, std::vector<long>{0});
}

TEST(LongStack, HasTheVoidsOfTheShorterOne) {
  const SectionStack stack = stack_of_boxes({block(false), block(true), block(true), block(false)});
  const LongStack made = long_of(stack, {.sections = 1});
  EXPECT_FALSE(inserted_of(made).empty());
  // Both of hole and exterior, with whichever inserted section: never open.
  for (const LinkDecision& decision : made.correspondence.voids.decisions) {
    EXPECT_EQ(decision.join, decision.lower.valid() && decision.upper.valid());
  }
  EXPECT_GE(joined_and_parted(made.correspondence.voids.decisions)[0], 2U);
  EXPECT_EQ(checked(made).cavities, 1U);
}

TEST(LongStack, KeepsWhatTheUserDecidedOfVoids) {
  const SectionStack stack = stack_of_boxes({block(false), block(true), block(true), block(false)});
  BetweenOptions options;
  options.sections = 1;
  options.correspondence.voids.decisions = {{SlabId(1), ContourId(1), ContourId(1), false}};
  const auto shorter = reconstruct(stack, {.correspondence = options.correspondence, .between = 1});
  ASSERT_TRUE(shorter.ok());
  const auto of_given = check(shorter->model, stack, {.correspondence = options.correspondence});
  ASSERT_TRUE(of_given.ok());
  EXPECT_EQ(of_given->cavities, 2U);
  EXPECT_EQ(checked(long_of(stack, options)).cavities, 2U);
}

TEST(LongStack, DecidesNothingOfFreeVoids) {
  const SectionStack stack = stack_of_boxes({block(false), block(true), block(true), block(false)});
  BetweenOptions options;
  options.sections = 1;
  options.correspondence.voids.rule = VoidRule::free;
  const LongStack made = long_of(stack, options);
  EXPECT_FALSE(inserted_of(made).empty());
  EXPECT_EQ(made.correspondence.voids.rule, VoidRule::free);
  EXPECT_TRUE(made.correspondence.voids.decisions.empty());
  checked(made);
}

TEST(LongStack, KeepsApartWhatLabelsPart) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(5, 0, 9, 4)}, {box(2, 0, 4, 4), box(4.5, 0, 9, 4)}});
  BetweenOptions options;
  options.sections = 2;
  options.correspondence.criterion = Criterion::overlap;
  // Contour 0 below belongs to contour 1 above, which it does not meet, and to nothing else.
  options.correspondence.labels = {{SectionId(0), ContourId(0), 1},
                                   {SectionId(0), ContourId(1), 2},
                                   {SectionId(1), ContourId(0), 3},
                                   {SectionId(1), ContourId(1), 2}};
  const LongStack made = long_of(stack, options);
  EXPECT_EQ(made.components, 3U);
  const auto [joined, parted] = joined_and_parted(made.correspondence.decisions);
  EXPECT_GE(joined, 1U);
  EXPECT_GE(parted, 1U);
  EXPECT_EQ(checked(made).components, 3U);
}

TEST(LongStack, JoinsWhatOnlyLabelsJoin) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(20, 0, 24, 4)}, {box(0, 0, 4, 4)}});
  BetweenOptions options;
  options.sections = 1;
  options.correspondence.labels = {{SectionId(0), ContourId(0), 1},
                                   {SectionId(0), ContourId(1), 1}};
  const LongStack made = long_of(stack, options);
  EXPECT_EQ(made.components, 1U);
  EXPECT_EQ(checked(made).components, 1U);
}

TEST(LongStack, WithNoneBetweenIsTheGivenOneDecided) {
  const SectionStack stack = sample("cases/ring.cnt");
  const LongStack made = long_of(stack, {.sections = 0});
  EXPECT_TRUE(same_stack(made.stack, stack));
  EXPECT_TRUE(inserted_of(made).empty());
  // A ring of regions has as many links.
  EXPECT_EQ(joined_and_parted(made.correspondence.decisions)[0], stack.contour_count());
  EXPECT_EQ(checked(made).genus, std::vector<long>{1});
}

// Squares that shrink, small as the lattice of the slab has no more steps for them.
TEST(LongStack, StaysAsGivenWhereGapsAreFarLargerThanWhatLiesInThem) {
  for (const double half : {1.0, 0.125, 0x1p-10}) {
    SectionStack stack;
    for (const double scale : {1.0, 0.75, 0.5}) {
      const double s = half * scale;
      Section section{16 * (4 - 4 * scale), {}};
      section.contours.push_back({{{87 - s, -s}, {87 + s, -s}, {87 + s, s}, {87 - s, s}}});
      stack.sections.push_back(section);
    }
    BetweenOptions options;
    const LongStack made = long_of(stack, options);
    for (const Section& section : made.stack.sections) {
      for (const Contour& contour : section.contours) {
        for (const Point2& p : contour.vertices) {
          EXPECT_LE(std::max(std::abs(p.x - 87), std::abs(p.y)), half) << half;
        }
      }
    }
    EXPECT_TRUE(half > 0.5 || same_stack(made.stack, stack)) << half;
  }
}

TEST(LongStack, ByItselfGetsNoneWhereSectionsAreTheSame) {
  EXPECT_TRUE(inserted_of(long_of(stack_of_boxes({block(true), block(true)}), {})).empty());
  // Half as far apart as an edge is long.
  SectionStack stack = stack_of_boxes({{box(0, 0, 2, 2)}, {box(1, 0, 3, 2)}});
  EXPECT_TRUE(inserted_of(long_of(stack, {})).empty());
  stack.sections[SectionId(1)].z = 12;
  EXPECT_EQ(inserted_of(long_of(stack, {})).size(), 3U);
}

TEST(LongStack, OfASingleSectionIsThatSection) {
  const SectionStack stack = stack_of_boxes({block(true)});
  const LongStack made = long_of(stack, {.sections = 2});
  EXPECT_TRUE(same_stack(made.stack, stack));
  EXPECT_EQ(made.components, 1U);
  EXPECT_TRUE(made.correspondence.decisions.empty());
  EXPECT_TRUE(made.warnings.empty());
}

TEST(LongStack, DependsOnNoThreadsAndNoOrderOfContours) {
  const SectionStack stack = sample("cases/ring.cnt");
  const LongStack made = long_of(stack, {.sections = 1, .execution = {.threads = 1}});
  const LongStack other = long_of(stack, {.sections = 1, .execution = {.threads = 3}});
  EXPECT_TRUE(same_stack(made.stack, other.stack));
  EXPECT_EQ(made.component, other.component);
  SectionStack turned = stack;
  for (Section& section : turned.sections) {
    std::reverse(section.contours.begin(), section.contours.end());
  }
  const LongStack of_turned = long_of(turned, {.sections = 1});
  ASSERT_EQ(of_turned.stack.sections.size(), made.stack.sections.size());
  ASSERT_FALSE(inserted_of(made).empty());
  for (const SectionId s : inserted_of(made)) {
    const Section& section = made.stack.sections[s];
    const Section& again = of_turned.stack.sections[s];
    ASSERT_EQ(section.contours.size(), again.contours.size());
    for (const Contour& contour : section.contours) {
      EXPECT_TRUE(std::any_of(again.contours.begin(), again.contours.end(),
                              [&](const Contour& c) { return same_contour(c, contour); }));
    }
  }
}

TEST(LongStack, GrowsAndShrinksWithTheGivenOne) {
  const SectionStack stack = sample("cases/fork.cnt");
  const LongStack made = long_of(stack, {.sections = 1});
  ASSERT_FALSE(inserted_of(made).empty());
  for (const double scale : {0x1p-600, 0x1p-3, 0x1p400}) {
    const auto times = [&](const SectionStack& given) {
      SectionStack result = given;
      for (Section& section : result.sections) {
        section.z *= scale;
        for (Contour& contour : section.contours) {
          for (Point2& p : contour.vertices) p = {p.x * scale, p.y * scale};
        }
      }
      return result;
    };
    EXPECT_TRUE(same_stack(long_of(times(stack), {.sections = 1}).stack, times(made.stack)));
  }
}

TEST(LongStack, RefusesWhatAReconstructionRefuses) {
  const SectionStack stack = sample("cases/fork.cnt");
  const auto code = [&](const SectionStack& given, const BetweenOptions& options) {
    const auto made = tetloft::between(given, options);
    EXPECT_FALSE(made.ok());
    return made.ok() ? ErrorCode::internal : made.error().code;
  };
  EXPECT_EQ(code(stack, {.sections = 65}), ErrorCode::usage);
  EXPECT_EQ(code(stack, {.work_limit = 0}), ErrorCode::usage);
  EXPECT_EQ(code({}, {}), ErrorCode::invalid_input);
  BetweenOptions options;
  options.correspondence.tau = 2;
  EXPECT_EQ(code(stack, options), ErrorCode::usage);
  options = {};
  options.correspondence.labels = {{SectionId(7), ContourId(0), 1}};
  EXPECT_EQ(code(stack, options), ErrorCode::invalid_input);
  std::stop_source stop;
  stop.request_stop();
  options = {};
  options.execution.stop = stop.get_token();
  EXPECT_EQ(code(stack, options), ErrorCode::cancelled);
}

}  // namespace
}  // namespace tetloft::testing
