// The longer stack of random stacks: what is given stays, what is put between is between, and
// reconstructed as a stack of its own it keeps all guarantees and is the same solid.
#include <tetloft/between.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/io.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/sections.hpp>

#include "support/same_rows.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {
namespace {

constexpr std::uint64_t kSeeds = 3;
constexpr StackKind kKinds[] = {StackKind::lattice_marching_squares,
                                StackKind::nesting,
                                StackKind::branching_one_to_many,
                                StackKind::branching_many_to_many,
                                StackKind::holes,
                                StackKind::isolated_contours,
                                StackKind::empty_sections,
                                StackKind::scale_offset,
                                StackKind::u_over_blobs,
                                StackKind::oblique,
                                StackKind::random_labels,
                                StackKind::pores,
                                StackKind::channels,
                                StackKind::rings};

bool same_contours(const Section& a, const Section& b) {
  if (!test::same_number(a.z, b.z) || a.contours.size() != b.contours.size()) return false;
  for (const ContourId c : a.contours.ids()) {
    const std::vector<Point2>& p = a.contours[c].vertices;
    const std::vector<Point2>& q = b.contours[c].vertices;
    if (!std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const Point2& x, const Point2& y) {
          return test::same_number(x.x, y.x) && test::same_number(x.y, y.y);
        })) {
      return false;
    }
  }
  return true;
}

// The tets by the positions of their vertices, and those, whatever their numbers.
struct Solid {
  std::vector<Point3> points;
  std::vector<std::array<std::size_t, 4>> tets;
  friend bool operator==(const Solid&, const Solid&) = default;
};

Solid solid_of(const Model& model) {
  const auto less = [](const Point3& a, const Point3& b) { return canonical_less(a, b); };
  Solid solid;
  solid.points.assign(model.points.begin(), model.points.end());
  std::sort(solid.points.begin(), solid.points.end(), less);
  for (const TetVertices& tet : model.tets) {
    std::array<std::size_t, 4>& ranks = solid.tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at =
          std::lower_bound(solid.points.begin(), solid.points.end(), model.points[tet[i]], less);
      ranks[i] = static_cast<std::size_t>(at - solid.points.begin());
    }
    std::sort(ranks.begin(), ranks.end());
  }
  std::sort(solid.tets.begin(), solid.tets.end());
  return solid;
}

bool was_divided(const Reconstruction& made) { return made.report.dividing_vertices > 0; }

bool was_refined(const Reconstruction& made) {
  return made.report.rules[static_cast<std::size_t>(Rule::gabriel_refinement)] > 0;
}

// Given sections in order and bit for bit; inserted ones between those of their slabs.
void expect_given_kept(const LongStack& made, const SectionStack& given) {
  ASSERT_TRUE(validate(made.stack));
  ASSERT_EQ(made.source.size(), made.stack.sections.size());
  std::size_t next = 0;
  for (const SectionId s : made.source.ids()) {
    const SectionSource& source = made.source[s];
    if (source.inserted) {
      ASSERT_EQ(source.slab.index() + 1, next);
      EXPECT_FALSE(source.section.valid());
      continue;
    }
    ASSERT_EQ(source.section.index(), next++);
    EXPECT_FALSE(source.slab.valid());
    EXPECT_TRUE(same_contours(made.stack.sections[s], given.sections[source.section]));
  }
  EXPECT_EQ(next, given.sections.size());
}

// Numbers of either are one to one.
bool same_partition(const ContourPartition& a, const ContourPartition& b) {
  std::map<ComponentId, ComponentId> to, from;
  for (const SectionId s : a.ids()) {
    for (const ContourId c : a[s].ids()) {
      const ComponentId x = a[s][c];
      const ComponentId y = b[s][c];
      if (to.try_emplace(x, y).first->second != y) return false;
      if (from.try_emplace(y, x).first->second != x) return false;
    }
  }
  return true;
}

// What is asked of the shorter stack, another thing by each seed.
CorrespondenceOptions asked_of(const GeneratedStack& generated, std::uint64_t seed) {
  CorrespondenceOptions asked = generated.correspondence;
  constexpr Criterion kCriteria[] = {Criterion::moved, Criterion::overlap, Criterion::reverse};
  constexpr VoidRule kRules[] = {VoidRule::overlap, VoidRule::free, VoidRule::near};
  asked.criterion = kCriteria[seed % 3];
  if (asked.voids.labels.empty()) asked.voids.rule = kRules[seed % 3];
  return asked;
}

struct Tally {
  std::size_t stacks = 0, inserted = 0, voids = 0, same = 0, divided = 0;
};

void expect_guarantees(const Reconstruction& longer, const LongStack& made,
                       const Reconstruction& shorter, const SectionStack& given,
                       const CorrespondenceOptions& asked) {
  const auto report = check(longer.model, made.stack, {.correspondence = made.correspondence});
  ASSERT_TRUE(report.ok());
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    EXPECT_TRUE(verdict.pass) << verdict.name
                              << (verdict.failures.empty() ? "" : verdict.failures[0].what);
  }
  const auto of_given = check(shorter.model, given, {.correspondence = asked});
  ASSERT_TRUE(of_given.ok());
  EXPECT_TRUE(of_given->pass());
  EXPECT_EQ(report->components, of_given->components);
  EXPECT_EQ(report->cavities, of_given->cavities);
}

// As a file, too.
void expect_read_back(const SectionStack& stack) {
  const auto read = parse_cnt(format_cnt(stack).value(), "long.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->stack.sections.size(), stack.sections.size());
  for (const SectionId s : stack.sections.ids()) {
    EXPECT_TRUE(same_contours(read->stack.sections[s], stack.sections[s])) << s.index();
  }
}

void try_stack(const SectionStack& stack, const BetweenOptions& options, Tally& tally) {
  const CorrespondenceOptions& asked = options.correspondence;
  const auto shorter = reconstruct(stack, {.correspondence = asked,
                                           .between = options.sections,
                                           .divide_coarse = options.divide_coarse});
  const auto made = between(stack, options);
  ASSERT_EQ(made.ok(), shorter.ok());
  if (!made) {
    EXPECT_EQ(to_string(made.error()), to_string(shorter.error()));
    return;
  }
  expect_given_kept(*made, stack);
  const std::size_t inserted = made->stack.sections.size() - stack.sections.size();
  EXPECT_EQ(inserted, shorter->report.sections_between);
  EXPECT_EQ(made->components, shorter->model.component_count);
  for (const SectionId s : made->source.ids()) {
    if (made->source[s].inserted) continue;
    EXPECT_EQ(made->component[s], shorter->partition[made->source[s].section]);
  }

  const auto longer = reconstruct(made->stack, {.correspondence = made->correspondence,
                                                .between = 0,
                                                .divide_coarse = options.divide_coarse});
  ASSERT_TRUE(longer.ok()) << to_string(longer.error());
  EXPECT_EQ(longer->model.component_count, shorter->model.component_count);
  EXPECT_TRUE(same_partition(made->component, longer->partition));
  expect_guarantees(*longer, *made, *shorter, stack, asked);
  const bool same = solid_of(longer->model) == solid_of(shorter->model);
  const bool divided = was_divided(*shorter) || was_divided(*longer);
  EXPECT_TRUE(same || divided || was_refined(*shorter) || was_refined(*longer));
  expect_read_back(made->stack);
  ++tally.stacks;
  tally.inserted += inserted;
  tally.voids += made->correspondence.voids.decisions.size();
  if (same) ++tally.same;
  if (divided) ++tally.divided;
}

TEST(Between, OfRandomStacksIsAStackOfItsOwn) {
  Tally tally;
  for (const StackKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const GeneratedStack generated = generate(kind, seed);
      BetweenOptions options;
      options.correspondence = asked_of(generated, seed);
      for (const std::size_t sections : {1U, 2U}) {
        for (const bool divide : {false, true}) {
          SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed) + ", " +
                       std::to_string(sections) + " between" + (divide ? ", divided" : ""));
          options.sections = sections;
          options.divide_coarse = divide;
          try_stack(generated.stack, options, tally);
        }
      }
    }
  }
  std::printf(
      "between: %zu stacks, %zu sections put between, %zu decisions on voids; %zu the same solid, "
      "%zu divided\n",
      tally.stacks, tally.inserted, tally.voids, tally.same, tally.divided);
  EXPECT_GT(tally.stacks, 150U);
  EXPECT_GT(tally.inserted, 300U);
  EXPECT_GT(tally.voids, 100U);
  EXPECT_GT(tally.same, 120U);
  EXPECT_GT(tally.divided, 20U);
}

}  // namespace
}  // namespace tetloft::testing
