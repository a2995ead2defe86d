#include "support/stacks/shrink.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <tetloft/io.hpp>

namespace tetloft {
namespace {

using tetloft::testing::all_kinds;
using tetloft::testing::generate;
using tetloft::testing::GeneratedStack;
using tetloft::testing::name_of;
using tetloft::testing::shrink;
using tetloft::testing::StackKind;
using tetloft::testing::write_stack;

std::size_t large_contours(const SectionStack& stack) {
  std::size_t large = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) large += contour.vertices.size() >= 5 ? 1U : 0U;
  }
  return large;
}

TEST(Shrink, WhatFailsAlwaysEndsAsOneTriangle) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack least = shrink(generate(kind, 3).stack,
                                      [](const SectionStack& s) { return s.contour_count() > 0; });
    EXPECT_EQ(least.sections.size(), 1U) << name_of(kind);
    EXPECT_EQ(least.contour_count(), 1U) << name_of(kind);
    EXPECT_EQ(least.vertex_count(), 3U) << name_of(kind);
    EXPECT_TRUE(validate(least).ok()) << name_of(kind);
  }
}

TEST(Shrink, KeepsWhatTheFailureNeeds) {
  const SectionStack stack = generate(StackKind::stars_combs, 4).stack;
  const auto fails = [](const SectionStack& s) {
    return s.sections.size() >= 2 && large_contours(s) >= 2;
  };
  ASSERT_TRUE(fails(stack));
  const SectionStack least = shrink(stack, fails);
  EXPECT_TRUE(fails(least));
  EXPECT_EQ(least.sections.size(), 2U);
  EXPECT_EQ(least.vertex_count(), 10U);
}

TEST(Shrink, RoundsCoordinatesAndHeights) {
  const SectionStack stack = generate(StackKind::oblique, 2).stack;
  const SectionStack least =
      shrink(stack, [](const SectionStack& s) { return s.sections.size() >= 2; });
  EXPECT_EQ(least.sections[SectionId(0)].z, 0);
  EXPECT_EQ(least.sections[SectionId(1)].z, 1);
  for (const Section& section : least.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        EXPECT_EQ(p.x * 1024, static_cast<double>(static_cast<long>(p.x * 1024)));
      }
    }
  }
}

TEST(Shrink, LabelsFollowTheirContours) {
  const GeneratedStack generated = [] {
    for (std::uint64_t seed = 0;; ++seed) {
      GeneratedStack g = generate(StackKind::random_labels, seed);
      if (g.correspondence.labels.size() >= 3 && g.stack.contour_count() > 4) return g;
    }
  }();
  const Label wanted = generated.correspondence.labels.back();
  const std::size_t vertices =
      generated.stack.sections[wanted.section].contours[wanted.contour].vertices.size();
  // The vertices of the labelled contour tell whether the label is still on it.
  const auto fails = [&](const GeneratedStack& g) {
    for (const Label& label : g.correspondence.labels) {
      if (label.label != wanted.label) continue;
      const auto& contours = g.stack.sections[label.section].contours;
      if (contours[label.contour].vertices.size() == vertices) return true;
    }
    return false;
  };
  ASSERT_TRUE(fails(generated));
  const GeneratedStack least = shrink(generated, fails);
  EXPECT_TRUE(fails(least));
  EXPECT_EQ(least.stack.contour_count(), 1U);
  EXPECT_EQ(least.correspondence.labels.size(), 1U);
}

TEST(Shrink, StopsWhenItsTrialsAreUsedUp) {
  std::size_t calls = 0;
  const SectionStack stack = generate(StackKind::nesting, 1).stack;
  const auto fails = [&](const SectionStack& s) {
    ++calls;
    return s.contour_count() > 0;
  };
  const SectionStack less = shrink(stack, fails, {.trials = 5});
  EXPECT_EQ(calls, 5U);
  EXPECT_LT(less.contour_count(), stack.contour_count());
}

TEST(Shrink, WrittenStacksReadBackExactly) {
  const GeneratedStack generated = generate(StackKind::random_labels, 5);
  const std::string folder = ::testing::TempDir() + "tetloft_shrink_test";
  ASSERT_TRUE(write_stack(folder, "stack", generated).ok());
  const Result<ReadStack> read = read_cnt(folder + "/stack.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->stack.sections.size(), generated.stack.sections.size());
  for (std::size_t s = 0; s < read->stack.sections.size(); ++s) {
    const Section& a = generated.stack.sections[SectionId(s)];
    const Section& b = read->stack.sections[SectionId(s)];
    EXPECT_EQ(a.z, b.z);
    ASSERT_EQ(a.contours.size(), b.contours.size());
    for (std::size_t c = 0; c < a.contours.size(); ++c) {
      EXPECT_EQ(a.contours[ContourId(c)].vertices, b.contours[ContourId(c)].vertices);
    }
  }
  if (!generated.correspondence.labels.empty()) {
    const Result<Labels> labels = read_labels(folder + "/stack.labels");
    ASSERT_TRUE(labels.ok()) << to_string(labels.error());
    EXPECT_EQ(labels->labels.size(), generated.correspondence.labels.size());
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace tetloft
