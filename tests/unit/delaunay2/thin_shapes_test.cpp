// Shapes far thinner than long: few points are inserted, however thin, or it is refused at once.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "plane_oracles.hpp"

namespace tetloft::test {
namespace {

constexpr double kLength = 5;

void add_triangle(Graph& graph, const Point2& a, const Point2& b, const Point2& c) {
  graph = graph + polygon({a, b, c});
}

/// Triangles one over the other, overlapping in x, with as much room between them as they have
/// height.
Graph stacked(int count, double height, Prng& prng) {
  Graph graph;
  for (int i = 0; i < count; ++i) {
    const double y = 3 * height * i;
    const double x0 = kLength * prng.unit();
    const double x1 = x0 + kLength * (2 * prng.unit() - 1);
    const double share = prng.unit();
    const double rise = height * prng.unit();
    add_triangle(graph, {x0, y}, {x1, y + rise},
                 {x0 + share * (x1 - x0), y + share * rise + height * (prng.unit() - 0.3)});
  }
  return graph;
}

Graph nested(int count, double height, Prng& prng) {
  Graph graph;
  for (int i = 0; i < count; ++i) {
    const double size = 1 - 0.8 * i / count;
    const double skew = 0.06 * (prng.unit() - 0.5) / count;
    add_triangle(graph, {-kLength * size * (1 + skew), -height * size},
                 {kLength * size * (1 - skew), -height * size},
                 {4 * kLength * size * skew, height * size});
  }
  return graph;
}

/// Thin triangles that share a corner.
Graph fan_of_triangles(int count, double height, Prng& prng) {
  Graph graph{{{0, 0}}, {}};
  double angle = 0;
  for (int i = 0; i < count; ++i) {
    const PlaneVertexId first(graph.points.size());
    const PlaneVertexId second(graph.points.size() + 1);
    for (int k = 0; k < 2; ++k) {
      angle += height / kLength * (0.2 + prng.unit());
      const double length = kLength * (0.2 + prng.unit());
      graph.points.push_back({length * std::cos(angle), length * std::sin(angle)});
    }
    graph.segments.push_back({PlaneVertexId(0), first});
    graph.segments.push_back({first, second});
    graph.segments.push_back({second, PlaneVertexId(0)});
  }
  return graph;
}

/// Integers, a few units high.
Graph on_lattice(int count, double height, Prng& prng) {
  Graph graph;
  const auto third = static_cast<std::uint64_t>(kLength / height / 3) + 1;
  for (int i = 0; i < count; ++i) {
    const double y = 4.0 * i;
    const auto start = static_cast<double>(prng.below(third));
    const auto end = static_cast<double>(2 * third + prng.below(third));
    add_triangle(graph, {start, y}, {end, y + static_cast<double>(prng.below(3))},
                 {end - static_cast<double>(2 + prng.below(third)), y + 3});
  }
  return graph;
}

Graph turned(Graph graph, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Point2& p : graph.points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return graph;
}

using Family = Graph (*)(int, double, Prng&);
constexpr std::array<Family, 4> kFamilies{stacked, nested, fan_of_triangles, on_lattice};

void expect_few(const Graph& graph) {
  const Conforming2 c = conform(graph);
  EXPECT_TRUE(respects(c, graph));
  EXPECT_TRUE(is_locally_delaunay(c.triangulation, Trust::library));
  // What a column through every vertex and every segment takes, with what a segment may have
  // before columns are tried.
  EXPECT_LE(c.split.size(), graph.segments.size() * (graph.points.size() + 160));
  if (graph.segments.size() <= 12) {
    EXPECT_LE(c.split.size(), 600U);
  }
}

TEST(ThinShapes, NeedFewPointsHoweverThin) {
  Prng prng(21);
  for (const Family& family : kFamilies) {
    for (const int count : {1, 4, 12}) {
      for (int exponent = 2; exponent <= 12; ++exponent) {
        SCOPED_TRACE(testing::Message()
                     << &family - kFamilies.data() << ": " << count << " of aspect 1e" << exponent);
        expect_few(family(count, kLength * std::pow(10.0, -exponent), prng));
      }
    }
  }
}

TEST(ThinShapes, NeedFewPointsInAnyDirection) {
  // To where the distance of segments is the root of the spacing of doubles.
  Prng prng(22);
  for (const Family& family : kFamilies) {
    for (const int count : {1, 4, 12}) {
      for (int exponent = 2; exponent <= 7; ++exponent) {
        SCOPED_TRACE(testing::Message()
                     << &family - kFamilies.data() << ": " << count << " of aspect 1e" << exponent);
        const double angle = 6.28 * prng.unit();
        expect_few(turned(family(count, kLength * std::pow(10.0, -exponent), prng), angle));
      }
    }
  }
}

TEST(ThinShapes, ThinnerThanDoublesResolveAreRefusedAtOnce) {
  Prng prng(23);
  std::size_t refused = 0;
  for (const Family& family : {kFamilies[0], kFamilies[1], kFamilies[2]}) {
    const Graph graph = turned(family(30, kLength * 1e-12, prng), 0.5);
    const Result<Conforming2> result = conforming_delaunay2(graph.points, graph.segments);
    if (result.ok()) continue;
    ++refused;
    EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
    EXPECT_TRUE(result.error().where.vertex.has_value());
    EXPECT_TRUE(result.error().where.point.has_value());
  }
  EXPECT_GT(refused, 0U);
}

TEST(ThinShapes, PointsDoNotDependOnTheOrderOfTheInput) {
  Prng prng(24);
  for (const Family& family : kFamilies) {
    for (const double height : {1e-4, 1e-7}) {
      const Graph graph = family(8, height, prng);
      const Points before = inserted(conform(graph), graph);
      for (int k = 0; k < 4; ++k) {
        const Graph other = shuffled(graph, prng);
        EXPECT_TRUE(inserted(conform(other), other) == before);
      }
    }
  }
}

TEST(ThinShapes, PointsScaleByPowersOfTwo) {
  Prng prng(25);
  for (const Family& family : kFamilies) {
    const Graph graph = family(8, 1e-6, prng);
    const Points reference = inserted(conform(graph), graph);
    for (const double factor : {0x1p-900, 0x1p-400, 0x1p400, 0x1p900}) {
      const Graph scaled{times(graph.points, factor), graph.segments};
      EXPECT_TRUE(inserted(conform(scaled), scaled) == times(reference, factor)) << factor;
    }
  }
}

TEST(ThinShapes, CoordinatesNearTheLeastDoubleEnd) {
  Prng prng(26);
  for (const Family& family : kFamilies) {
    for (const int exponent : {-1040, -1060, -1070}) {
      Graph graph{times(family(6, 1e-3, prng).points, std::ldexp(1.0, exponent)), {}};
      Points distinct = sorted(graph.points);
      distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
      // Rounding moves vertices: the polygon of them all need not be simple any more. It ends.
      const Graph rounded = polygon(distinct);
      ConformingOptions options;
      options.most_inserted = 5000;
      const auto result = conforming_delaunay2(rounded.points, rounded.segments, options);
      if (!result.ok()) continue;
      EXPECT_LE(result->split.size(), 5000U);
    }
  }
}

TEST(ThinShapes, GabrielSegmentsSideBySideEnd) {
  Prng prng(27);
  for (const Family& family : {kFamilies[0], kFamilies[1]}) {
    const Graph graph = family(3, 1e-5, prng);
    const Conforming2 c = conform(graph, all_gabriel(graph));
    EXPECT_TRUE(is_gabriel(c, graph));
    EXPECT_LE(c.split.size(), 600U);
  }
}

}  // namespace
}  // namespace tetloft::test
