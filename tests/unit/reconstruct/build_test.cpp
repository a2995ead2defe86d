// Building slabs: where contours are refined, the slabs that this touches are built again and no
// others.
#include "reconstruct/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "reconstruct/stack_errors.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The phases up to building, of a stack.
struct Phases {
  ReconstructOptions options;
  WatchedWork work{options.execution, 0};
  PreparedStack prepared;
  Plan plan;
  std::unique_ptr<Decision> decision;
  std::unique_ptr<SlabBuilds> builds;

  Phases(const SectionStack& stack, ReconstructOptions given) : options(std::move(given)) {
    prepared = prepare(stack, Unit::as_given, options, work).value();
    plan.gabriel.resize(prepared.section_count());
    plan.apart.resize(prepared.section_count());
    plan.divided = prepared.divisions;
    decision = std::make_unique<Decision>(prepared, options);
    plan.correspondence = decision->make(all_ids<SlabId>(prepared.slab_count()), work).value();
    builds = std::make_unique<SlabBuilds>(prepared, decision.get(), plan, options, work);
  }
};

ReconstructOptions labelled(Criterion criterion, std::string_view labels) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.criterion = criterion;
  options.correspondence.labels = labels_from(labels);
  options.divide_coarse = false;  // nothing has to be refined then
  return options;
}

Section at(double z, Section section) {
  section.z = z;
  return section;
}

// The slab of cases/shielded.cnt, which needs refined contours, between others that do not:
// sections 2 and 3 of five.
SectionStack shielded_in_the_middle() {
  const SectionStack slab = sample("cases/shielded.cnt");
  const Section plate = stack_of_boxes({{box(-1000, 0, 200, 100)}}).sections[SectionId(0)];
  SectionStack stack;
  stack.sections.push_back(at(-2, plate));
  stack.sections.push_back(at(-1, plate));
  stack.sections.push_back(at(0, slab.sections[SectionId(0)]));
  stack.sections.push_back(at(1, slab.sections[SectionId(1)]));
  stack.sections.push_back(at(2, plate));
  stack.sections.push_back(at(3, plate));
  return stack;
}

const char* const kShieldedLabels = "2 0 1\n2 1 3\n3 0 1\n3 1 2";

bool same_solid(const SlabSolid& a, const SlabSolid& b) {
  return a.constructed == b.constructed && a.origin == b.origin && a.rules == b.rules &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const Piece& p, const Piece& q) {
                      return p.node == q.node && p.region == q.region && p.kind == q.kind;
                    });
}

TEST(SlabBuilds, WithoutRefinementBuildEachSlabOnce) {
  Phases phases(stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}, {}, {box(0, 0, 1, 1)}}), {});
  EXPECT_FALSE(phases.builds->run());
  EXPECT_EQ(phases.builds->built(), 3U);
  EXPECT_EQ(phases.builds->refinements(), 0U);
  const std::vector<Part> parts = phases.builds->take_parts();
  ASSERT_EQ(parts.size(), 3U);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_EQ(parts[k].slab, SlabId(k));
    EXPECT_EQ(parts[k].lower, SectionId(k));
    EXPECT_EQ(parts[k].upper, SectionId(k + 1));
  }
}

TEST(SlabBuilds, RefinementBuildsTheTouchedSlabsAgainAndNoOthers) {
  for (const Criterion criterion : {Criterion::overlap, Criterion::reverse}) {
    SCOPED_TRACE(static_cast<int>(criterion));
    Phases phases(shielded_in_the_middle(), labelled(criterion, kShieldedLabels));
    const auto links_before = phases.plan.correspondence.links;
    ASSERT_FALSE(phases.builds->run());
    ASSERT_EQ(phases.builds->refinements(), 1U);

    // Of the sections of slab 2 each that was refined touches the slabs at it; and links that
    // changed touch theirs.
    std::vector<bool> touched(5, false);
    for (const SectionId s : phases.plan.gabriel.ids()) {
      if (phases.plan.gabriel[s].empty()) continue;
      EXPECT_TRUE(s == SectionId(2) || s == SectionId(3));
      if (s.index() > 0) touched.at(s.index() - 1) = true;
      if (s.index() < 5) touched.at(s.index()) = true;
    }
    for (const SlabId k : links_before.ids()) {
      if (links_before[k] != phases.plan.correspondence.links[k]) touched.at(k.index()) = true;
    }
    const auto again = static_cast<std::size_t>(std::count(touched.begin(), touched.end(), true));
    EXPECT_TRUE(touched[2]);
    EXPECT_FALSE(touched[0] || touched[4]);
    EXPECT_EQ(phases.builds->built(), 5 + again);
  }
}

TEST(SlabBuilds, SolidsAreThoseOfTheSectionsAndLinksAsRefined) {
  for (const Criterion criterion : {Criterion::overlap, Criterion::reverse}) {
    SCOPED_TRACE(static_cast<int>(criterion));
    Phases phases(shielded_in_the_middle(), labelled(criterion, kShieldedLabels));
    ASSERT_FALSE(phases.builds->run());
    ASSERT_FALSE(phases.builds->triangulate_again(all_ids<SlabId>(5)));
    for (const Part& part : phases.builds->take_parts()) {
      Result<SlabOutcome> alone = build_slab(
          part.slab, phases.prepared.sections[part.lower], phases.prepared.sections[part.upper],
          {phases.plan.correspondence.links[part.slab],
           phases.plan.voids ? &phases.plan.voids->links[part.slab] : nullptr},
          {DelaunayEngine::automatic, kDefaultWorkLimit});
      ASSERT_TRUE(alone.ok());
      ASSERT_TRUE(std::holds_alternative<SlabSolid>(*alone));
      EXPECT_TRUE(same_solid(part.solid, std::get<SlabSolid>(*alone))) << part.slab.index();
    }
    // What the first decision from the refined sections would be.
    Decision anew(phases.prepared, phases.options);
    const auto decided = anew.make(all_ids<SlabId>(5), phases.work);
    ASSERT_TRUE(decided.ok());
    EXPECT_EQ(decided->links, phases.plan.correspondence.links);
    EXPECT_EQ(decided->component, phases.plan.correspondence.component);
  }
}

TEST(SlabBuilds, GiveUpTriangulationsOnceAndHaveThemAgainAsPlanned) {
  for (const unsigned threads : {1U, 2U}) {
    ReconstructOptions options = labelled(Criterion::overlap, kShieldedLabels);
    options.execution.threads = threads;
    Phases phases(shielded_in_the_middle(), options);
    const auto before = phases.prepared.sections;
    ASSERT_FALSE(phases.builds->run());
    std::size_t given_up = 0;
    for (const SectionId s : before.ids()) {
      EXPECT_EQ(phases.prepared.sections[s].triangulation.points.size(),
                phases.prepared.sections[s].vertex_count());
      // Those that were refined, and what is beside them, were needed once more.
      if (!phases.prepared.is_triangulated(s)) ++given_up;
    }
    EXPECT_FALSE(phases.prepared.is_triangulated(SectionId(0)));
    EXPECT_FALSE(phases.prepared.is_triangulated(SectionId(5)));
    EXPECT_LT(given_up, 6U);
    ASSERT_FALSE(phases.builds->triangulate_again(all_ids<SlabId>(5)));
    for (const SectionId s : before.ids()) {
      const ConformingSection& again = phases.prepared.sections[s];
      EXPECT_EQ(again.gabriel, phases.plan.gabriel[s]);
      if (!again.gabriel.empty()) continue;
      EXPECT_EQ(again.triangulation.triangles.raw(), before[s].triangulation.triangles.raw());
      EXPECT_EQ(again.next.raw(), before[s].next.raw());
      EXPECT_EQ(again.edges.size(), before[s].edges.size());
    }
  }
}

TEST(SlabBuilds, EndsStandOnSectionsThatKeepTheirTriangles) {
  Phases phases(stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}}), {});
  phases.plan.ends = EndPlanes{-1, 3};
  ASSERT_FALSE(phases.builds->run());
  EXPECT_TRUE(phases.prepared.is_triangulated(SectionId(0)));
  EXPECT_FALSE(phases.prepared.is_triangulated(SectionId(1)));
  EXPECT_TRUE(phases.prepared.is_triangulated(SectionId(2)));
}

TEST(SlabBuilds, OnlyContoursOfTheClassAreRefined) {
  Phases phases(shielded_in_the_middle(), labelled(Criterion::overlap, kShieldedLabels));
  ASSERT_FALSE(phases.builds->run());
  for (const std::size_t s : {std::size_t{2}, std::size_t{3}}) {
    const SectionId section(s);
    const auto& gabriel = phases.plan.gabriel[section];
    ASSERT_FALSE(gabriel.empty());
    // Contour 0 carries label 1, which is what no Delaunay edge joins.
    for (const ContourId c : gabriel.ids()) EXPECT_EQ(gabriel[c], c == ContourId(0)) << s;
    EXPECT_EQ(phases.prepared.sections[section].gabriel, gabriel);
  }
}

TEST(SlabBuilds, RegionsThatNoRefinementConnectsAreNamed) {
  // Columns at either side of a wall; the label asks for a body that would cross it.
  const std::vector<Contour> columns{box(0, 0, 1, 1), box(50, -200, 51, 200), box(100, 0, 101, 1)};
  Phases phases(stack_of_boxes({columns, columns}),
                labelled(Criterion::overlap, "0 0 1\n0 1 2\n0 2 3\n1 0 4\n1 1 2\n1 2 1"));
  const std::optional<Error> error = phases.builds->run();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::unrepresentable);
  EXPECT_EQ(error->where.slab, 0U);
  EXPECT_NE(error->message.find("section 0 contour 0"), std::string::npos) << error->message;
  EXPECT_NE(error->message.find("section 1 contour 2"), std::string::npos) << error->message;
  EXPECT_EQ(error->message.find("contour 1"), std::string::npos) << error->message;
  EXPECT_EQ(phases.builds->refinements(), 1U);
  EXPECT_EQ(phases.builds->built(), 2U);
}

TEST(SlabBuilds, EndsArePartsOfTheFirstAndLastSlab) {
  Phases phases(stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}}), {});
  phases.plan.ends = EndPlanes{-0.5, 2.5};
  ASSERT_FALSE(phases.builds->run());
  const std::vector<Part> parts = phases.builds->take_parts();
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts.front().slab, SlabId(0));
  EXPECT_FALSE(parts.front().lower.valid());
  EXPECT_EQ(parts.front().upper, SectionId(0));
  EXPECT_EQ(parts.back().slab, SlabId(1));
  EXPECT_EQ(parts.back().lower, SectionId(2));
  EXPECT_FALSE(parts.back().upper.valid());
  for (const Point3& p : parts.front().solid.constructed) EXPECT_EQ(p.z, -0.5);
  for (const Point3& p : parts.back().solid.constructed) EXPECT_EQ(p.z, 2.5);
}

// A wall with vertices so dense that no edge of D passes through it.
Contour dense_wall() {
  Contour wall;
  for (int k = -80; k <= 80; ++k) wall.vertices.push_back({3, 0.25 * k});
  for (int k = 80; k >= -80; --k) wall.vertices.push_back({2, 0.25 * k});
  return wall;
}

// Nothing in the rule links what lies on either side of the wall; a plan that does, by a link of
// any evidence, is as one whose rule did.
struct WallsBetween {
  SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1), dense_wall()}, {dense_wall(), box(4, 0, 5, 1)}});
  Link link{SlabId(0), RegionId(0), RegionId(1)};

  WallsBetween() {
    const Nesting below = nest(stack.sections[SectionId(0)]);
    const Nesting above = nest(stack.sections[SectionId(1)]);
    link.lower = below.region[ContourId(0)];
    link.upper = above.region[ContourId(1)];
  }
  void add_to(Plan& plan, Evidence evidence) const {
    LinkCandidate candidate{link, evidence};
    candidate.distance = 3;
    add_candidate(plan.correspondence.candidates[SlabId(0)], candidate);
    std::vector<Link>& links = plan.correspondence.links[SlabId(0)];
    links.push_back(link);
    std::sort(links.begin(), links.end());
  }
};

TEST(SlabBuilds, DropALinkThatNoEdgeCanMake) {
  const WallsBetween walls;
  for (const Evidence evidence : {Evidence::motion, Evidence::chain, Evidence::lone}) {
    Phases phases(walls.stack, {});
    const std::vector<Link> before = phases.plan.correspondence.links[SlabId(0)];
    walls.add_to(phases.plan, evidence);
    EXPECT_FALSE(phases.builds->run());
    EXPECT_EQ(phases.plan.correspondence.links[SlabId(0)], before);
    EXPECT_EQ(phases.builds->refinements(), 1U);  // contours were divided first
    EXPECT_EQ(phases.builds->built(), 3U);
  }
}

TEST(SlabBuilds, RefuseALinkThatNoEdgeCanMakeWhereItWasAskedFor) {
  const WallsBetween walls;
  for (const Evidence evidence : {Evidence::label, Evidence::decision}) {
    Phases phases(walls.stack, {});
    walls.add_to(phases.plan, evidence);
    const auto error = phases.builds->run();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::unrepresentable);
    EXPECT_EQ(error->where.slab, 0U);
  }
}

}  // namespace
}  // namespace tetloft::testing
