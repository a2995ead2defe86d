// A few hundred stacks in every run of the tests; tetloft_campaign runs any number.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>

#include <tetloft/links.hpp>
#include <tetloft/reconstruct.hpp>

#include "property/run_campaign.hpp"

namespace tetloft {
namespace {

using tetloft::testing::CampaignOptions;
using tetloft::testing::CampaignResult;
using tetloft::testing::Failure;
using tetloft::testing::rare_rules;
using tetloft::testing::run_campaign;
using tetloft::testing::table;
using tetloft::testing::to_string;

// Makes the link that is nearest to being made, and parts the one that is nearest to not being.
void overrule(const SectionStack& stack, CorrespondenceOptions& rule) {
  const auto links = find_links(stack, {rule, {}});
  if (!links) return;
  bool joined = false;
  bool parted = false;
  for (const RegionLink& link : least_sure_first(links->links)) {
    bool& done = link.fate == LinkFate::made ? parted : joined;
    if (done) continue;
    done = true;
    rule.decisions.push_back({link.slab, link.lower, link.upper, link.fate != LinkFate::made});
  }
}

// One campaign for the tests of this suite.
class Campaign : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    CampaignOptions options;
    options.count = TETLOFT_CAMPAIGN_COUNT;
    options.seed = 1;
    options.threads = 0;
    options.folder = TETLOFT_CAMPAIGN_FOLDER;
    result_ = new CampaignResult(run_campaign(options));
    std::printf("%s", table(*result_).c_str());
  }
  static void TearDownTestSuite() {
    delete result_;
    result_ = nullptr;
  }
  static CampaignResult* result_;
};
CampaignResult* Campaign::result_ = nullptr;

TEST_F(Campaign, EveryModelKeepsTheGuarantees) {
  for (const Failure& failure : result_->failures) ADD_FAILURE() << to_string(failure);
}

TEST_F(Campaign, EveryRuleFiresAtLeastTenTimes) {
  // The shorter campaign under sanitizers looks for faults, not for coverage.
  if (TETLOFT_CAMPAIGN_COUNT < 20) GTEST_SKIP();
  for (const Rule rule : rare_rules(*result_, 10)) {
    ADD_FAILURE() << name_of(rule) << " fired " << result_->rules[static_cast<std::size_t>(rule)]
                  << " times";
  }
}

TEST(CampaignWork, AStackOfAHundredMediansIsAFinding) {
  EXPECT_EQ(tetloft::testing::median({5, 1, 9}), 5);
  EXPECT_FALSE(tetloft::testing::is_costly(500, 5));
  EXPECT_TRUE(tetloft::testing::is_costly(501, 5));
}

// The kinds with regions that overlap nothing, with other rules than the defaults, and with links
// overruled.
TEST(LinkCampaign, EveryModelKeepsTheGuarantees) {
  using tetloft::testing::Outcome;
  using tetloft::testing::StackKind;
  const std::uint64_t seeds = TETLOFT_CAMPAIGN_COUNT;
  std::size_t models = 0;
  std::size_t refused = 0;
  for (const StackKind kind :
       {StackKind::oblique, StackKind::isolated_contours, StackKind::far_apart,
        StackKind::extreme_gaps, StackKind::scale_offset, StackKind::small_grid, StackKind::slivers,
        StackKind::branching_many_to_many, StackKind::random_labels, StackKind::few_ulps}) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      auto generated = tetloft::testing::generate(kind, seed);
      CorrespondenceOptions& rule = generated.correspondence;
      rule.criterion = seed % 2 == 0 ? Criterion::overlap : Criterion::moved;
      rule.chain = seed % 3 != 0;
      rule.lone = seed % 4 < 2;
      if (seed % 5 == 0) rule.tau = 0.0;
      if (rule.labels.empty()) overrule(generated.stack, rule);
      const auto excuse = rule.decisions.empty() ? tetloft::testing::excuse_of(kind)
                                                 : tetloft::testing::Excuse::labels;
      const auto attempt = tetloft::testing::attempt(generated, rule.criterion, excuse);
      models += attempt.outcome == Outcome::model ? 1U : 0U;
      refused += attempt.outcome == Outcome::refused ? 1U : 0U;
      EXPECT_LE(attempt.outcome, Outcome::refused)
          << name_of(kind) << " seed " << seed << ": " << attempt.detail;
    }
  }
  std::printf("links: %zu models, %zu refused\n", models, refused);
  EXPECT_GT(models, 9 * seeds);
}

// As many sections between as gaps call for, and numbers of them.
TEST(BetweenCampaign, EveryModelKeepsTheGuarantees) {
  using tetloft::testing::Outcome;
  std::size_t models = 0;
  std::size_t tried = 0;
  for (const auto kind : tetloft::testing::all_kinds()) {
    if (tetloft::testing::has_large_triangulations(kind)) continue;
    for (std::uint64_t seed = 1; seed <= 1 + TETLOFT_CAMPAIGN_COUNT / 10; ++seed) {
      const auto generated = tetloft::testing::generate(kind, seed);
      const std::optional<std::size_t> between =
          seed % 2 == 0 ? std::optional(std::size_t{1 + seed % 3}) : std::nullopt;
      const auto attempt = tetloft::testing::attempt(generated, Criterion::moved,
                                                     tetloft::testing::excuse_of(kind), between);
      ++tried;
      models += attempt.outcome == Outcome::model ? 1U : 0U;
      EXPECT_LE(attempt.outcome, Outcome::refused)
          << name_of(kind) << " seed " << seed << ": " << attempt.detail;
    }
  }
  EXPECT_GT(10 * models, 9 * tried);
}

}  // namespace
}  // namespace tetloft
