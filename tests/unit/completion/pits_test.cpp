// Pits stay open: holes under the exterior of the other section.
#include "completion/pits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Contour rectangle_hole() { return box(2, -3, 8, 3); }
Contour plate() { return box(-10, -10, 10, 10); }
Contour half_plate() { return box(-10, -10, -4, 10); }

SectionStack refined(const SectionStack& stack, double length) {
  Result<Refined> result = refine(stack, length);
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result->stack);
}

// One body without handle and cavity?
void expect_ball(const SectionStack& stack) {
  const auto checked = reconstruct_and_check(stack);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->report.components, 1U);
  EXPECT_EQ(checked->report.genus.size(), 1U);
  EXPECT_EQ(std::accumulate(checked->report.genus.begin(), checked->report.genus.end(), 0L), 0);
}

TEST(Pits, StayOpen) {
  const SectionStack stack = sample("cases/pit.cnt");
  const auto checked = reconstruct_and_check(stack);
  ASSERT_TRUE(checked);
  EXPECT_EQ(fired(checked->result, Rule::opened_pit), 1U);
  expect_ball(stack);
}

TEST(Pits, StayOpenBelow) {
  expect_ball(stack_of_boxes({{half_plate()}, {plate(), rectangle_hole()}, {plate()}}));
}

TEST(Pits, StayOpenWhenContoursAreRefined) {
  const SectionStack stack = sample("cases/pit.cnt");
  for (const double length : {11.0, 7.0, 5.0, 2.5, 1.0, 0.4}) {
    SCOPED_TRACE(length);
    expect_ball(refined(stack, length));
  }
}

TEST(Pits, StayOpenOnBothSidesOfASection) {
  // A through hole.
  const auto checked = reconstruct_and_check(
      stack_of_boxes({{half_plate()}, {plate(), rectangle_hole()}, {half_plate()}}));
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->report.genus, std::vector<long>{1});
  EXPECT_EQ(fired(checked->result, Rule::opened_pit), 2U);
}

TEST(Pits, OfBothSectionsOfASlabAreOpened) {
  // Plates that overlap between their holes.
  const auto checked = reconstruct_and_check(
      refined(stack_of_boxes({{box(-10, -10, 10, 10), box(-8, -0.5, -7, 0.5)},
                              {box(-4, -10, 16, 10), box(13, -0.5, 14, 0.5)}}),
              2));
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->report.genus, std::vector<long>{2});
  EXPECT_EQ(fired(checked->result, Rule::opened_pit), 2U);
}

TEST(Pits, UnderSolidStayClosed) {
  for (const double length : {50.0, 5.0, 1.0}) {
    SCOPED_TRACE(length);
    const auto checked = reconstruct_and_check(
        refined(stack_of_boxes({{plate()}, {plate(), rectangle_hole()}, {plate()}}), length));
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->report.components, 1U);
    EXPECT_EQ(checked->report.genus, (std::vector<long>{0, 0}));
    EXPECT_EQ(fired(checked->result, Rule::opened_pit), 0U);
  }
}

TEST(Pits, ThatNothingSealsAreLeftAlone) {
  const auto checked = reconstruct_and_check(
      stack_of_boxes({{plate(), rectangle_hole()}, {box(-10, -10, 10, 10), box(1, -5, 9, 5)}}));
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->report.genus, std::vector<long>{1});
  EXPECT_EQ(fired(checked->result, Rule::opened_pit), 0U);
}

TEST(Pits, PartlyUnderSolidAreOpenedWhereContoursAreFine) {
  const SectionStack stack =
      stack_of_boxes({{plate()}, {plate(), rectangle_hole()}, {box(-10, -10, 4, 10)}});
  for (const double length : {2.0, 1.0, 0.5}) {
    SCOPED_TRACE(length);
    expect_ball(refined(stack, length));
  }
}

TEST(ExteriorVertices, LeaveTheRegionAndItsLabelsAsTheyAre) {
  const SectionStack stack = refined(stack_of_boxes({{plate(), rectangle_hole()}}), 2);
  const Section& section = stack.sections[SectionId(0)];
  const Result<ConformingSection> made = conform(section, SectionId(0));
  ASSERT_TRUE(made.ok());
  const ConformingSection& before = *made;
  const std::vector<Point2> exterior{{20, 0}, {-30, 5}, {5, 0}};
  const ConformingSection after = with_exterior_vertices(before, exterior);
  ASSERT_EQ(after.vertex_count(), before.vertex_count() + exterior.size());

  // Numbers without the exterior vertices are those of before.
  std::vector<PlaneVertexId> old;
  std::size_t next = 0;
  for (std::size_t k = 0; k < after.vertex_count(); ++k) {
    const PlaneVertexId v(k);
    const bool added =
        std::find(exterior.begin(), exterior.end(), after.point(v)) != exterior.end();
    EXPECT_EQ(after.region[v].valid(), !added);
    EXPECT_EQ(after.contour[v].valid(), !added);
    EXPECT_EQ(after.next[v].valid(), !added);
    old.push_back(added ? PlaneVertexId() : PlaneVertexId(next++));
    if (added) continue;
    EXPECT_EQ(after.point(v), before.point(old[k]));
    EXPECT_EQ(after.contour[v], before.contour[old[k]]);
    EXPECT_EQ(after.input_vertex[v], before.input_vertex[old[k]]);
  }
  std::size_t internal = 0;
  for (std::size_t k = 0; k < after.internal.size(); ++k) {
    if (after.internal[TriangleId(k)] == 0) continue;
    ++internal;
    const auto& [a, b, c] = after.triangulation.triangles[TriangleId(k)];
    const TriangleId t = before.find_triangle(old[a.index()], old[b.index()], old[c.index()]);
    ASSERT_TRUE(t.valid());
    EXPECT_NE(before.internal[t], 0);
  }
  EXPECT_EQ(internal, static_cast<std::size_t>(
                          std::count(before.internal.begin(), before.internal.end(), 1)));
  for (const ConformingSection::Edge& edge : after.edges) {
    const PlaneVertexId a = old[edge.a.index()];
    const PlaneVertexId b = old[edge.b.index()];
    const EdgeId e = a.valid() && b.valid() ? before.find_edge(a, b) : EdgeId();
    EXPECT_EQ(edge.kind, e.valid() ? before.edges[e].kind : EdgeKind::external);
  }
}

}  // namespace
}  // namespace tetloft::testing
