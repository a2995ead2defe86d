// Guarantee 5: right models pass, and each change of topology fails with the conditions that tell
// it, and no others.
#include <tetloft/check.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "unit/check/blocks.hpp"
#include "unit/check/rule_stacks.hpp"
#include "unit/check/verdict_text.hpp"

namespace tetloft {
namespace {

using testing::box;
using testing::Case;
using testing::Layers;
using testing::Picture;

using Conditions = std::set<std::string>;

const Picture kPlate{"#######", "#######", "#######", "#######", "#######"};
const Picture kHoled{"#######", "#######", "##.####", "#######", "#######"};
const Picture kTwoHoles{"#######", "#######", "##.#.##", "#######", "#######"};
const Picture kBars{"###.###", "###.###", "###.###", "###.###", "###.###"};

Contour plate() { return box(0, 0, 7, 5); }
Contour left_hole() { return box(2, 2, 3, 3); }
Contour right_hole() { return box(4, 2, 5, 3); }

Section section(double z, const std::vector<Contour>& contours) {
  return {z, IdVector<ContourId, Contour>(contours)};
}

// Sections at 0, 3, 6, …, in which the layers on either side of them are; one layer between.
Layers layers(const std::vector<std::pair<Picture, std::vector<Contour>>>& sections,
              const std::vector<Picture>& between) {
  Layers made;
  double z = 0;
  for (std::size_t s = 0; s < sections.size(); ++s, z += 3) {
    made.sections.push_back(section(z, sections[s].second));
    if (s > 0) {
      made.heights.push_back(z - 1);
      made.pictures.push_back(sections[s].first);
    }
    made.heights.push_back(z);
    if (s + 1 == sections.size()) continue;
    made.pictures.push_back(sections[s].first);
    made.heights.push_back(z + 1);
    made.pictures.push_back(between[s]);
  }
  return made;
}

const std::pair<Picture, std::vector<Contour>> kSolid{kPlate, {plate()}};
const std::pair<Picture, std::vector<Contour>> kOneHole{kHoled, {plate(), left_hole()}};
const std::pair<Picture, std::vector<Contour>> kPair{kTwoHoles,
                                                     {plate(), left_hole(), right_hole()}};
const std::pair<Picture, std::vector<Contour>> kTwoBars{kBars, {box(0, 0, 3, 5), box(4, 0, 7, 5)}};

// A plate, two sections with a hole, a plate: one cavity. Picture 4 lies between the holes.
Layers cavity() { return layers({kSolid, kOneHole, kOneHole, kSolid}, {kPlate, kHoled, kPlate}); }
constexpr std::size_t kBetweenHoles = 4;

CheckReport checked(const Case& c, const CheckOptions& options = {}) {
  const auto report = check(c.model, c.stack, options);
  EXPECT_TRUE(report.ok()) << (report.ok() ? "" : to_string(report.error()));
  return report.ok() ? *report : CheckReport{};
}

Conditions failed(const Case& c, const CheckOptions& options = {}) {
  return testing::failed_conditions(checked(c, options));
}

long sum(const std::vector<long>& numbers) {
  long result = 0;
  for (const long n : numbers) result += n;
  return result;
}

TEST(Cavities, RightModelsPass) {
  struct Right {
    Layers layers;
    std::size_t cavities;
    long genus;
  };
  const std::vector<Right> models{
      {layers({kSolid, kSolid}, {kPlate}), 0, 0},
      {cavity(), 1, 0},
      {layers({kOneHole, kOneHole}, {kHoled}), 0, 1},
      {layers({kPair, kPair, kPair}, {kTwoHoles, kTwoHoles}), 0, 2},
      {layers({kSolid, kPair, kSolid}, {kPlate, kPlate}), 2, 0},
      {layers({kSolid, kOneHole}, {kPlate}), 0, 0},
      {layers({kSolid, kTwoBars, kSolid}, {kPlate, kPlate}), 0, 1},
      {layers({kTwoBars, kTwoBars}, {kBars}), 0, 0},
  };
  for (const Right& right : models) {
    const Case c = build(right.layers);
    const CheckReport report = checked(c);
    EXPECT_TRUE(report.pass()) << testing::text(report);
    ASSERT_EQ(report.guarantees.size(), 5U);
    EXPECT_EQ(report.guarantees[4].name, "cavities and tunnels");
    EXPECT_EQ(report.guarantees[4].not_asked, "");
    EXPECT_EQ(report.cavities, right.cavities);
    EXPECT_EQ(report.expected_cavities, right.cavities);
    EXPECT_EQ(report.least_genus, right.genus);
    EXPECT_EQ(report.most_genus, right.genus);
    EXPECT_EQ(sum(report.genus), right.genus);
    CheckOptions strict;
    strict.strict = true;
    EXPECT_TRUE(checked(c, strict).pass());
  }
}

// What is done to the layer between two sections, or to others, and what fails then.
struct Change {
  const char* name;
  Layers start;
  std::function<void(Layers&)> change;
  Conditions conditions;
};

void set(Layers& layers, std::size_t picture, std::size_t i, std::size_t j, char to) {
  layers.pictures[picture][j][i] = to;
}

TEST(Cavities, EachChangeFailsAsItShould) {
  const std::vector<Change> changes{
      {"a cavity filled half way up",
       cavity(),
       [](Layers& l) { l.pictures[kBetweenHoles] = kPlate; },
       {"5.4", "5.7"}},
      {"a bubble", cavity(), [](Layers& l) { set(l, kBetweenHoles, 5, 3, '.'); }, {"5.3", "5.7"}},
      {"a tunnel from the cavity to outside",
       cavity(),
       [](Layers& l) {
         set(l, kBetweenHoles, 2, 1, '.');
         set(l, kBetweenHoles, 2, 0, '.');
       },
       {"5.5", "5.7"}},
      {"a tunnel from outside to outside",
       cavity(),
       [](Layers& l) {
         for (std::size_t j = 0; j < 5; ++j) set(l, kBetweenHoles, 5, j, '.');
       },
       {"5.7"}},
      {"two holes that are one",
       layers({kSolid, kPair, kPair, kSolid}, {kPlate, kTwoHoles, kPlate}),
       [](Layers& l) { set(l, kBetweenHoles, 3, 2, '.'); },
       {"5.5", "5.7"}},
      {"a leak and a wall at once: chi is right, voids are not",
       layers({kSolid, kPair, kPair, kSolid}, {kPlate, kTwoHoles, kPlate}),
       [](Layers& l) {
         set(l, kBetweenHoles, 2, 2, '#');
         set(l, kBetweenHoles, 4, 1, '.');
         set(l, kBetweenHoles, 4, 0, '.');
       },
       {"5.4", "5.5"}},
      {"a bar between two regions that are one elsewhere",
       layers({kSolid, kTwoBars, kTwoBars}, {kPlate, kBars}),
       [](Layers& l) { set(l, kBetweenHoles, 3, 2, '#'); },
       {"5.6", "5.7"}},
      {"a handle beyond the end",
       cavity(),
       [](Layers& l) {
         l.heights.push_back(10);
         l.pictures.push_back(kPlate);
         l.heights.push_back(11);
         l.pictures.push_back({"#######", ".......", ".......", ".......", "#######"});
         l.heights.push_back(12);
         l.pictures.push_back(kPlate);
         l.heights.push_back(13);
       },
       {"5.9"}},
      {"a pit closed beyond the end",
       layers({kSolid, kOneHole}, {kPlate}),
       [](Layers& l) {
         l.pictures.push_back(kHoled);
         l.heights.push_back(4);
         l.pictures.push_back(kPlate);
         l.heights.push_back(5);
       },
       {"5.4", "5.9"}},
      {"a right end",
       layers({kSolid, kOneHole}, {kPlate}),
       [](Layers& l) {
         l.pictures.push_back(kHoled);
         l.heights.push_back(4);
       },
       {}},
  };
  for (const Change& change : changes) {
    EXPECT_EQ(failed(build(change.start)), Conditions{}) << change.name;
    Layers changed = change.start;
    change.change(changed);
    const CheckReport report = checked(build(changed));
    EXPECT_EQ(testing::failed_conditions(report), change.conditions) << change.name << '\n'
                                                                     << testing::text(report);
    EXPECT_EQ(report.guarantees[4].pass, change.conditions.empty()) << change.name;
  }
}

// The cavity with a tunnel from outside to outside in slab 1: chi is 0 lower than expected.
Case drilled() {
  Layers l = cavity();
  for (std::size_t j = 0; j < 5; ++j) set(l, kBetweenHoles, 5, j, '.');
  return build(l);
}

Deviation deviation(std::uint32_t slab, bool upper, std::uint32_t contour, int expected, int got) {
  return {SlabId(slab), upper, ContourId(contour), expected, expected, got};
}

TEST(Cavities, ListedDeviationsAreAllowedIfTheyAreRight) {
  Case c = drilled();
  const Deviation right = deviation(1, false, 0, 0, -1);
  c.model.deviations = {right};
  CheckReport report = checked(c);
  EXPECT_TRUE(report.pass()) << testing::text(report);
  EXPECT_EQ(report.deviations, 1U);
  EXPECT_EQ(report.least_genus, 0);
  EXPECT_EQ(report.most_genus, 0);
  CheckOptions strict;
  strict.strict = true;
  EXPECT_EQ(failed(c, strict), Conditions{"5.10"});
  // Twice.
  c.model.deviations = {right, right};
  EXPECT_EQ(failed(c), Conditions{"5.8"});
  // Other numbers, another place, or one that is none.
  for (const Deviation& wrong :
       {deviation(1, false, 0, 1, -1), deviation(1, false, 0, 0, -2), deviation(0, false, 0, 0, -1),
        deviation(1, true, 0, 0, -1), deviation(1, false, 1, 0, -1), deviation(3, false, 0, 0, -1),
        deviation(1, false, 9, 0, -1)}) {
    c.model.deviations = {wrong};
    EXPECT_EQ(failed(c), (Conditions{"5.7", "5.8"}));
  }
  Deviation nameless = right;
  nameless.contour = ContourId();
  c.model.deviations = {nameless};
  EXPECT_EQ(failed(c), (Conditions{"5.7", "5.8"}));
  nameless = right;
  nameless.slab = SlabId();
  c.model.deviations = {nameless};
  EXPECT_EQ(failed(c), (Conditions{"5.7", "5.8"}));
  Case good = build(cavity());
  good.model.deviations = {deviation(1, false, 0, 0, 0)};
  EXPECT_EQ(failed(good), Conditions{"5.8"});
}

VoidLink claim(std::uint32_t slab, ContourId lower, ContourId upper, LinkFate fate) {
  VoidLink link;
  link.slab = SlabId(slab);
  link.lower = lower;
  link.upper = upper;
  link.fate = fate;
  return link;
}

TEST(Cavities, ClaimsOfTheModelAreBelievedWhereTheyMayBe) {
  // The filled cavity is right where the link of its holes could not be opened.
  Layers filled = cavity();
  filled.pictures[kBetweenHoles] = kPlate;
  Case c = build(filled);
  const ContourId hole(1U);
  c.model.void_links = {claim(1, hole, hole, LinkFate::unrealisable)};
  CheckReport report = checked(c);
  EXPECT_TRUE(report.pass()) << testing::text(report);
  EXPECT_EQ(report.unrealisable_voids, 1U);
  EXPECT_EQ(report.expected_cavities, 2U);
  CheckOptions strict;
  strict.strict = true;
  EXPECT_EQ(failed(c, strict), Conditions{"5.10"});
  c.model.void_links = {claim(1, hole, ContourId(), LinkFate::unrealisable)};
  EXPECT_EQ(failed(c), (Conditions{"5.2", "5.4", "5.7"}));

  // Two holes that are one, because no wall could stand between.
  Layers leak = layers({kSolid, kPair, kPair, kSolid}, {kPlate, kTwoHoles, kPlate});
  set(leak, kBetweenHoles, 3, 2, '.');
  c = build(leak);
  c.model.void_links = {claim(1, ContourId(1U), ContourId(2U), LinkFate::forced)};
  report = checked(c);
  EXPECT_TRUE(report.pass()) << testing::text(report);
  EXPECT_EQ(report.forced_voids, 1U);
  EXPECT_EQ(failed(c, strict), Conditions{"5.10"});
  c.model.void_links.push_back(c.model.void_links[0]);
  EXPECT_EQ(failed(c), Conditions{"5.2"});
}

TEST(Cavities, DecisionsAndLabelsCount) {
  Layers filled = cavity();
  filled.pictures[kBetweenHoles] = kPlate;
  const Case c = build(filled);
  CheckOptions options;
  const ContourId hole(1U);
  options.correspondence.voids.decisions = {{SlabId(1U), hole, hole, false}};
  EXPECT_EQ(failed(c, options), Conditions{});
  options.correspondence.voids.decisions.clear();
  options.correspondence.voids.labels = {{SectionId(1U), hole, 1}, {SectionId(2U), hole, 2}};
  EXPECT_EQ(failed(c, options), Conditions{});
  // A label that cannot be one void: the middle hole and the outside are another one.
  const Case three = build(
      layers({kSolid, kOneHole, kOneHole, kOneHole, kSolid}, {kPlate, kHoled, kHoled, kPlate}));
  options.correspondence.voids.labels = {
      {SectionId(1U), hole, 1}, {SectionId(2U), hole, 2}, {SectionId(3U), hole, 1}};
  options.correspondence.voids.decisions = {{SlabId(1U), ContourId(), hole, true}};
  const Conditions conditions = failed(three, options);
  EXPECT_EQ(conditions.count("5.1"), 1U);
  options.correspondence.voids.decisions = {{SlabId(0U), ContourId(), ContourId(), true}};
  const auto refused = check(three.model, three.stack, options);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
}

TEST(Cavities, NothingIsAskedWhereItMakesNoSense) {
  Case c = drilled();
  CheckOptions options;
  options.correspondence.voids.rule = VoidRule::free;
  CheckReport report = checked(c, options);
  EXPECT_TRUE(report.pass());
  EXPECT_NE(report.guarantees[4].not_asked, "");
  EXPECT_EQ(report.cavities, 1U);
  EXPECT_FALSE(report.expected_cavities.has_value());
  EXPECT_FALSE(report.least_genus.has_value());
  c.model.tets.raw().pop_back();
  report = checked(c);
  EXPECT_FALSE(report.guarantees[1].pass);
  EXPECT_FALSE(report.guarantees[4].pass);
  EXPECT_NE(report.guarantees[4].not_asked, "");
  EXPECT_TRUE(report.guarantees[4].failures.empty());
  EXPECT_FALSE(report.cavities.has_value());
  EXPECT_TRUE(report.expected_cavities.has_value());
}

}  // namespace
}  // namespace tetloft
