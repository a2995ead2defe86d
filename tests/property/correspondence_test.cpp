// What belongs together, computed three times: by the reconstruction (find_links), by check and, of
// small stacks, by an oracle in rationals; over stacks of all kinds, with labels and decisions at
// random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
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

constexpr std::size_t kMostForOracle = 60;  // vertices

// What check makes of these claims, and the oracle of a small stack.
void compare_with_oracle(const SectionStack& stack, const CorrespondenceOptions& options,
                         const Model& claims, const std::string& what) {
  if (stack.vertex_count() > kMostForOracle) return;
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

Answer compare(const SectionStack& stack, const CorrespondenceOptions& options,
               const std::string& what) {
  const Result<StackLinks> made = find_links(stack, {options, {}});
  Model claims;
  if (made.ok()) {
    claims.links = made->links;
    claims.motions = made->motions;
  }
  compare_with_oracle(stack, options, claims, what);
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

TEST(Correspondence, IsTheSameWhenItIsComputedAnew) {
  constexpr std::uint64_t kSeeds = 12;
  std::size_t answers[3] = {};
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      if (stack.vertex_count() > 3000) continue;
      const std::string name = std::string(name_of(kind)) + ", seed " + std::to_string(seed);
      for (const Criterion criterion : {Criterion::overlap, Criterion::moved}) {
        compare(stack, {.criterion = criterion}, name + ", plain");
      }
      Prng prng(seed);
      for (int trial = 0; trial < 4; ++trial) {
        const Answer answer =
            compare(stack, random_options(prng, stack), name + ", trial " + std::to_string(trial));
        ++answers[static_cast<std::size_t>(answer)];
      }
    }
  }
  EXPECT_GT(answers[0], 500U);
  EXPECT_GT(answers[1], 10U);
  EXPECT_GT(answers[2], 20U);
}

}  // namespace
}  // namespace tetloft::testing
