// Whole cells of the plane: against clipped ones, which are made in another way, and against what
// lattices and circles have.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/voronoi2.hpp>

#include "point_sets.hpp"

namespace tetloft::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kEndless = VoronoiEdge2::kEndless;

std::vector<Point2> without_height(const std::vector<Point3>& points) {
  std::vector<Point2> result;
  for (const Point3& p : points) result.push_back({p.x, p.y});
  return result;
}

DelaunayTriangulation2 plane_of(const std::vector<Point2>& points) {
  return value_of(DelaunayTriangulation2::of(points));
}

double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// One turn around the site, or from one edge without end to the other.
testing::AssertionResult is_turn(const VoronoiCell2& cell) {
  std::size_t without_start = 0, without_end = 0;
  std::vector<std::size_t> starts(cell.corners.size()), ends(cell.corners.size());
  for (const VoronoiEdge2& edge : cell.edges) {
    if (!edge.inside || edge.side != BoxSide::none) return testing::AssertionFailure() << "clipped";
    const bool endless = edge.ends[0] == kEndless || edge.ends[1] == kEndless;
    if (endless != (edge.length == kInfinite)) return testing::AssertionFailure() << "length";
    if (edge.ends[0] == kEndless) {
      ++without_start;
    } else {
      ++starts.at(edge.ends[0]);
    }
    if (edge.ends[1] == kEndless) {
      ++without_end;
    } else {
      ++ends.at(edge.ends[1]);
    }
    if (!endless && edge.ends[1] != (edge.ends[0] + 1) % cell.corners.size()) {
      return testing::AssertionFailure() << "order of corners";
    }
  }
  const std::size_t open = cell.bounded ? 0 : 1;
  if (without_start != open || without_end != open) return testing::AssertionFailure() << "ends";
  const auto once = [](std::size_t n) { return n == 1; };
  if (!std::all_of(starts.begin(), starts.end(), once) ||
      !std::all_of(ends.begin(), ends.end(), once)) {
    return testing::AssertionFailure() << "corners";
  }
  return testing::AssertionSuccess();
}

TEST(WholePlaneCells, AreThoseOfALargeRectangle) {
  std::size_t compared = 0;
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    const DelaunayTriangulation2 t = plane_of(without_height(set.points));
    if (t.dimension() < 2) continue;
    std::map<std::pair<DelaunayVertex, DelaunayVertex>, double> lengths;
    for (const VoronoiCell2& cell : value_of(voronoi_cells(t))) {
      ASSERT_TRUE(is_turn(cell));
      EXPECT_EQ(cell.bounded, !t.is_on_hull(cell.site));
      EXPECT_EQ(cell.area == kInfinite, !cell.bounded);
      double reach = 1;
      for (const Point2& corner : cell.corners) {
        reach = std::max({reach, std::abs(corner.x), std::abs(corner.y)});
      }
      for (const VoronoiEdge2& edge : cell.edges) {
        lengths[{cell.site, edge.neighbour}] = edge.length;
        for (const std::uint32_t end : edge.ends) {
          if (end == kEndless) continue;
          const double r = distance(cell.corners[end], t.point(cell.site));
          EXPECT_NEAR(distance(cell.corners[end], t.point(edge.neighbour)), r, 1e-9 * (1 + r));
        }
      }
      if (!cell.bounded || reach > 100) continue;
      ++compared;
      const VoronoiCell2 clipped = value_of(voronoi_cell(t, cell.site, {{-101, -101}, {101, 101}}));
      EXPECT_NEAR(cell.area, clipped.area, 1e-9);
      ASSERT_EQ(clipped.edges.size(), cell.edges.size());
      for (std::size_t i = 0; i < cell.edges.size(); ++i) {
        EXPECT_EQ(cell.edges[i].neighbour, clipped.edges[i].neighbour);
        EXPECT_NEAR(cell.edges[i].length, clipped.edges[i].length, 1e-9);
      }
    }
    for (const auto& [pair, length] : lengths) {
      const double other = lengths.at({pair.second, pair.first});
      EXPECT_TRUE(length == other || std::abs(length - other) < 1e-9 * (1 + length));
    }
  }
  EXPECT_GT(compared, 100U);
}

TEST(WholePlaneCells, OfALatticeAreItsSquaresHoweverFarAway) {
  for (const double far : {0.0, 0x1p40}) {
    std::vector<Point2> points;
    for (int x = 0; x < 6; ++x) {
      for (int y = 0; y < 6; ++y) points.push_back({far + x / 1024.0, y / 1024.0 - far});
    }
    const DelaunayTriangulation2 t = plane_of(points);
    std::size_t bounded = 0;
    for (const DelaunayVertex v : t.vertices()) {
      const VoronoiCell2 cell = value_of(voronoi_cell(t, v));
      ASSERT_TRUE(is_turn(cell));
      if (!cell.bounded) continue;
      ++bounded;
      EXPECT_EQ(cell.area, 0x1p-20);
      for (const VoronoiEdge2& edge : cell.edges) {
        const Point2& a = t.point(v);
        const Point2& b = t.point(edge.neighbour);
        EXPECT_EQ(edge.length, a.x == b.x || a.y == b.y ? 0x1p-10 : 0);
      }
    }
    EXPECT_EQ(bounded, 16U);
  }
}

TEST(WholePlaneCells, OfAHubAndItsRim) {
  std::vector<Point2> points{{0, 0}};
  constexpr int kRim = 2000;
  for (int i = 0; i < kRim; ++i) {
    const double turn = 6.283185307179586 * i / kRim;
    points.push_back({std::cos(turn), std::sin(turn)});
  }
  const DelaunayTriangulation2 t = plane_of(points);
  const VoronoiCell2 cell = value_of(voronoi_cell(t, t.vertex_at(0)));
  ASSERT_TRUE(is_turn(cell));
  ASSERT_TRUE(cell.bounded);
  const double expected = kRim * std::tan(3.141592653589793 / kRim) / 4;
  EXPECT_NEAR(cell.area, expected, 1e-12);
}

// Of (0, 0), (1, 0) and (1/2, h) the centre is at (1/2, (h² − 1/4) / (2 h)).
TEST(WholePlaneCells, HaveCentresOfFlatTrianglesAsCorners) {
  for (int k = 0; k <= 60; ++k) {
    const double h = std::ldexp(1.0, -k);
    for (const double unit : {1.0, 0x1p-250, 0x1p250}) {
      const DelaunayTriangulation2 t = plane_of({{0, 0}, {unit, 0}, {0.5 * unit, h * unit}});
      for (const DelaunayVertex v : t.vertices()) {
        const VoronoiCell2 cell = value_of(voronoi_cell(t, v));
        ASSERT_TRUE(is_turn(cell));
        ASSERT_EQ(cell.corners.size(), 1U);
        const double y = (h * h - 0.25) / (2 * h);
        const double tolerance = 1e-11 * (1 + std::abs(y));
        EXPECT_NEAR(cell.corners[0].x / unit, 0.5, tolerance);
        EXPECT_NEAR(cell.corners[0].y / unit, y, tolerance);
      }
    }
  }
}

TEST(WholePlaneCells, HaveTheirAreasByIndex) {
  DelaunayTriangulation2 t = plane_of(without_height(uniform_points(500, 9)));
  for (std::size_t i = 0; i < 500; i += 7) ASSERT_TRUE(t.remove(t.vertex_at(i)).ok());
  const std::vector<double> areas = value_of(voronoi_areas(t));
  ASSERT_EQ(areas.size(), t.vertex_slots());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const DelaunayVertex v = t.vertex_at(i);
    EXPECT_EQ(areas[i], v.valid() ? value_of(voronoi_cell(t, v)).area : 0);
  }
  EXPECT_TRUE(value_of(voronoi_areas(DelaunayTriangulation2())).empty());
}

TEST(WholePlaneCells, OfARowHaveNoEnd) {
  const DelaunayTriangulation2 t = plane_of({{0, 0}, {1, 1}, {2, 2}});
  for (const VoronoiCell2& cell : value_of(voronoi_cells(t))) {
    EXPECT_FALSE(cell.bounded);
    EXPECT_EQ(cell.area, kInfinite);
    EXPECT_TRUE(cell.corners.empty());
    EXPECT_EQ(cell.edges.size(), t.neighbours(cell.site).size());
    for (const VoronoiEdge2& edge : cell.edges) {
      EXPECT_EQ(edge.ends[0], kEndless);
      EXPECT_EQ(edge.ends[1], kEndless);
      EXPECT_EQ(edge.length, kInfinite);
    }
  }
  const VoronoiCell2 alone = value_of(voronoi_cell(plane_of({{3, 4}}), {0, 0}));
  EXPECT_FALSE(alone.bounded);
  EXPECT_TRUE(alone.edges.empty());
  EXPECT_TRUE(value_of(voronoi_cells(DelaunayTriangulation2())).empty());
}

TEST(WholePlaneCells, AreTheSameForAnyNumberOfThreads) {
  const DelaunayTriangulation2 t = plane_of(without_height(uniform_points(3000, 4)));
  const auto one = value_of(voronoi_cells(t, Execution{.threads = 1}));
  const auto many = value_of(voronoi_cells(t, Execution{.threads = 3}));
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].area, many[i].area);
    EXPECT_EQ(one[i].corners, many[i].corners);
  }
}

TEST(WholePlaneCells, AreRefusedAmongConstraintsAndBeyondRange) {
  DelaunayTriangulation2 t = plane_of({{0, 0}, {1, 0.1}, {0, 0.2}, {-1, 0.1}});
  EXPECT_EQ(voronoi_cell(t, DelaunayVertex()).error().code, ErrorCode::invalid_input);
  const auto c = t.insert_constraint(t.vertex_at(1), t.vertex_at(3));
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(voronoi_cell(t, t.vertex_at(0)).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_areas(t).error().code, ErrorCode::invalid_input);
  const DelaunayTriangulation2 large = plane_of({{0, 0}, {1, 0}, {0, 0x1p301}});
  EXPECT_EQ(voronoi_cells(large).error().where.vertex, 2U);
}

}  // namespace
}  // namespace tetloft::test
