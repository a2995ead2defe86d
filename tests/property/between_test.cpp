// The longer stack of random stacks: what is given stays, what is put between is between, and
// reconstructed as a stack of its own it keeps all guarantees and is the same solid.
#include <tetloft/between.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
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

void expect_same_stack(const SectionStack& a, const SectionStack& b) {
  ASSERT_EQ(a.sections.size(), b.sections.size());
  for (const SectionId s : a.sections.ids()) {
    EXPECT_TRUE(same_contours(a.sections[s], b.sections[s])) << s.index();
  }
}

std::vector<Point3> sorted_points(const Model& model) {
  std::vector<Point3> points(model.points.begin(), model.points.end());
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  return points;
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

struct Tally {
  std::size_t stacks = 0, inserted = 0, same_points = 0, refused = 0;
};

void try_stack(const GeneratedStack& generated, std::size_t sections, Tally& tally) {
  ReconstructOptions options;
  options.correspondence = generated.correspondence;
  options.between = sections;
  const auto shorter = reconstruct(generated.stack, options);
  const auto made =
      between(generated.stack, {.correspondence = generated.correspondence, .sections = sections});
  ASSERT_EQ(made.ok(), shorter.ok());
  if (!made) {
    ++tally.refused;
    return;
  }
  ++tally.stacks;
  expect_given_kept(*made, generated.stack);
  const std::size_t inserted = made->stack.sections.size() - generated.stack.sections.size();
  EXPECT_EQ(inserted, shorter->report.sections_between);
  tally.inserted += inserted;
  EXPECT_EQ(made->components, shorter->model.component_count);
  for (const SectionId s : made->source.ids()) {
    if (made->source[s].inserted) continue;
    EXPECT_EQ(made->component[s], shorter->partition[made->source[s].section]);
  }

  const auto longer = reconstruct(made->stack, {.correspondence = made->correspondence});
  ASSERT_TRUE(longer.ok()) << to_string(longer.error());
  EXPECT_EQ(longer->model.component_count, shorter->model.component_count);
  EXPECT_TRUE(same_partition(made->component, longer->partition));
  const auto report =
      check(longer->model, made->stack, {.correspondence = made->correspondence});
  ASSERT_TRUE(report.ok());
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    EXPECT_TRUE(verdict.pass) << verdict.name
                              << (verdict.failures.empty() ? "" : verdict.failures[0].what);
  }
  const auto of_given =
      check(shorter->model, generated.stack, {.correspondence = generated.correspondence});
  ASSERT_TRUE(of_given.ok());
  EXPECT_EQ(report->cavities, of_given->cavities);
  if (longer->model.tets.size() == shorter->model.tets.size() &&
      sorted_points(longer->model) == sorted_points(shorter->model)) {
    ++tally.same_points;
  }

  // As a file, too.
  const auto read = parse_cnt(format_cnt(made->stack).value(), "long.cnt");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  expect_same_stack(read->stack, made->stack);
}

TEST(Between, OfRandomStacksIsAStackOfItsOwn) {
  Tally tally;
  for (const StackKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const GeneratedStack generated = generate(kind, seed);
      for (const std::size_t sections : {1U, 2U}) {
        SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed) + ", " +
                     std::to_string(sections) + " between");
        try_stack(generated, sections, tally);
      }
    }
  }
  std::printf("between: %zu stacks, %zu sections put between, %zu the same solid; %zu refused\n",
              tally.stacks, tally.inserted, tally.same_points, tally.refused);
}

}  // namespace
}  // namespace tetloft::testing
