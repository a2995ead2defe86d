// That a campaign can fail: what counts as wrong, as refused and as the same.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/io.hpp>

#include "property/run_campaign.hpp"
#include "property/same_model.hpp"
#include "property/thin_tets.hpp"

namespace tetloft {
namespace {

using tetloft::testing::attempt;
using tetloft::testing::CampaignResult;
using tetloft::testing::Excuse;
using tetloft::testing::GeneratedStack;
using tetloft::testing::has_thin_tet;
using tetloft::testing::Outcome;
using tetloft::testing::rare_rules;
using tetloft::testing::same_bits;

// Two squares one above the other, and another pair beside them.
GeneratedStack two_columns() {
  GeneratedStack generated;
  for (const double z : {0.0, 1.0}) {
    Section section;
    section.z = z;
    section.contours.push_back({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    section.contours.push_back({{{3, 0}, {4, 0}, {4, 1}, {3, 1}}});
    generated.stack.sections.push_back(section);
  }
  return generated;
}

TEST(Attempt, ValidStackGivesAModel) {
  const auto tried = attempt(two_columns(), Criterion::overlap, Excuse::none);
  EXPECT_EQ(tried.outcome, Outcome::model) << tried.detail;
}

TEST(Attempt, InvalidStackIsWrongWhateverTheExcuse) {
  GeneratedStack crossed = two_columns();
  auto& vertices = crossed.stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
  std::swap(vertices[0], vertices[1]);
  for (const Excuse excuse : {Excuse::none, Excuse::precision, Excuse::labels}) {
    EXPECT_EQ(attempt(crossed, Criterion::overlap, excuse).outcome, Outcome::wrong_error);
  }
}

// Three vertices above are collinear but for rounding: the midpoints between them cannot leave
// the plane within the tet over their triangle.
TEST(Attempt, ARefusalIsExcusedByATetAsThinAsTheSpacingOfDoublesAlone) {
  const auto read = read_cnt(std::string(TETLOFT_DATA_DIR) + "/cases/refused/thin_triangle.cnt");
  ASSERT_TRUE(read);
  GeneratedStack generated;
  generated.stack = read->stack;
  const auto tried = attempt(generated, Criterion::reverse, Excuse::none);
  EXPECT_EQ(tried.outcome, Outcome::refused) << tried.detail;
  EXPECT_NE(tried.detail.find("slab 0"), std::string::npos) << tried.detail;
  EXPECT_TRUE(has_thin_tet(generated.stack, 0, {-2.2315270303, 1.7378973253, 10.5}));
  EXPECT_FALSE(has_thin_tet(generated.stack, 0, {-4.5, 0, 10.5}));
  EXPECT_FALSE(has_thin_tet(two_columns().stack, 0, {0.5, 0.5, 0}));
  EXPECT_FALSE(has_thin_tet(two_columns().stack, 1, {0.5, 0.5, 0}));
}

TEST(Attempt, ContradictingLabelsAreWrongWhateverTheExcuse) {
  GeneratedStack labelled = two_columns();
  labelled.correspondence.labels = {{SectionId(0), ContourId(0), 1},
                                    {SectionId(0), ContourId(0), 2}};
  for (const Excuse excuse : {Excuse::none, Excuse::precision, Excuse::labels}) {
    EXPECT_EQ(attempt(labelled, Criterion::overlap, excuse).outcome, Outcome::wrong_error);
  }
}

TEST(RareRules, EveryRuleButGabrielRefinementMustFire) {
  CampaignResult result;
  result.rules.fill(10);
  result.rules[static_cast<std::size_t>(Rule::gabriel_refinement)] = 0;
  EXPECT_TRUE(rare_rules(result, 10).empty());
  result.rules[static_cast<std::size_t>(Rule::moved_cut)] = 9;
  EXPECT_EQ(rare_rules(result, 10), std::vector<Rule>{Rule::moved_cut});
}

TEST(SameBits, EveryArrayCounts) {
  Model model;
  model.points.push_back({0, 1, 2});
  model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  model.component.push_back(ComponentId(0));
  EXPECT_TRUE(same_bits(model, model));
  Model other = model;
  other.points[VertexId(0)].x = -0.0;
  EXPECT_FALSE(same_bits(model, other));
  other = model;
  other.tets[TetId(0)][0] = VertexId(9);
  EXPECT_FALSE(same_bits(model, other));
  other = model;
  other.component[TetId(0)] = ComponentId(1);
  EXPECT_FALSE(same_bits(model, other));
}

}  // namespace
}  // namespace tetloft
