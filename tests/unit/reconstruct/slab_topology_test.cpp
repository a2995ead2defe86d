// What links imply for the topology of a slab, against the rule word by word, in rationals.
#include "reconstruct/slab_topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "support/correspondence_oracle.hpp"
#include "support/slabs/cases.hpp"
#include "support/void_oracle.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// Plates with holes, some with islands, on a lattice: touches and coincident edges are common.
std::vector<Contour> random_plates(Prng& prng) {
  const auto at = [&](std::uint64_t below) { return static_cast<double>(prng.below(below)); };
  std::vector<Contour> contours;
  for (std::uint64_t plates = 1 + prng.below(2), k = 0; k < plates; ++k) {
    const double x = 14 * static_cast<double>(k) + at(3);
    const double y = at(3);
    contours.push_back(box(x, y, x + 10, y + 10));
    for (std::uint64_t hole = 0, holes = prng.below(3); hole < holes; ++hole) {
      const double hx = x + 1 + 4 * static_cast<double>(hole) + at(2);
      const double hy = y + 1 + at(4);
      const double size = 1 + at(3);
      contours.push_back(box(hx, hy, hx + size, hy + 1 + at(4)));
      if (prng.chance(0.2)) contours.push_back(box(hx + 0.25, hy + 0.25, hx + 0.5, hy + 0.5));
    }
  }
  return contours;
}

// The links of a slab from pairs of what both sections have in one sequence.
std::vector<Link> links_from(const std::set<oracle::RegionPair>& pairs, std::size_t lower_count) {
  std::vector<Link> links;
  for (const auto& [lower, upper] : pairs) {
    links.push_back({SlabId(0), RegionId(lower), RegionId(upper - lower_count)});
  }
  return links;
}

std::size_t holes_of(const Nesting& nesting) {
  return static_cast<std::size_t>(
      std::count_if(nesting.depth.begin(), nesting.depth.end(),
                    [](std::uint32_t depth) { return depth % 2 == 1; }));
}

TEST(SlabTopology, IsThatOfTheOracle) {
  std::size_t compared = 0, exact = 0, several = 0;
  std::map<long, std::size_t> met;
  for (std::uint64_t seed = 1; seed <= 260; ++seed) {
    SCOPED_TRACE(seed);
    Prng prng(seed);
    const SectionStack stack = stack_of_boxes({random_plates(prng), random_plates(prng)});
    if (!validate(stack)) continue;
    CorrespondenceOptions options;
    options.criterion = Criterion::overlap;
    const oracle::ExpectedSets solids = oracle::expected_sets({}, stack, options);
    const oracle::ExpectedTopology truth =
        oracle::expected_topology({}, stack, options.voids, solids.links);
    const ConformingSection lower = conform(stack.sections[SectionId(0)], SectionId(0)).value();
    const ConformingSection upper = conform(stack.sections[SectionId(1)], SectionId(1)).value();
    const sections::FaceOverlay overlay(stack.sections[SectionId(0)], lower.nesting,
                                        stack.sections[SectionId(1)], upper.nesting);
    const auto groups = expected_topology(overlay, lower, upper,
                                          {links_from(solids.links, lower.nesting.outer.size()),
                                           links_from(truth.links, 1 + holes_of(lower.nesting)),
                                           {}});
    std::int32_t least = 0, most = 0;
    for (const TopologyGroup& group : groups) {
      EXPECT_LE(group.least, group.most);
      EXPECT_TRUE(std::is_sorted(group.regions.begin(), group.regions.end()));
      least += group.least;
      most += group.most;
    }
    long sum = 0;
    for (const auto& [group, chi] : truth.chi[0]) sum += chi;
    EXPECT_TRUE(least <= sum && sum <= most) << sum << " in " << least << " to " << most;
    ++compared;
    // Where nothing touches, each group has one number: that of the oracle.
    if (!overlay.touching_voids().empty() ||
        std::any_of(overlay.meetings().begin(), overlay.meetings().end(),
                    [](const auto& m) { return m.touches != 0 || m.connections != 0; })) {
      continue;
    }
    ASSERT_EQ(groups.size(), truth.chi[0].size());
    for (const TopologyGroup& group : groups) {
      const auto of_oracle = truth.chi[0].find(group.regions.front().index());
      ASSERT_NE(of_oracle, truth.chi[0].end());
      EXPECT_EQ(group.least, of_oracle->second);
      EXPECT_EQ(group.most, of_oracle->second);
      ++met[of_oracle->second];
    }
    ++exact;
    several += groups.size() > 1 ? 1U : 0U;
  }
  EXPECT_GT(compared, 160U);
  EXPECT_GT(exact, 50U);
  EXPECT_GT(several, 12U);
  for (long chi = -1; chi <= 1; ++chi) EXPECT_GT(met[chi], 5U) << chi;
}

}  // namespace
}  // namespace tetloft::testing
