// Which edges are divided, and how; and that conform() divides them as it is told.
#include "sections/coarse_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/stacks/generate.hpp"
#include "support/stacks/shapes.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
using sections::divide_coarse_edges;
using sections::divided;
using sections::least_long_edge;
namespace {

Contour turned(Contour c, double angle) {
  Layer layer{std::move(c)};
  rotate(layer, angle);
  return layer.front();
}

// The divisions of the first of some sections, the others beside it.
std::vector<EdgeDivision> divisions(const SectionStack& stack, std::size_t s) {
  std::vector<const Section*> beside;
  if (s > 0) beside.push_back(&stack.sections[SectionId(s - 1)]);
  if (s + 1 < stack.sections.size()) beside.push_back(&stack.sections[SectionId(s + 1)]);
  return divide_coarse_edges(stack.sections[SectionId(s)], beside, least_long_edge(stack));
}

SectionStack over(std::vector<std::vector<Contour>> layers) {
  SectionStack result;
  for (std::size_t s = 0; s < layers.size(); ++s) {
    result.sections.push_back(section(static_cast<double>(s), std::move(layers[s])));
  }
  return result;
}

std::vector<std::uint32_t> parts_of(const std::vector<EdgeDivision>& edges) {
  std::vector<std::uint32_t> parts;
  for (const EdgeDivision& edge : edges) parts.push_back(edge.parts);
  return parts;
}

using Parts = std::vector<std::uint32_t>;

TEST(CoarseEdges, OfTurnedSquaresAreDividedInFour) {
  const Contour square = rectangle(-5, -5, 5, 5);
  for (const double angle : {0.1, 0.5, kPi / 4, 1.3}) {
    const SectionStack stack = over({{square}, {turned(square, angle)}});
    EXPECT_EQ(parts_of(divisions(stack, 0)), Parts(4, 4));
    EXPECT_EQ(parts_of(divisions(stack, 1)), Parts(4, 4));
  }
}

TEST(CoarseEdges, ThatGoOnInEachNeighbourAreNot) {
  const Contour square = rectangle(-5, -5, 5, 5);
  const Contour fine = rectangle({-5, -5}, {5, 5}, 3);
  for (const SectionStack& stack :
       {over({{square}, {square}}), over({{square}, {fine}}), over({{}, {square}, {square}}),
        over({{square}, {square}, {square}}), over({{square}, {}}), over({{square}})}) {
    for (const SectionId s : stack.sections.ids()) {
      EXPECT_TRUE(divisions(stack, s.index()).empty());
    }
  }
  // In one of two they do not; and where contours hold but half of an edge.
  EXPECT_EQ(divisions(over({{square}, {square}, {turned(square, 1)}}), 1).size(), 4U);
  const SectionStack half = over({{square}, {rectangle(-5, -5, 0, 5)}});
  EXPECT_EQ(parts_of(divisions(half, 0)), (Parts{4, 4, 4, 4}));
}

// All but one edge go on: its neighbours on the contour are divided with it, the one across is not.
TEST(CoarseEdges, DivideThoseBesideThemOnTheContour) {
  const SectionStack stack =
      over({{rectangle(-5, -5, 5, 5)}, {contour({{-5, -5}, {5, -5}, {5, 5}, {0, 7}, {-5, 5}})}});
  const std::vector<EdgeDivision> edges = divisions(stack, 0);
  const std::vector<EdgeDivision> expected{
      {ContourId(0), 1, 4}, {ContourId(0), 2, 4}, {ContourId(0), 3, 4}};
  EXPECT_EQ(edges, expected);
}

TEST(CoarseEdges, HaveSixteenPartsAtMost) {
  const SectionStack stack =
      over({{rectangle(-50, -0.5, 50, 0.5)}, {rectangle(-0.5, -50, 0.5, 50)}});
  EXPECT_EQ(parts_of(divisions(stack, 0)), (Parts{16, 4, 16, 4}));
}

TEST(CoarseEdges, AreNoneOfManyVertices) {
  const auto polygon = [](std::size_t n, double phase) {
    return regular_polygon({0, 0}, 9, n, phase);
  };
  EXPECT_TRUE(divisions(over({{polygon(13, 0)}, {polygon(13, 0.2)}}), 0).empty());
  EXPECT_FALSE(divisions(over({{polygon(5, 0)}, {polygon(5, 0.2)}}), 0).empty());
}

// Small contours among many, as in images, are as fine as those; large ones are not.
TEST(CoarseEdges, AreLongAmongThoseOfFineContours) {
  const Contour fine = regular_polygon({0, 0}, 10, 64, 0);
  const Contour shifted = regular_polygon({1, 0}, 10, 64, 0.03);
  const auto beside = [&](double half) { return rectangle(40 - half, -half, 40 + half, half); };
  const auto of = [&](double half) {
    return divisions(over({{fine, beside(half)}, {shifted}, {fine}, {shifted}}), 0).size();
  };
  EXPECT_EQ(of(0.5), 0U);
  EXPECT_EQ(of(5), 0U);
  EXPECT_EQ(of(18), 4U);
  // A section of its own, half of the stack.
  EXPECT_EQ(divisions(over({{rectangle(-3, -3, 3, 3)}, {fine}}), 0).size(), 4U);
  EXPECT_EQ(divisions(over({{rectangle(-1, -1, 1, 1)}, {fine}}), 0).size(), 0U);
  EXPECT_EQ(divisions(over({{rectangle(-3, -3, 3, 3)}, {fine}}), 1).size(), 0U);
}

TEST(CoarseEdges, DependOnTheSetOfContoursAlone) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SectionStack stack = generate(StackKind::coarse_lofts, seed).stack;
    SectionStack other = stack;
    for (Section& section : other.sections) {
      std::reverse(section.contours.begin(), section.contours.end());
      for (Contour& contour : section.contours) contour = reversed(rotated(contour, 1));
    }
    std::reverse(other.sections.begin(), other.sections.end());
    SectionStack scaled = stack;
    for (Section& section : scaled.sections) {
      for (Contour& contour : section.contours) contour = moved(contour, 0x1p-40, {0, 0});
    }
    const std::size_t n = stack.sections.size();
    for (std::size_t s = 0; s < n; ++s) {
      const auto points = [](const SectionStack& of, std::size_t at) {
        std::vector<Point2> all;
        for (const Contour& c : divided(of.sections[SectionId(at)], divisions(of, at)).contours) {
          all.insert(all.end(), c.vertices.begin(), c.vertices.end());
        }
        std::sort(all.begin(), all.end(),
                  [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
        return all;
      };
      EXPECT_EQ(points(stack, s), points(other, n - 1 - s)) << "seed " << seed;
      EXPECT_EQ(divisions(scaled, s), divisions(stack, s)) << "seed " << seed;
    }
  }
}

TEST(Conform, DividesEdgesAsToldAndKeepsTheNumbersOfTheContour) {
  std::size_t inserted = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SectionStack stack = generate(StackKind::coarse_lofts, seed).stack;
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const Section& given = stack.sections[SectionId(s)];
      const std::vector<EdgeDivision> edges = divisions(stack, s);
      const Result<ConformingSection> made = conform(given, SectionId(s), {.divided = edges});
      ASSERT_TRUE(made.ok()) << to_string(made.error());
      std::size_t input = 0;
      std::vector<std::vector<std::size_t>> parts;
      for (const Contour& contour : given.contours) parts.emplace_back(contour.vertices.size(), 0);
      for (const PlaneVertexId v : made->contour.ids()) {
        const std::size_t c = made->contour[v].index();
        ++parts[c][made->edge_of[v]];
        if (made->input_vertex[v] == ConformingSection::kNotInput) continue;
        ++input;
        EXPECT_EQ(made->point(v), given.contours[ContourId(c)].vertices[made->input_vertex[v]]);
      }
      std::size_t vertices = 0;
      for (const Contour& contour : given.contours) vertices += contour.vertices.size();
      EXPECT_EQ(input, vertices);
      for (const EdgeDivision& edge : edges) {
        EXPECT_GE(parts[edge.contour.index()][edge.edge], edge.parts);
        inserted += edge.parts - 1;
      }
      // The set of vertices holds the divided contours.
      const Section whole = divided(given, edges);
      for (const Contour& contour : whole.contours) {
        for (const Point2& p : contour.vertices) {
          const auto& points = made->triangulation.points;
          EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
        }
      }
    }
  }
  EXPECT_GT(inserted, 1000U);
}

TEST(Conform, RefusesDivisionsThatAreNone) {
  const Section square = section(0, {rectangle(0, 0, 1, 1)});
  using Edges = std::vector<EdgeDivision>;
  for (const Edges& edges :
       {Edges{{ContourId(1), 0, 2}}, Edges{{ContourId(0), 4, 2}}, Edges{{ContourId(0), 1, 0}},
        Edges{{ContourId(), 0, 2}}, Edges{{ContourId(0), 1, 2}, {ContourId(0), 1, 2}},
        Edges{{ContourId(0), 1, 2}, {ContourId(0), 0, 2}}}) {
    const auto made = conform(square, SectionId(0), {.divided = edges});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::usage);
  }
  EXPECT_TRUE(conform(square, SectionId(0), {.divided = {{ContourId(0), 3, 1}}}).ok());
}

}  // namespace
}  // namespace tetloft::testing
