// The result is a function of the set of contours: not of threads, nor of the engine, nor of
// how contours are listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "core/prng.hpp"
#include "property/same_model.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr std::uint64_t kSeed = 500;

Result<Reconstruction> run(const GeneratedStack& generated, unsigned threads,
                           DelaunayEngine engine = DelaunayEngine::automatic) {
  ReconstructOptions options;
  options.correspondence = generated.correspondence;
  options.execution.threads = threads;
  options.delaunay = engine;
  return reconstruct(generated.stack, options);
}

TEST(Determinism, TheResultDoesNotDependOnThreads) {
  for (const StackKind kind : all_kinds()) {
    SCOPED_TRACE(name_of(kind));
    const GeneratedStack generated = generate(kind, kSeed);
    const auto one = run(generated, 1);
    for (const unsigned threads : {2U, 3U}) {
      const auto more = run(generated, threads);
      ASSERT_EQ(one.ok(), more.ok());
      if (!one.ok()) {
        EXPECT_EQ(to_string(one.error()), to_string(more.error()));
        continue;
      }
      EXPECT_TRUE(same_bits(one->model, more->model));
      EXPECT_EQ(one->partition, more->partition);
      EXPECT_EQ(one->report.rules, more->report.rules);
      EXPECT_EQ(one->report.smallest_lift, more->report.smallest_lift);
    }
  }
}

TEST(Determinism, TheResultDoesNotDependOnTheDelaunayEngine) {
  for (const StackKind kind : all_kinds()) {
    SCOPED_TRACE(name_of(kind));
    const GeneratedStack generated = generate(kind, kSeed);
    const auto slab = run(generated, 1, DelaunayEngine::slab);
    for (const unsigned threads : {1U, 2U, 3U}) {
      const auto incremental = run(generated, threads, DelaunayEngine::incremental);
      ASSERT_EQ(slab.ok(), incremental.ok());
      if (!slab.ok()) {
        EXPECT_EQ(to_string(slab.error()), to_string(incremental.error()));
        continue;
      }
      EXPECT_TRUE(same_bits(slab->model, incremental->model));
      EXPECT_EQ(slab->partition, incremental->partition);
      EXPECT_EQ(slab->report.rules, incremental->report.rules);
    }
  }
}

TEST(Determinism, PointsAndTetsDoNotDependOnOrderStartAndDirectionOfContours) {
  Prng prng(kSeed);
  std::size_t compared = 0;
  for (const StackKind kind : all_kinds()) {
    SCOPED_TRACE(name_of(kind));
    const GeneratedStack original = generate(kind, kSeed);
    GeneratedStack listed = original;
    for (std::size_t s = 0; s < listed.stack.sections.size(); ++s) {
      auto& contours = listed.stack.sections[SectionId(s)].contours;
      std::vector<std::size_t> order(contours.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      prng.shuffle(order);
      for (std::size_t c = 0; c < order.size(); ++c) {
        Contour contour = original.stack.sections[SectionId(s)].contours[ContourId(c)];
        auto& v = contour.vertices;
        std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(prng.below(v.size())),
                    v.end());
        if (prng.chance(0.5)) std::reverse(v.begin(), v.end());
        contours[ContourId(order[c])] = contour;
      }
      for (Label& label : listed.correspondence.labels) {
        if (label.section == SectionId(s)) label.contour = ContourId(order[label.contour.index()]);
      }
    }
    const auto before = run(original, 1);
    const auto after = run(listed, 1);
    ASSERT_EQ(before.ok(), after.ok());
    if (!before.ok()) continue;
    EXPECT_EQ(before->model.tets, after->model.tets);
    EXPECT_EQ(before->model.kind, after->model.kind);
    EXPECT_EQ(before->model.origin, after->model.origin);
    // Bit by bit: what may differ is left out.
    Model points_before;
    Model points_after;
    points_before.points = before->model.points;
    points_after.points = after->model.points;
    EXPECT_TRUE(same_bits(points_before, points_after));
    ++compared;
  }
  EXPECT_GT(compared, 15U);
}

}  // namespace
}  // namespace tetloft::testing
