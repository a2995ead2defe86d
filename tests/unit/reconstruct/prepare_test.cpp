// Preparation: stacks in a unit of their own, and what conforming them yields.
#include "reconstruct/prepare.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Result<PreparedStack> prepared(const SectionStack& stack, Unit unit,
                               const ReconstructOptions& options = {}) {
  WatchedWork work(options.execution, stack.sections.size());
  return prepare(stack, unit, options, work);
}

SectionStack times(SectionStack stack, double factor) {
  for (Section& section : stack.sections) {
    section.z *= factor;
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) p = {p.x * factor, p.y * factor};
    }
  }
  return stack;
}

bool same_stack(const SectionStack& a, const SectionStack& b) {
  if (a.sections.size() != b.sections.size()) return false;
  for (const SectionId s : a.sections.ids()) {
    if (a.sections[s].z != b.sections[s].z) return false;
    if (a.sections[s].contours.size() != b.sections[s].contours.size()) return false;
    for (const ContourId c : a.sections[s].contours.ids()) {
      if (a.sections[s].contours[c].vertices != b.sections[s].contours[c].vertices) return false;
    }
  }
  return true;
}

TEST(Prepare, ScalesByThePowerOfTwoItNames) {
  for (const double unit : {1.0, 0x1p40, 0x1p-40, 0x1p-300}) {
    const SectionStack stack = times(generate(StackKind::small_grid, 3).stack, unit);
    const Result<PreparedStack> own = prepared(stack, Unit::of_the_stack);
    ASSERT_TRUE(own.ok());
    EXPECT_TRUE(same_stack(own->stack, times(stack, std::ldexp(1.0, own->exponent))));
    const Result<PreparedStack> given = prepared(stack, Unit::as_given);
    ASSERT_TRUE(given.ok());
    EXPECT_EQ(given->exponent, 0);
    EXPECT_TRUE(same_stack(given->stack, stack));
  }
}

TEST(Prepare, AStackTimesAPowerOfTwoIsTheSameInItsOwnUnit) {
  const SectionStack stack = generate(StackKind::small_grid, 4).stack;
  const Result<PreparedStack> a = prepared(stack, Unit::of_the_stack);
  const Result<PreparedStack> b = prepared(times(stack, 0x1p-60), Unit::of_the_stack);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_TRUE(same_stack(a->stack, b->stack));
  EXPECT_EQ(b->exponent, a->exponent + 60);
}

TEST(Prepare, EverySectionIsConformedAndAStepOfTheWork) {
  const SectionStack stack = generate(StackKind::checkerboard, 2).stack;
  std::atomic<std::size_t> steps = 0;
  ReconstructOptions options;
  options.execution.progress = [&](std::size_t, std::size_t) { ++steps; };
  const Result<PreparedStack> made = prepared(stack, Unit::as_given, options);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(steps, stack.sections.size());
  for (const SectionId s : stack.sections.ids()) {
    const ConformingSection alone =
        conform(stack.sections[s], s, {.divided = made->divisions[s]}).value();
    const ConformingSection& section = made->sections[s];
    ASSERT_EQ(section.vertex_count(), alone.vertex_count());
    EXPECT_EQ(section.z, stack.sections[s].z);
    EXPECT_EQ(section.internal, alone.internal);
    EXPECT_GT(section.vertex_count(), conform(stack.sections[s], s).value().vertex_count());
    EXPECT_EQ(made->nestings[s].outer, nest(stack.sections[s]).outer);
  }
}

// The edges of the region's contour on both sides of v: none has a vertex in its circle.
TEST(PreparedStack, ContoursRefinedToGabrielEdgesHaveNoVertexInTheirCircles) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 100, 100), box(48, 140, 52, 150)}});
  PreparedStack made = prepared(stack, Unit::as_given).value();
  const auto crowded = [&](ContourId of) {
    const ConformingSection& section = made.sections[SectionId(0)];
    std::size_t result = 0;
    for (const PlaneVertexId v : section.contour.ids()) {
      if (section.contour[v] != of) continue;
      const Point2 a = section.point(v);
      const Point2 b = section.point(section.next[v]);
      for (const PlaneVertexId w : section.contour.ids()) {
        const Point2 p = section.point(w);
        if ((p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < 0) ++result;
      }
    }
    return result;
  };
  EXPECT_GT(crowded(ContourId(0)), 0U);
  const std::size_t before = made.sections[SectionId(0)].vertex_count();
  ASSERT_FALSE(made.conform_section(SectionId(0),
                                    IdVector<ContourId, bool>(std::vector<bool>{true, false})));
  EXPECT_EQ(crowded(ContourId(0)), 0U);
  EXPECT_GT(made.sections[SectionId(0)].vertex_count(), before);
}

TEST(Prepare, InvalidStacksAreRefusedNamingTheSection) {
  SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1), box(0.5, 0.5, 2, 2)}});
  const Result<PreparedStack> refused = prepared(stack, Unit::of_the_stack);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.section, 1U);
}

}  // namespace
}  // namespace tetloft::testing
