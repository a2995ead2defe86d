// What belongs together, computed three times: by the reconstruction (find_links), by check and, of
// small stacks, by an oracle in rationals; over stacks of all kinds, with labels and decisions at
// random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/links.hpp>

#include "check/partition.hpp"
#include "core/prng.hpp"
#include "support/correspondence_oracle.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Sets = std::vector<std::size_t>;

// Numbered by first occurrence.
Sets canonical(const Sets& sets) {
  std::vector<std::size_t> seen;
  Sets result;
  for (const std::size_t set : sets) {
    const auto at = std::find(seen.begin(), seen.end(), set);
    result.push_back(static_cast<std::size_t>(at - seen.begin()));
    if (at == seen.end()) seen.push_back(set);
  }
  return result;
}

Sets canonical(const ContourPartition& partition) {
  Sets sets;
  for (const auto& section : partition) {
    for (const ComponentId component : section) sets.push_back(component.index());
  }
  return canonical(sets);
}

SectionId random_section(Prng& prng, const SectionStack& stack) {
  return SectionId(prng.below(stack.sections.size()));
}

std::optional<ContourId> random_contour(Prng& prng, const Section& section) {
  if (section.contours.empty()) return std::nullopt;
  return ContourId(prng.below(section.contours.size()));
}

void add_label(Prng& prng, const SectionStack& stack, CorrespondenceOptions& options) {
  const SectionId s = random_section(prng, stack);
  const auto c = random_contour(prng, stack.sections[s]);
  if (c) options.labels.push_back({s, *c, static_cast<std::uint32_t>(prng.below(3))});
}

void add_decision(Prng& prng, const SectionStack& stack, CorrespondenceOptions& options) {
  const SectionId s = random_section(prng, stack);
  if (s.index() + 1 == stack.sections.size()) return;
  const auto lower = random_contour(prng, stack.sections[s]);
  const auto upper = random_contour(prng, stack.sections[SectionId(s.index() + 1)]);
  if (lower && upper) {
    options.decisions.push_back({SlabId(s.index()), *lower, *upper, prng.chance(0.4)});
  }
}

// Parts a link that is made, or joins one that is not.
void overrule(Prng& prng, const StackLinks& links, CorrespondenceOptions& options) {
  if (links.links.empty()) return;
  const RegionLink& link = links.links[prng.below(links.links.size())];
  options.decisions.push_back({link.slab, link.lower, link.upper, link.fate != LinkFate::made});
}

CorrespondenceOptions random_options(Prng& prng, const SectionStack& stack) {
  CorrespondenceOptions options;
  options.criterion = prng.chance(0.5) ? Criterion::overlap : Criterion::moved;
  options.chain = prng.chance(0.8);
  options.lone = prng.chance(0.8);
  if (prng.chance(0.3)) options.tau = 0.1 * static_cast<double>(prng.below(6));
  if (prng.chance(0.4)) {
    if (const auto links = find_links(stack, {options, {}})) {
      for (std::uint64_t k = prng.below(4); k > 0; --k) overrule(prng, *links, options);
    }
  }
  for (std::uint64_t k = prng.chance(0.3) ? prng.below(3) : 0; k > 0; --k) {
    add_decision(prng, stack, options);
  }
  for (std::uint64_t k = prng.chance(0.6) ? prng.below(6) : 0; k > 0; --k) {
    add_label(prng, stack, options);
  }
  return options;
}

// What became of one comparison.
enum class Answer : std::uint8_t { sets, unrealisable, refused };

// The oracle takes its time.
constexpr std::size_t kMostForOracle = 40;  // vertices
constexpr std::uint64_t kSeedsForOracle = 2;

// A stack, and with what numbers it is tried.
struct Tried {
  SectionStack stack;
  std::uint64_t seed;
  Prng prng;
  [[nodiscard]] bool for_oracle() const {
    return stack.vertex_count() <= kMostForOracle && seed <= kSeedsForOracle;
  }
};

// What check makes of these claims, and the oracle.
void compare_with_oracle(const SectionStack& stack, const CorrespondenceOptions& options,
                         const Model& claims, const std::string& what) {
  const auto checked =
      checking::expected_partition(stack, stack, options, {claims.links, claims.motions});
  const oracle::ExpectedSets truth = oracle::expected_sets(claims, stack, options);
  EXPECT_EQ(checked.ok(), !truth.refused) << what;
  if (!checked.ok() || truth.refused) return;
  EXPECT_EQ(checked->wrong_motions.empty() && checked->wrong_dropped.empty(), truth.claims_hold)
      << what;
  EXPECT_EQ(checked->dropped, truth.dropped) << what;
  EXPECT_EQ(checked->unrealised.has_value(), !truth.realised) << what;
  if (truth.realised) {
    EXPECT_EQ(canonical(checked->set), canonical(truth.set)) << what;
  }
}

// Changes something that a model may say.
void corrupt(Prng& prng, Model& claims) {
  for (RegionLink& link : claims.links) {
    if (prng.chance(0.2)) link.fate = LinkFate::unrealisable;
  }
  if (!claims.links.empty() && prng.chance(0.2)) {
    RegionLink link = claims.links[prng.below(claims.links.size())];
    if (prng.chance(0.5)) link.upper = ContourId(prng.below(4));
    if (prng.chance(0.1)) link.slab = SlabId();
    claims.links.push_back(link);
  }
  if (prng.chance(0.5)) {
    for (RegionMotion& motion : claims.motions) {
      motion.by = {static_cast<double>(prng.below(9)) - 4, static_cast<double>(prng.below(3)) - 1};
    }
    return;
  }
  if (claims.motions.empty()) return;
  RegionMotion motion = claims.motions[prng.below(claims.motions.size())];
  switch (prng.below(6)) {
    case 0: motion.by = {motion.by.x * 2, motion.by.y / 4}; break;
    case 1: motion.by.x = std::numeric_limits<double>::quiet_NaN(); break;
    case 2: motion.upper = !motion.upper; break;
    case 3: motion.contour = ContourId(prng.below(4)); break;
    case 4: motion.slab = SlabId(prng.below(4)); break;
    default: claims.motions.push_back(motion);
  }
  claims.motions[prng.below(claims.motions.size())] = motion;
}

Answer compare(Tried& tried, const CorrespondenceOptions& options, const std::string& what) {
  const SectionStack& stack = tried.stack;
  const Result<StackLinks> made = find_links(stack, {options, {}});
  Model claims;
  if (made.ok()) {
    claims.links = made->links;
    claims.motions = made->motions;
  }
  // The oracle does not estimate motions.
  const bool told = made.ok() || options.criterion != Criterion::moved;
  if (tried.for_oracle() && told) {
    compare_with_oracle(stack, options, claims, what);
    Model corrupted = claims;
    corrupt(tried.prng, corrupted);
    compare_with_oracle(stack, options, corrupted, what + ", corrupted");
  }
  // Without a result its motions are not known either; they matter for the sets alone.
  const auto again = checking::expected_partition(stack, stack, options,
                                                  {claims.links, claims.motions}, !made.ok());
  if (!made.ok() && made.error().code == ErrorCode::invalid_input) {
    EXPECT_FALSE(again.ok()) << what;
    if (!again.ok()) {
      EXPECT_EQ(again.error().code, ErrorCode::invalid_input) << what;
    }
    return Answer::refused;
  }
  EXPECT_TRUE(again.ok()) << what;
  if (!again.ok()) return Answer::refused;
  EXPECT_EQ(again->wrong_motions, std::vector<std::string>()) << what;
  EXPECT_EQ(again->wrong_dropped, std::vector<std::string>()) << what;
  if (!made.ok()) {
    EXPECT_EQ(made.error().code, ErrorCode::unrepresentable) << what;
    EXPECT_TRUE(again->unrealised.has_value()) << what;
    return Answer::unrealisable;
  }
  EXPECT_FALSE(again->unrealised.has_value()) << what;
  EXPECT_EQ(canonical(made->partition), canonical(again->set)) << what;
  return Answer::sets;
}

// One to four shapes on a lattice that lean from section to section: what is equal is often so.
std::vector<Contour> random_shapes(Prng& prng, int section, const Point2& lean) {
  std::vector<Contour> contours;
  for (std::uint64_t k = prng.below(4); k > 0; --k) {
    const double x = static_cast<double>(prng.below(12)) + lean.x * section;
    const double y = static_cast<double>(prng.below(6)) + lean.y * section;
    const double w = static_cast<double>(1 + prng.below(5));
    const double h = static_cast<double>(1 + prng.below(3));
    if (prng.chance(0.2)) {
      contours.push_back({{{x, y}, {x + w, y}, {x, y + h}}});
      continue;
    }
    contours.push_back({{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}});
    if (prng.chance(0.2)) {
      contours.push_back(
          {{{x + w / 4, y + h / 4}, {x + w / 2, y + h / 4}, {x + w / 4, y + h / 2}}});
    }
  }
  return contours;
}

SectionStack lattice_stack(Prng& prng) {
  for (;;) {
    SectionStack stack;
    const Point2 lean{static_cast<double>(prng.below(9)) - 4, static_cast<double>(prng.below(3))};
    double z = 0;
    for (int s = 0; s < 4; ++s) {
      stack.sections.push_back({z, IdVector<ContourId, Contour>(random_shapes(prng, s, lean))});
      z += static_cast<double>(1 + prng.below(3));
    }
    if (validate(stack).ok()) return stack;
  }
}

TEST(Correspondence, IsTheSameOnLattices) {
  constexpr std::uint64_t kStacks = 50 * TETLOFT_STACKS_IN_EIGHT;
  for (std::uint64_t seed = 1; seed <= kStacks; ++seed) {
    Prng prng(seed);
    Tried tried{lattice_stack(prng), 1, prng};
    const std::string name = "seed " + std::to_string(seed);
    for (const Criterion criterion : {Criterion::overlap, Criterion::moved}) {
      compare(tried, {.criterion = criterion}, name + ", plain");
    }
    compare(tried, random_options(tried.prng, tried.stack), name + ", options");
  }
}

TEST(Correspondence, IsTheSameWhenItIsComputedAnew) {
  constexpr std::uint64_t kSeeds = TETLOFT_STACKS_IN_EIGHT;
  std::size_t answers[3] = {};
  std::size_t with_oracle = 0;
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Tried tried{generate(kind, seed).stack, seed, Prng(seed)};
      if (tried.stack.vertex_count() > 3000) continue;
      const std::string name = std::string(name_of(kind)) + ", seed " + std::to_string(seed);
      for (const Criterion criterion : {Criterion::overlap, Criterion::moved}) {
        compare(tried, {.criterion = criterion}, name + ", plain");
      }
      for (int trial = 0; trial < (kSeeds < 8 ? 1 : 4); ++trial) {
        const CorrespondenceOptions options = random_options(tried.prng, tried.stack);
        const Answer answer = compare(tried, options, name + ", trial " + std::to_string(trial));
        ++answers[static_cast<std::size_t>(answer)];
        with_oracle += tried.for_oracle() ? 1U : 0U;
      }
    }
  }
  if (kSeeds < 8) {  // with sanitizers
    EXPECT_GT(answers[0], 20U);
    return;
  }
  EXPECT_GT(answers[0], 1000U);
  EXPECT_GT(answers[1], 15U);
  EXPECT_GT(answers[2], 40U);
  EXPECT_GT(with_oracle, 100U);
}

}  // namespace
}  // namespace tetloft::testing
