// A few hundred stacks in every run of the tests; tetloft_campaign runs any number.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tetloft
