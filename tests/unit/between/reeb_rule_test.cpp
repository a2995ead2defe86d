// The Reeb rule on fields made by hand.
#include "between/reeb_rule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "between/trace_shapes.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

constexpr double kStep = 0.1;

struct Counts {
  std::vector<std::size_t> regions, holes;  // by layer between
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts(const FieldSlab& slab) {
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  EXPECT_FALSE(traced.inner.sections.empty());
  Counts result;
  for (const InnerSection& section : traced.inner.sections) {
    result.regions.push_back(section.nesting.outer.size());
    result.holes.push_back(section.section.contours.size() - section.nesting.outer.size());
  }
  return result;
}

// A sheet between two plates: fourteen scraps are left of it in the middle.
double scraps(double x, double y) {
  double v = 1;
  for (int k = 0; k < 14; ++k) {
    const double x0 = -3.5 + 0.5 * k;
    v = std::min(v, to_box(x, y, x0 + 0.06, -0.15 + 0.1 * (k % 2), x0 + 0.44, 0.15));
  }
  return v;
}

TEST(ReebRule, ScrapsOfASheetAreJoined) {
  const auto sheet = [](double x, double y, std::size_t layer) {
    return layer == 2 ? scraps(x, y) : to_box(x, y, -3.5, -0.2, 3.5, 0.2);
  };
  const std::vector<Contour> plate{rectangle(-3.5, -0.2, 3.5, 0.2)};
  EXPECT_EQ(counts(FieldSlab({{plate, plate, sheet}}, kStep, 3)), (Counts{{1, 1, 1}, {0, 0, 0}}));
  // Of one layer alone, between given ones.
  const auto only = [](double x, double y, std::size_t) { return scraps(x, y); };
  EXPECT_EQ(counts(FieldSlab({{plate, plate, only}}, kStep, 1)), (Counts{{1}, {0}}));
}

TEST(ReebRule, PlatesThinnerThanTheLatticeJoinTheirScraps) {
  const std::vector<Contour> plate{rectangle(-3.5, 0.033, 3.5, 0.047)};
  const auto only = [](double x, double y, std::size_t) { return scraps(x, y); };
  EXPECT_EQ(counts(FieldSlab({{plate, plate, only}}, kStep, 1)), (Counts{{1}, {0}}));
}

TEST(ReebRule, TwoLegsOfOneRegionAreTwo) {
  const auto legs = [](double x, double y, std::size_t) {
    return std::min(to_disc(x, y, -1.5, 0, 0.7), to_disc(x, y, 1.5, 0, 0.7));
  };
  const FieldSlab slab({{{octagon(-1.5, 0, 0.7), octagon(1.5, 0, 0.7)}, {octagon(0, 0, 3)}, legs}},
                       kStep, 2);
  EXPECT_EQ(counts(slab), (Counts{{2, 2}, {0, 0}}));
}

TEST(ReebRule, ThreeRegionsOfAZigzagStayThree) {
  // Two below and two above, each of the middle ones over the gap of the others.
  const auto discs = [](double x, double y, std::size_t) {
    return std::min(
        {to_disc(x, y, -3, 0, 0.6), to_disc(x, y, 0, 0, 0.6), to_disc(x, y, 3, 0, 0.6)});
  };
  const FieldSlab slab({{{rectangle(-3.6, -0.6, -2.4, 0.6), rectangle(-0.6, -0.6, 3.6, 0.6)},
                         {rectangle(-3.6, -0.6, 0.6, 0.6), rectangle(2.4, -0.6, 3.6, 0.6)},
                         discs}},
                       kStep, 1);
  EXPECT_EQ(counts(slab), (Counts{{3}, {0}}));
}

TEST(ReebRule, WhatFloatsIsDropped) {
  const auto with_ball = [](double x, double y, std::size_t layer) {
    const double rod = to_disc(x, y, -2, 0, 1);
    return layer == 1 ? rod : std::min(rod, to_disc(x, y, 2, 0, 0.8));
  };
  const std::vector<Contour> rod{octagon(-2, 0, 1)};
  const FieldSlab slab({{rod, rod, with_ball}}, kStep, 3);
  EXPECT_EQ(counts(slab), (Counts{{1, 1, 1}, {0, 0, 0}}));
  ClassShapes shapes = slab.shapes();
  const std::vector<LayerLink> one{{RegionId(0), RegionId(0)}};
  for (const auto& links : trace_shapes(slab.slab(), shapes).inner.links) EXPECT_EQ(links, one);
}

TEST(ReebRule, JoinsKeepOffOtherClasses) {
  // A wall of another class with one gate parts the two scraps.
  const std::vector<Contour> plate{rectangle(-3, -2, 3, 2)};
  const auto halves = [](double x, double y, std::size_t) {
    return std::min(to_box(x, y, -3, -2, -0.8, 2), to_box(x, y, 0.8, -2, 3, 2));
  };
  const auto wall = [](double x, double y, std::size_t) {
    return std::max(to_box(x, y, -0.25, -2.5, 0.25, 2.5), 0.35 - std::abs(y - 1));
  };
  const FieldSlab slab({{plate, plate, halves},
                        {{rectangle(-0.2, -3, 0.2, -2.1)}, {rectangle(-0.2, -3, 0.2, -2.1)}, wall}},
                       kStep, 1);
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  const ClassShape& shape = shapes[ClassId(0)];
  std::size_t joined = 0;
  for (std::int64_t i = -7; i <= 7; ++i) {
    for (std::int64_t j = -19; j <= 19; ++j) {
      if (!(shape.value[1][shape.window.place(i, j)] < 0)) continue;
      ++joined;
      EXPECT_NEAR(static_cast<double>(j), 10, 3.5);
    }
  }
  EXPECT_GE(joined, 15U);
}

double ring(double x, double y, double outer, double inner) {
  return std::max(to_disc(x, y, 0, 0, outer), -to_disc(x, y, 0, 0, inner));
}

TEST(ReebRule, ACavityIsFilled) {
  const std::vector<Contour> disc{octagon(0, 0, 2)};
  const auto hollow = [](double x, double y, std::size_t layer) {
    return layer == 2 ? ring(x, y, 2, 1) : to_disc(x, y, 0, 0, 2);
  };
  EXPECT_EQ(counts(FieldSlab({{disc, disc, hollow}}, kStep, 3)), (Counts{{1, 1, 1}, {0, 0, 0}}));
}

TEST(ReebRule, ACavityBehindAWallThinnerThanItIsDeepIsOpened) {
  const std::vector<Contour> disc{octagon(0, 0, 2)};
  const auto hollow = [](double x, double y, std::size_t layer) {
    return layer == 2 ? ring(x, y, 2, 1.7) : to_disc(x, y, 0, 0, 2);
  };
  const FieldSlab slab({{disc, disc, hollow}}, kStep, 3);
  EXPECT_EQ(counts(slab), (Counts{{1, 1, 1}, {0, 0, 0}}));
  ClassShapes shapes = slab.shapes();
  (void)trace_shapes(slab.slab(), shapes);
  const ClassShape& shape = shapes[ClassId(0)];
  EXPECT_GT(shape.value[2][shape.window.place(0, 0)], 0);
}

TEST(ReebRule, AHoleOpenToOneSideIsAPit) {
  const std::vector<Contour> disc{octagon(0, 0, 2)};
  const auto pit = [](double x, double y, std::size_t layer) {
    return layer >= 2 ? ring(x, y, 2, 1) : to_disc(x, y, 0, 0, 2);
  };
  const FieldSlab from_above({{disc, {octagon(0, 0, 2), octagon(0, 0, 1)}, pit}}, kStep, 3);
  EXPECT_EQ(counts(from_above), (Counts{{1, 1, 1}, {0, 1, 1}}));
  // Open to the exterior of a layer that the disc does not reach.
  const FieldSlab lone({{disc,
                         {},
                         [](double x, double y, std::size_t layer) {
                           return layer == 2 ? ring(x, y, 1.9, 1) : to_disc(x, y, 0, 0, 2);
                         }}},
                       kStep, 2);
  EXPECT_EQ(counts(lone), (Counts{{1, 1}, {0, 1}}));
}

TEST(ReebRule, AHoleFromEndToEndStays) {
  const std::vector<Contour> tube{octagon(0, 0, 2), octagon(0, 0, 1)};
  const auto field = [](double x, double y, std::size_t) { return ring(x, y, 2, 1); };
  EXPECT_EQ(counts(FieldSlab({{tube, tube, field}}, kStep, 2)), (Counts{{1, 1}, {1, 1}}));
}

TEST(ReebRule, AHandleThatOpensAndClosesIsFilled) {
  // A ring that lies flat between a post below and nothing above.
  const auto flat_ring = [](double x, double y, std::size_t layer) {
    if (layer == 2) return ring(x, y, 2, 0.9);
    return layer == 1 ? to_disc(x, y, 1.5, 0, 0.4) : 1.0;
  };
  const FieldSlab slab({{{octagon(1.5, 0, 0.4)}, {}, flat_ring}}, kStep, 3);
  EXPECT_EQ(counts(slab), (Counts{{1, 1, 0}, {0, 0, 0}}));
}

TEST(ReebRule, OfTwoHolesConnectedOnBothSidesTheDeeperStays) {
  // A bar across a tube, in one layer, nearer to one side.
  const std::vector<Contour> tube{octagon(0, 0, 2.5), octagon(0, 0, 1.8)};
  const auto bar = [](double x, double y, std::size_t layer) {
    const double pipe = ring(x, y, 2.5, 1.8);
    return layer == 2 ? std::min(pipe, to_box(x, y, 0.2, -2, 1.3, 2)) : pipe;
  };
  const FieldSlab slab({{tube, tube, bar}}, kStep, 3);
  EXPECT_EQ(counts(slab), (Counts{{1, 1, 1}, {1, 1, 1}}));
  ClassShapes shapes = slab.shapes();
  (void)trace_shapes(slab.slab(), shapes);
  const ClassShape& shape = shapes[ClassId(0)];
  EXPECT_GT(shape.value[2][shape.window.place(-8, 0)], 0);
  EXPECT_LT(shape.value[2][shape.window.place(7, 0)], 0);
  EXPECT_LT(shape.value[2][shape.window.place(15, 0)], 0);
}

TEST(ReebRule, AHoleThatHoldsAnotherClassIsNotFilled) {
  const std::vector<Contour> disc{octagon(0, 0, 3)};
  const auto hollow = [](double x, double y, std::size_t layer) {
    return layer == 2 ? ring(x, y, 3, 0.7) : to_disc(x, y, 0, 0, 3);
  };
  // The other class passes the whole slab beside it, and has an arm into the hole.
  const auto other = [](double x, double y, std::size_t layer) {
    return layer == 2 ? std::min(to_disc(x, y, 4, 0, 0.5), to_disc(x, y, 0, 0, 0.4))
                      : to_disc(x, y, 4, 0, 0.5);
  };
  const std::vector<Contour> post{octagon(4, 0, 0.5)};
  const FieldSlab slab({{disc, disc, hollow}, {post, post, other}}, kStep, 3);
  ClassShapes shapes = slab.shapes();
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  compete(shapes, meetings);
  apply_reeb_rule({slab.slab(), shapes, meetings}, ClassId(0), ApartParts::stay);
  const ClassShape& shape = shapes[ClassId(0)];
  EXPECT_GT(shape.value[2][shape.window.place(0, 0)], 0);
  EXPECT_GT(shape.value[2][shape.window.place(5, 0)], 0);
}

TEST(ReebRule, JoinsDoNotTouchThirdParts) {
  // Between two halves that are to be one stands a third part, which is over another region and
  // under nothing. The cheapest way leads through it.
  const std::vector<Contour> lower{rectangle(-3, -2, 3, -0.9), rectangle(-0.5, 1, 0.5, 3)};
  const std::vector<Contour> upper{rectangle(-3, -2, 3, -0.9)};
  const auto field = [](double x, double y, std::size_t) {
    return std::min({to_box(x, y, -3, -2, -1, 2), to_box(x, y, 1, -2, 3, 2),
                     to_box(x, y, -0.6, -0.45, 0.6, 3)});
  };
  const FieldSlab slab({{lower, upper, field}}, kStep, 1);
  ClassShapes shapes = slab.shapes();
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  const LayerGraph graph =
      apply_reeb_rule({slab.slab(), shapes, meetings}, ClassId(0), ApartParts::stay);
  EXPECT_EQ(graph.layers[1].size.size(), 2U);
  EXPECT_EQ(graph.edges[1], (std::vector<LayerEdge>{{0, 0}}));
}

TEST(ReebRule, OverlapOfAHundredthIsALinkTooWhereSamplesShowNone) {
  const FieldSlab slab(
      {{{rectangle(-5, -0.15, 0.125, 0.15)},
        {rectangle(0.1, -0.15, 0.7, 0.15)},
        [](double x, double y, std::size_t) { return to_box(x, y, 0.11, -0.15, 0.71, 0.15); }}},
      kStep, 1);
  ClassShapes shapes = slab.shapes();
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  EXPECT_TRUE(apply_reeb_rule({slab.slab(), shapes, meetings}, ClassId(0), ApartParts::stay)
                  .edges[0]
                  .empty());
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  ASSERT_EQ(traced.inner.links.size(), 2U);
  EXPECT_EQ(traced.inner.links[0], (std::vector<LayerLink>{{RegionId(0), RegionId(0)}}));
}

TEST(ReebRule, IslandsInHolesAreRegionsOfTheirOwn) {
  const std::vector<Contour> tube{octagon(0, 0, 3), octagon(0, 0, 2)};
  const std::vector<Contour> core{octagon(0, 0, 1.2), octagon(0, 0, 0.5)};
  const FieldSlab slab(
      {{tube, tube, [](double x, double y, std::size_t) { return ring(x, y, 3, 2); }},
       {core, core, [](double x, double y, std::size_t) { return ring(x, y, 1.2, 0.5); }}},
      kStep, 2);
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  ASSERT_EQ(traced.inner.sections.size(), 2U);
  for (const InnerSection& section : traced.inner.sections) {
    ASSERT_EQ(section.section.contours.size(), 4U);
    ASSERT_EQ(section.class_of.size(), 2U);
    EXPECT_EQ(section.class_of[RegionId(0)], ClassId(0));
    EXPECT_EQ(section.class_of[RegionId(1)], ClassId(1));
  }
  const std::vector<LayerLink> each{{RegionId(0), RegionId(0)}, {RegionId(1), RegionId(1)}};
  for (const auto& links : traced.inner.links) EXPECT_EQ(links, each);
}

TEST(ReebRule, WhatMovesIsComparedInTheMiddleOfItsWay) {
  // A rod that leans by its width from layer to layer; beside it another part of the same class,
  // over which it passes.
  const auto lean = [](double x, double y, std::size_t layer) {
    return to_disc(x, y, -3 + 1.2 * static_cast<double>(layer), 0, 0.5);
  };
  const FieldSlab slab({{{octagon(-3, 0, 0.5)}, {octagon(0.6, 0, 0.5)}, lean}}, kStep, 2);
  ClassShapes still = slab.shapes();
  EXPECT_EQ(trace_shapes(slab.slab(), still).left_apart, std::vector<ClassId>{ClassId(0)});
  ClassShapes moving = slab.shapes();
  for (Point2& u : moving[ClassId(0)].motion) u = {36, 0};
  const TracedShapes traced = trace_shapes(slab.slab(), moving);
  EXPECT_TRUE(traced.left_apart.empty());
  EXPECT_EQ(traced.inner.sections.size(), 2U);
}

}  // namespace
}  // namespace tetloft::testing
