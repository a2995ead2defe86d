// What a model says of motions and of links that were dropped, as check takes it.
#include <tetloft/check.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "unit/check/columns.hpp"
#include "unit/check/verdict_text.hpp"

namespace tetloft {

using namespace internal;
namespace {

using testing::Case;

// The upper square is nearer to the lower ones than half a gap, and yet a part of its own.
Case parted_case() {
  return testing::extrude({{testing::square_shape(), {0, 1, 1.25}},
                           {testing::moved(testing::square_shape(), 4.25, 0), {1.75, 2}}},
                          {0, 1, 2});
}

RegionLink dropped(std::uint32_t slab) {
  RegionLink link{SlabId(slab), ContourId(0), ContourId(0), Evidence::lone, LinkFate::unrealisable};
  link.distance = 0.25;
  return link;
}

// The numbers of the conditions that fail, and how many links count as dropped.
struct Outcome {
  std::vector<std::string> failures;
  std::size_t dropped = 0;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};
void PrintTo(const Outcome& outcome, std::ostream* out) {
  for (const std::string& failure : outcome.failures) *out << failure << " ";
  *out << outcome.dropped;
}

Outcome outcome_of(const Case& c, const CheckOptions& options = {}) {
  const auto report = check(c.model, c.stack, options);
  EXPECT_TRUE(report.ok());
  if (!report.ok()) return {};
  Outcome outcome{{}, report->dropped_links};
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      outcome.failures.push_back(failure.what.substr(0, 3));
    }
  }
  return outcome;
}

TEST(Claims, OfADroppedLinkPartWhatWouldBelongTogether) {
  Case c = parted_case();
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.3"}, 0}));
  c.model.links = {dropped(1)};
  EXPECT_EQ(outcome_of(c), (Outcome{{}, 1}));
  CheckOptions by_overlap;
  by_overlap.correspondence.criterion = Criterion::overlap;
  EXPECT_EQ(outcome_of(c, by_overlap), (Outcome{{}, 1}));
  CheckOptions joined;
  joined.correspondence.decisions = {{SlabId(1), ContourId(0), ContourId(0)}};
  EXPECT_EQ(outcome_of(c, joined), (Outcome{{"4.3", "4.7"}, 0}));
  c.model.links = {dropped(0), dropped(1)};  // the first two lie over each other
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.7"}, 1}));
  c.model.links = {dropped(1)};
  c.model.links[0].fate = LinkFate::made;
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.3"}, 0}));
}

TEST(Claims, OfMotionsAreTakenWhereTheRuleHasAny) {
  Case c = testing::pair_case();
  c.model.motions = {{SlabId(0), false, ContourId(0), {1, 0}}};
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.6"}, 0}));  // it rests
  CheckOptions by_overlap;
  by_overlap.correspondence.criterion = Criterion::overlap;
  EXPECT_EQ(outcome_of(c, by_overlap), (Outcome{{}, 0}));

  c = parted_case();
  c.model.links = {dropped(1)};
  c.model.motions = {{SlabId(1), true, ContourId(0), {4.25, 0}},
                     {SlabId(1), false, ContourId(0), {4.25, 0}}};
  EXPECT_EQ(outcome_of(c), (Outcome{{}, 1}));
  c.model.links.clear();
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.3"}, 0}));
}

TEST(Claims, OfMotionsAreComparedWithThoseEstimatedAnewIfAsked) {
  Case c = parted_case();
  c.model.links = {dropped(1)};
  CheckOptions anew;
  anew.recompute_motions = true;
  c.model.motions = {{SlabId(1), true, ContourId(0), {0.3, 0.7}}};  // no multiple of 2^-10
  const Outcome compared = outcome_of(c, anew);
  EXPECT_EQ(std::count(compared.failures.begin(), compared.failures.end(), "4.8"), 1);
  EXPECT_EQ(outcome_of(c), (Outcome{{}, 1}));
  anew.correspondence.criterion = Criterion::overlap;
  EXPECT_EQ(outcome_of(c, anew), (Outcome{{}, 1}));
}

TEST(Claims, MayBeGarbage) {
  Case c = testing::pair_case();
  c.model.links.resize(1);
  c.model.links[0].fate = LinkFate::unrealisable;
  c.model.motions.resize(1);
  EXPECT_EQ(outcome_of(c), (Outcome{{"4.6", "4.7"}, 0}));
}

}  // namespace
}  // namespace tetloft
