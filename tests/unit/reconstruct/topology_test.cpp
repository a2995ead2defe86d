// What links imply is made, and where it cannot be that is told.
#include "reconstruct/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "property/same_model.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

long genus(const CheckReport& report) {
  return std::accumulate(report.genus.begin(), report.genus.end(), 0L);
}

// Faces that completion seals where contours are coarse.
TEST(Topology, SealedFacesAreOpened) {
  for (const auto& [name, due] :
       {std::pair{"bars", 1L}, {"slit_over_two", 0L}, {"two_over_two", 1L}}) {
    SCOPED_TRACE(name);
    const SectionStack stack = sample("cases/voids/" + std::string(name) + ".cnt");
    ReconstructOptions as_given;
    as_given.divide_coarse = false;
    const auto checked = reconstruct_and_check(stack, as_given);
    ASSERT_TRUE(checked);
    EXPECT_EQ(genus(checked->report), due);
    EXPECT_EQ(checked->report.deviations, 0U);
    EXPECT_GT(fired(checked->result, Rule::opened_face) + checked->result.report.split_vertices,
              0U);
    // By no rule for voids they stay as completion leaves them.
    ReconstructOptions free = as_given;
    free.correspondence.voids.rule = VoidRule::free;
    const auto sealed = reconstruct(stack, free);
    ASSERT_TRUE(sealed.ok());
    EXPECT_EQ(fired(*sealed, Rule::opened_face), 0U);
    EXPECT_FALSE(same_bits(sealed->model, checked->result.model));
  }
}

// Only once contours are divided two voids are taken for one; and the model says so.
TEST(Topology, VoidsThatNoWallCanPartAreOneAndReported) {
  ReconstructOptions options;
  options.correspondence.criterion = Criterion::overlap;
  options.correspondence.chain = options.correspondence.lone = false;
  const SectionStack stack = sample("cases/voids/rings_unlinked.cnt");
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  EXPECT_GT(fired(checked->result, Rule::gabriel_refinement), 0U);
  EXPECT_GT(fired(checked->result, Rule::united_voids), 0U);
  const auto& links = checked->result.model.void_links;
  EXPECT_GT(std::count_if(links.begin(), links.end(),
                          [](const VoidLink& link) { return link.fate == LinkFate::forced; }),
            0);
  EXPECT_GT(checked->report.forced_voids, 0U);
  CheckOptions strict;
  strict.correspondence = options.correspondence;
  strict.strict = true;
  const auto report = check(checked->result.model, stack, strict);
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->guarantees[4].pass);
}

// Deviations are told in order, and are such; strict checking refuses what is told and nothing
// else.
TEST(Topology, WhatIsToldIsTrue) {
  std::size_t strict_passes = 0, told = 0;
  for (const StackKind kind : kinds_with_voids()) {
    for (std::uint64_t seed = 21; seed < 26; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      const auto made = reconstruct(stack);
      ASSERT_TRUE(made.ok());
      const auto& deviations = made->model.deviations;
      for (const Deviation& d : deviations) {
        EXPECT_TRUE(d.got < d.least || d.got > d.most);
        EXPECT_LE(d.least, d.most);
      }
      EXPECT_TRUE(
          std::is_sorted(deviations.begin(), deviations.end(), [](const auto& a, const auto& b) {
            return std::tie(a.slab, a.upper, a.contour) < std::tie(b.slab, b.upper, b.contour);
          }));
      EXPECT_TRUE(
          std::is_sorted(made->model.void_links.begin(), made->model.void_links.end(),
                         [](const VoidLink& a, const VoidLink& b) { return a.slab < b.slab; }));
      CheckOptions options;
      options.strict = true;
      const auto strict = check(made->model, stack, options);
      ASSERT_TRUE(strict.ok());
      const bool clean =
          strict->deviations + strict->forced_voids + strict->unrealisable_voids == 0;
      EXPECT_EQ(strict->deviations, deviations.size());
      EXPECT_EQ(strict->pass(), clean);
      ++(clean ? strict_passes : told);
    }
  }
  EXPECT_GT(strict_passes, 30U);
  EXPECT_LT(told, 10U);
}

// A model that hides a deviation, or tells of one that is none, fails.
TEST(Topology, InventedDeviationsAreFound) {
  const SectionStack stack = sample("cases/voids/one_two.cnt");
  auto made = reconstruct(stack);
  ASSERT_TRUE(made.ok());
  made->model.deviations.push_back({SlabId(0), false, ContourId(0U), 0, 0, 1});
  const auto report = check(made->model, stack);
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->guarantees[4].pass);
}

}  // namespace
}  // namespace tetloft::testing
