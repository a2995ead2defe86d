// Whole models: trimming, Gabriel refinement, finer contours, reports, progress.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

ReconstructOptions with_labels(std::string_view labels) {
  ReconstructOptions options;
  options.correspondence.labels = labels_from(labels);
  return options;
}

TEST(Trimming, LimitsTheOvershootOfTheBunny) {
  const auto checked = reconstruct_and_check(sample("bunny.cnt"));
  ASSERT_TRUE(checked);
  EXPECT_LT(checked->report.overshoot, 0.75);
  EXPECT_EQ(checked->report.components, 1U);
}

TEST(Trimming, SparesAMidpointThatAloneJoinsTwoParts) {
  const auto checked = reconstruct_and_check(sample("cases/joined_by_midpoint.cnt"),
                                             with_labels("1 0 891\n0 0 702\n0 1 702"));
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->result.model.component_count, 2U);
}

TEST(GabrielRefinement, ConnectsRegionsWithoutADelaunayEdgeBetweenThem) {
  ReconstructOptions options = with_labels("0 0 1\n0 1 3\n1 0 1\n1 1 2");
  options.divide_coarse = false;
  const auto checked = reconstruct_and_check(sample("cases/shielded.cnt"), options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(fired(checked->result, Rule::gabriel_refinement), 1U);
}

// Nonato et al. 2000, figure 16: bars of four vertices, and two across them. Between so coarse
// contours D has no tet that could leave the tunnel open.
TEST(Refinement, OpensATunnelThatCoarseContoursClose) {
  const SectionStack coarse = sample("cases/crossed_bars.cnt");
  ReconstructOptions as_it_comes;
  as_it_comes.correspondence.voids.rule = VoidRule::free;
  const auto divided = reconstruct_and_check(coarse, as_it_comes);
  ASSERT_TRUE(divided);
  EXPECT_EQ(divided->report.genus, std::vector<long>{1});
  as_it_comes.divide_coarse = false;
  const auto closed = reconstruct_and_check(coarse, as_it_comes);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->report.genus, std::vector<long>{0});
  const auto asked = reconstruct_and_check(coarse);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->report.genus, std::vector<long>{1});
  const auto finer = refine(coarse, 2.5);
  ASSERT_TRUE(finer);
  const auto open = reconstruct_and_check(finer->stack);
  ASSERT_TRUE(open);
  EXPECT_EQ(open->report.genus, std::vector<long>{1});
}

// Every edge in four, by points rounded once.
SectionStack refined(const SectionStack& stack) {
  SectionStack result = stack;
  for (Section& section : result.sections) {
    for (Contour& contour : section.contours) {
      const std::vector<Point2> coarse = contour.vertices;
      contour.vertices.clear();
      for (std::size_t i = 0; i < coarse.size(); ++i) {
        const Point2& a = coarse[i];
        const Point2& b = coarse[(i + 1) % coarse.size()];
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
          contour.vertices.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
      }
    }
  }
  return result;
}

TEST(Refinement, OfContoursChangesNeitherComponentsNorGenus) {
  for (const char* name : {"torus.cnt", "bifurcation.cnt"}) {
    SCOPED_TRACE(name);
    const SectionStack stack = sample(name);
    const auto coarse = reconstruct_and_check(stack);
    const auto fine = reconstruct_and_check(refined(stack));
    ASSERT_TRUE(coarse && fine);
    EXPECT_EQ(coarse->report.components, 1U);
    EXPECT_EQ(fine->report.components, 1U);
    const std::vector<long> genus{std::string(name) == "torus.cnt" ? 1 : 0};
    EXPECT_EQ(coarse->report.genus, genus);
    EXPECT_EQ(fine->report.genus, genus);
  }
}

TEST(Reconstruct, OfAValidStackGivesTheModelOfTheStack) {
  const SectionStack stack = sample("torus.cnt");
  const auto valid = ValidStack::of(stack);
  ASSERT_TRUE(valid.ok());
  const auto result = reconstruct(*valid);
  const auto expected = reconstruct(stack);
  ASSERT_TRUE(result.ok() && expected.ok());
  EXPECT_EQ(result->model.points.raw(), expected->model.points.raw());
  EXPECT_EQ(result->model.tets.raw(), expected->model.tets.raw());
}

TEST(Reconstruct, RefusesWhatIsLeftOfAValidStack) {
  auto valid = ValidStack::of(sample("torus.cnt"));
  ASSERT_TRUE(valid.ok());
  EXPECT_FALSE((*std::move(valid)).take().sections.empty());
  const auto result = reconstruct(*valid);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(to_string(result.error()), to_string(reconstruct(SectionStack()).error()));
}

TEST(Report, CountsWhatTheModelHolds) {
  const SectionStack stack = sample("torus.cnt");
  const auto checked = reconstruct_and_check(stack);
  ASSERT_TRUE(checked);
  const Model& model = checked->result.model;
  const ReconstructReport& report = checked->result.report;
  EXPECT_EQ(report.slices, stack.sections.size());
  EXPECT_EQ(report.contours, stack.contour_count());
  EXPECT_EQ(report.input_vertices, stack.vertex_count());
  EXPECT_EQ(report.vertices, model.points.size());
  EXPECT_EQ(report.tets, model.tets.size());
  EXPECT_EQ(report.components, model.component_count);
  EXPECT_EQ(report.components, checked->report.components);
  EXPECT_EQ(report.volume, volume(model));
  EXPECT_EQ(report.split_vertices,
            static_cast<std::size_t>(
                std::count(model.origin.begin(), model.origin.end(), PointOrigin::contour_split)));
  EXPECT_EQ(report.input_vertices,
            static_cast<std::size_t>(
                std::count(model.origin.begin(), model.origin.end(), PointOrigin::input)));
}

TEST(Provenance, HasOneEntryForEachTetAndPoint) {
  const auto checked = reconstruct_and_check(sample("bifurcation.cnt"));
  ASSERT_TRUE(checked);
  const Model& m = checked->result.model;
  ASSERT_EQ(m.component.size(), m.tets.size());
  ASSERT_EQ(m.slab.size(), m.tets.size());
  ASSERT_EQ(m.kind.size(), m.tets.size());
  ASSERT_EQ(m.section.size(), m.points.size());
  ASSERT_EQ(m.contour.size(), m.points.size());
  ASSERT_EQ(m.origin.size(), m.points.size());
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const bool in_section = m.origin[VertexId(v)] == PointOrigin::input ||
                            m.origin[VertexId(v)] == PointOrigin::contour_split;
    EXPECT_EQ(m.section[VertexId(v)].valid(), in_section);
    EXPECT_EQ(m.contour[VertexId(v)].valid(), in_section);
  }
}

TEST(Progress, NeverExceedsItsTotal) {
  ReconstructOptions options = with_labels("0 0 1\n0 1 3\n1 0 1\n1 1 2");
  options.execution.progress = [](std::size_t done, std::size_t all) { EXPECT_LE(done, all); };
  ASSERT_TRUE(reconstruct(sample("cases/shielded.cnt"), options).ok());
}

TEST(Progress, CountsUpToItsTotal) {
  for (const unsigned threads : {1U, 3U}) {
    std::vector<std::size_t> done;
    std::size_t all = 0;
    ReconstructOptions options;
    options.execution.threads = threads;
    options.execution.progress = [&](std::size_t d, std::size_t a) {
      done.push_back(d);
      all = a;
    };
    ASSERT_TRUE(reconstruct(sample("bifurcation.cnt"), options).ok());
    ASSERT_FALSE(done.empty());
    EXPECT_EQ(done.back(), all);
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  }
}

}  // namespace
}  // namespace tetloft::testing
