// The Euler characteristics and voids that follow from links, by the rule of voids.hpp as check
// recomputes it, case by case; and the whole rule against rationals on random stacks of plates with
// holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "check/expected_topology.hpp"
#include "check/partition.hpp"
#include "check/void_links.hpp"
#include "core/prng.hpp"
#include "support/correspondence_oracle.hpp"
#include "support/void_oracle.hpp"
#include "unit/check/rule_stacks.hpp"

namespace tetloft {

using namespace internal;
namespace {

using checking::Link;
using checking::StackVoids;
using testing::box;
using testing::plate;
using testing::stack_of;

constexpr ContourId kOutside;

// chi of each group of the only slab, by its lowest region.
using Chi = std::map<std::size_t, long>;

Chi leasts(const checking::SlabTopology& slab) {
  Chi chi;
  for (const auto& [group, range] : slab.chi) chi[group] = range.least;
  return chi;
}

Chi chi_of(const SectionStack& stack, const CorrespondenceOptions& options = testing::plain()) {
  const StackVoids voids(stack);
  const auto faces = voids.faces();
  const auto regions = checking::expected_partition(stack, stack, options);
  const auto expected = checking::expected_voids(voids, faces, regions->links, options.voids, {});
  EXPECT_TRUE(regions.ok() && expected.ok());
  return leasts(checking::expected_topology(voids, faces, regions->links, *expected)[0]);
}

TEST(ExpectedTopology, FacesOfSolids) {
  EXPECT_EQ(chi_of(stack_of({{plate()}, {plate()}})), (Chi{{0, 1}}));
  EXPECT_EQ(chi_of(stack_of({{plate()}, {}})), (Chi{{0, 1}}));
  EXPECT_EQ(chi_of(stack_of({{box(0, 0, 4, 20), box(6, 0, 10, 20)}, {box(0, 0, 10, 20)}})),
            (Chi{{0, 1}}));
  // Two bars over two bars: a ring, with a tunnel to outside; and where it is refused, two plates
  // more.
  EXPECT_EQ(chi_of(stack_of(
                {{box(0, 0, 4, 20), box(6, 0, 10, 20)}, {box(-5, 5, 15, 8), box(-5, 12, 15, 15)}})),
            (Chi{{0, 0}}));
  // Two solids, that nothing links.
  EXPECT_EQ(chi_of(stack_of({{box(0, 0, 4, 4)}, {box(5, 0, 9, 4)}})), (Chi{{0, 1}, {1, 1}}));
}

TEST(ExpectedTopology, OpenAndClosedVoids) {
  // A tube; pits, of which each is closed by the other plate.
  EXPECT_EQ(chi_of(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(5, 5, 9, 9)}})),
            (Chi{{0, 0}}));
  EXPECT_EQ(chi_of(stack_of({{plate(), box(5, 5, 9, 9)}, {plate()}})), (Chi{{0, 1}}));
  EXPECT_EQ(chi_of(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(12, 12, 16, 16)}})),
            (Chi{{0, 1}}));
  // Overlapping by too little: a plate.
  EXPECT_EQ(chi_of(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(8.5, 8.5, 12.5, 12.5)}})),
            (Chi{{0, 1}}));
  // A tunnel where nothing overlaps.
  CorrespondenceOptions options = testing::plain();
  options.voids.decisions = {{SlabId(0U), ContourId(1U), ContourId(1U), true}};
  EXPECT_EQ(chi_of(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(12, 12, 16, 16)}}), options),
            (Chi{{0, 0}}));
}

TEST(ExpectedTopology, BarsAndDishes) {
  const auto joined = [](std::uint32_t upper) {
    CorrespondenceOptions options = testing::plain();
    options.decisions = {{SlabId(0U), ContourId(0U), ContourId(upper), true}};
    return options;
  };
  EXPECT_EQ(chi_of(stack_of({{box(0, 0, 4, 4)}, {box(5, 0, 9, 4)}}, 10), joined(0)), (Chi{{0, 1}}));
  // A disc under the hole of a ring, that are one: the face between is closed, and a dish. The
  // hole is kept apart from outside by a distance of more than a quarter gap.
  const SectionStack dish = stack_of({{box(8, 8, 12, 12)}, {plate(), box(5, 5, 15, 15)}}, 10);
  CorrespondenceOptions closed = joined(0);
  closed.voids.decisions = {{SlabId(0U), kOutside, ContourId(1U), false}};
  EXPECT_EQ(chi_of(dish, closed), (Chi{{0, 1}}));
  EXPECT_EQ(chi_of(dish, joined(0)), (Chi{{0, 1}}));
  // The hole open all around the disc, on one bridge.
  CorrespondenceOptions open = joined(0);
  open.voids.decisions = {{SlabId(0U), kOutside, ContourId(1U), true}};
  EXPECT_EQ(chi_of(dish, open), (Chi{{0, 0}}));
  // The ring and the disc as two solids: a plate between is of both.
  CorrespondenceOptions two = testing::plain();
  two.voids.decisions = closed.voids.decisions;
  EXPECT_EQ(chi_of(dish, two), (Chi{{0, 1}}));
}

TEST(ExpectedTopology, TunnelsBetweenSolidsMakeAGroup) {
  const SectionStack stack =
      stack_of({{box(0, 0, 10, 10), box(4, 4, 6, 6)}, {box(20, 0, 30, 10), box(24, 4, 26, 6)}});
  CorrespondenceOptions options = testing::plain();
  // Holes under and over nothing are of the outside; parted from it and joined they are a void that
  // two plates close and one tunnel goes through.
  EXPECT_EQ(chi_of(stack, options), (Chi{{0, 0}, {1, 0}}));
  options.voids.decisions = {{SlabId(0U), ContourId(1U), kOutside, false},
                             {SlabId(0U), kOutside, ContourId(1U), false},
                             {SlabId(0U), ContourId(1U), ContourId(1U), true}};
  EXPECT_EQ(chi_of(stack, options), (Chi{{0, 1}}));
}

TEST(ExpectedTopology, VoidsOfTheStack) {
  const auto sets = [](const SectionStack& stack) {
    const StackVoids voids(stack);
    const auto expected = checking::expected_voids(voids, voids.faces(), {}, {}, {});
    return checking::expected_void_sets(voids, *expected);
  };
  const std::vector<Contour> holed{plate(), box(5, 5, 9, 9)};
  // A cavity; a pit from above, and from below; a hole that only the first section has.
  EXPECT_EQ(sets(stack_of({{plate()}, holed, {plate()}})), (std::vector<std::size_t>{0, 0, 2, 0}));
  EXPECT_EQ(sets(stack_of({{plate()}, holed, holed})), (std::vector<std::size_t>{0, 0, 0, 0, 0}));
  EXPECT_EQ(sets(stack_of({holed, {plate()}})), (std::vector<std::size_t>{0, 0, 0}));
}

// Plates with holes, islands in them, and plates beside.
std::vector<Contour> random_plates(Prng& prng) {
  std::vector<Contour> contours;
  for (const double x0 : {0.0, 13.0}) {
    if (prng.chance(0.2)) continue;
    const double x = x0 + static_cast<double>(prng.below(4));
    const double width = static_cast<double>(7 + prng.below(4));
    contours.push_back(box(x, static_cast<double>(prng.below(3)), x + width, 12));
    for (std::uint64_t k = prng.below(4); k > 0; --k) {
      const double hx = x + 0.5 + static_cast<double>(prng.below(14)) / 2;
      const double hy = 3.5 + static_cast<double>(prng.below(12)) / 2;
      const double w = static_cast<double>(1 + prng.below(5));
      const double h = static_cast<double>(1 + prng.below(5));
      contours.push_back(prng.chance(0.7) ? box(hx, hy, hx + w, hy + h)
                                          : Contour{{{hx, hy}, {hx + w, hy}, {hx, hy + w}}});
      if (prng.chance(0.3)) contours.push_back(box(hx + 0.25, hy + 0.25, hx + 0.5, hy + 0.5));
    }
  }
  return contours;
}

SectionStack random_stack(Prng& prng) {
  for (;;) {
    SectionStack stack;
    double z = 0;
    for (int s = 0; s < 3; ++s) {
      stack.sections.push_back({z, IdVector<ContourId, Contour>(random_plates(prng))});
      z += static_cast<double>(1 + prng.below(4));
    }
    if (validate(stack).ok()) return stack;
  }
}

// A hole or the outside; now and then what is neither.
ContourId random_void(Prng& prng, const Section& section) {
  if (prng.chance(0.3) || section.contours.empty()) return kOutside;
  const Nesting nesting = nest(section);
  for (int attempt = 0; attempt < 10; ++attempt) {
    const ContourId c(prng.below(section.contours.size()));
    if (nesting.depth[c] % 2 == 1) return c;
  }
  return prng.chance(0.9) ? kOutside : ContourId(prng.below(section.contours.size() + 1));
}

CorrespondenceOptions random_options(Prng& prng, const SectionStack& stack) {
  CorrespondenceOptions options;
  options.criterion = Criterion::overlap;
  if (prng.chance(0.3)) {
    const SlabId slab(prng.below(2));
    const auto& lower = stack.sections[SectionId(slab.index())].contours;
    const auto& upper = stack.sections[SectionId(slab.index() + 1)].contours;
    if (!lower.empty() && !upper.empty()) {
      options.decisions.push_back({slab, ContourId(prng.below(lower.size())),
                                   ContourId(prng.below(upper.size())), prng.chance(0.5)});
    }
  }
  VoidOptions& voids = options.voids;
  if (prng.chance(0.3)) voids.rule = VoidRule::near;
  voids.reach = 0.25 * static_cast<double>(prng.below(5));
  for (std::uint64_t k = prng.chance(0.3) ? prng.below(4) : 0; k > 0; --k) {
    const SlabId slab(prng.below(2));
    voids.decisions.push_back({slab, random_void(prng, stack.sections[SectionId(slab.index())]),
                               random_void(prng, stack.sections[SectionId(slab.index() + 1)]),
                               prng.chance(0.5)});
  }
  for (std::uint64_t k = prng.chance(0.4) ? prng.below(5) : 0; k > 0; --k) {
    const SectionId s(prng.below(3));
    const ContourId c = random_void(prng, stack.sections[s]);
    if (c.valid()) voids.labels.push_back({s, c, static_cast<std::uint32_t>(prng.below(3))});
  }
  return options;
}

Model random_claims(Prng& prng, const SectionStack& stack) {
  Model claims;
  for (std::uint64_t k = prng.chance(0.5) ? prng.below(4) : 0; k > 0; --k) {
    const SlabId slab(prng.below(2));
    VoidLink link;
    link.slab = slab;
    link.fate = prng.chance(0.5) ? LinkFate::forced : LinkFate::unrealisable;
    link.upper = random_void(prng, stack.sections[SectionId(slab.index() + 1)]);
    link.lower = random_void(prng, stack.sections[SectionId(slab.index())]);
    claims.void_links.push_back(link);
    if (prng.chance(0.1)) claims.void_links.push_back(link);
  }
  return claims;
}

// How often each answer came.
struct Answers {
  std::size_t touching = 0, single_class = 0;  // slabs
  std::size_t refused = 0, unrealised = 0, wrong = 0, sets = 0, forced = 0, dropped = 0;
  std::map<long, std::size_t> chi;
};

std::vector<oracle::RegionPair> pairs(const std::vector<Link>& links) {
  std::vector<oracle::RegionPair> result;
  for (const Link& link : links) result.emplace_back(link.lower, link.upper);
  return result;
}

bool has_touches(const checking::Faces& faces) {
  return !faces.touching_voids.empty() ||
         std::any_of(faces.meetings.begin(), faces.meetings.end(), [](const auto& meeting) {
           return meeting.touches != 0 || meeting.connections != 0;
         });
}

void compare(const SectionStack& stack, const CorrespondenceOptions& options, const Model& claims,
             const std::string& what, Answers& answers) {
  const auto regions = checking::expected_partition(stack, stack, options);
  const oracle::ExpectedSets solids = oracle::expected_sets(claims, stack, options);
  ASSERT_TRUE(regions.ok() && !solids.refused) << what;
  ASSERT_EQ(pairs(regions->links),
            std::vector<oracle::RegionPair>(solids.links.begin(), solids.links.end()))
      << what;
  const StackVoids voids(stack);
  const auto faces = voids.faces();
  const auto expected =
      checking::expected_voids(voids, faces, regions->links, options.voids, claims.void_links);
  const oracle::ExpectedTopology truth =
      oracle::expected_topology(claims, stack, options.voids, solids.links);
  ASSERT_EQ(expected.ok(), !truth.refused) << what;
  if (truth.refused) {
    ++answers.refused;
    return;
  }
  EXPECT_EQ(expected->unrealised.has_value(), !truth.realised) << what;
  EXPECT_EQ(expected->wrong.empty(), truth.claims_hold) << what;
  answers.wrong += truth.claims_hold ? 0U : 1U;
  if (!truth.realised) {
    ++answers.unrealised;
    return;
  }
  EXPECT_EQ(expected->forced.size(), truth.forced) << what;
  EXPECT_EQ(expected->unrealisable, truth.unrealisable) << what;
  std::vector<checking::Link> links = expected->links;
  for (const checking::SlabVoids& forced : expected->forced) links.push_back(forced.voids);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  EXPECT_EQ(pairs(links), std::vector<oracle::RegionPair>(truth.links.begin(), truth.links.end()))
      << what;
  EXPECT_EQ(checking::expected_void_sets(voids, *expected), truth.set) << what;
  const auto slabs = checking::expected_topology(voids, faces, regions->links, *expected);
  ASSERT_EQ(slabs.size(), truth.chi.size());
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    // Touches are all void or all solid; what is less or more for some of them lies about these.
    const bool touches = has_touches(faces[s]);
    std::vector<Chi> extremes{truth.chi[s]};
    // What is of two classes cannot be solid where it touches; nor what links of voids lead
    // through.
    const std::vector<std::size_t>& classes = slabs[s].class_of;
    if (faces[s].touching_voids.empty() && !classes.empty() &&
        std::count(classes.begin(), classes.end(), classes.front()) ==
            static_cast<std::ptrdiff_t>(classes.size())) {
      extremes.push_back(truth.chi_of_touches[s]);
      ++answers.single_class;
    }
    for (const Chi& numbers : extremes) {
      checking::ChiRange all;
      long sum = 0;
      for (const auto& [group, range] : slabs[s].chi) {
        all.least += range.least;
        all.most += range.most;
      }
      for (const auto& [group, chi] : numbers) sum += chi;
      // Groups of another kind, since what touches needs a tunnel or not.
      const bool regrouped = touches && slabs[s].chi.size() != numbers.size();
      EXPECT_TRUE(all.holds(sum) || regrouped)
          << what << ", slab " << s << ": " << sum << " in " << all.least << " to " << all.most;
      // What touches may need a tunnel or not, and with it a group.
      if (slabs[s].chi.size() != numbers.size()) {
        EXPECT_TRUE(touches) << what << ", slab " << s;
        continue;
      }
      for (const auto& [group, chi] : numbers) {
        const checking::ChiRange& range = slabs[s].chi.at(group);
        EXPECT_TRUE(range.holds(chi)) << what << ", slab " << s << ": " << chi << " in "
                                      << range.least << " to " << range.most;
        if (!touches) {
          EXPECT_EQ(range.least, range.most) << what << ", slab " << s;
        }
      }
    }
    answers.touching += touches ? 1U : 0U;
    for (const auto& [group, chi] : truth.chi[s]) ++answers.chi[chi];
  }
  ++answers.sets;
  answers.forced += truth.forced;
  answers.dropped += truth.unrealisable;
}

TEST(VoidRule, IsThatOfTheOracle) {
  Answers answers;
  constexpr std::uint64_t kStacks = 600;
  for (std::uint64_t seed = 1; seed <= kStacks; ++seed) {
    Prng prng(seed);
    const SectionStack stack = random_stack(prng);
    const CorrespondenceOptions options = random_options(prng, stack);
    compare(stack, options, random_claims(prng, stack), "seed " + std::to_string(seed), answers);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(answers.refused, kStacks / 40);
  EXPECT_GT(answers.unrealised, 0U);
  EXPECT_GT(answers.wrong, kStacks / 20);
  EXPECT_GT(answers.sets, kStacks / 2);
  EXPECT_GT(answers.touching, kStacks / 20);
  EXPECT_GT(answers.single_class, kStacks / 20);
  EXPECT_GT(answers.forced, kStacks / 40);
  EXPECT_GT(answers.dropped, kStacks / 100);
  for (long chi = -2; chi <= 1; ++chi) EXPECT_GT(answers.chi[chi], 5U) << chi;
}

}  // namespace
}  // namespace tetloft
