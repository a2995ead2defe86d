#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <tetloft/voronoi2.hpp>

#include "point_sets.hpp"

namespace tetloft::test {
namespace {

constexpr ClippingRectangle kUnitSquare{{0, 0}, {1, 1}};

// The sets of space, without z; also those that are a few points or a row.
std::vector<std::pair<std::string, std::vector<Point2>>> plane_sets() {
  std::vector<std::pair<std::string, std::vector<Point2>>> sets;
  for (const NamedPoints& set : voronoi_point_sets()) {
    std::vector<Point2> points;
    for (const Point3& p : set.points) points.push_back({p.x, p.y});
    sets.push_back({set.name, points});
  }
  return sets;
}

TEST(PlaneCells, FillTheRectangleAndFit) {
  for (const auto& [name, points] : plane_sets()) {
    SCOPED_TRACE(name);
    const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
    const std::vector<VoronoiCell2> cells = value_of(voronoi_cells(t, kUnitSquare));
    ASSERT_EQ(cells.size(), t.vertex_count());
    double area = 0;
    std::map<BoxSide, double> sides;
    std::map<std::pair<DelaunayVertex, DelaunayVertex>, double> lengths;
    for (const VoronoiCell2& cell : cells) {
      area += cell.area;
      EXPECT_EQ(cell.bounded, t.dimension() == 2 && !t.is_on_hull(cell.site));
      std::vector<DelaunayVertex> neighbours;
      std::size_t inside = 0;
      for (const VoronoiEdge2& edge : cell.edges) {
        if (edge.inside) {
          ++inside;
          EXPECT_EQ(edge.ends[1], (edge.ends[0] + 1) % cell.corners.size());
        }
        if (edge.side != BoxSide::none) sides[edge.side] += edge.length;
        if (!edge.neighbour.valid()) continue;
        neighbours.push_back(edge.neighbour);
        lengths[{cell.site, edge.neighbour}] = edge.length;
      }
      EXPECT_EQ(inside, cell.corners.size());
      EXPECT_EQ(neighbours, t.neighbours(cell.site));
    }
    EXPECT_NEAR(area, 1, 1e-13);
    for (int side = 1; side <= 4; ++side) {
      EXPECT_NEAR(sides[static_cast<BoxSide>(side)], 1, 1e-13);
    }
    for (const auto& [pair, length] : lengths) {
      EXPECT_NEAR(length, lengths.at({pair.second, pair.first}), 1e-9);
    }
  }
}

// A site's cell in the plane, times one, is its cell in space.
TEST(PlaneCells, AreThoseOfSpaceWithoutHeight) {
  std::vector<Point2> points;
  std::vector<Point3> flat;
  for (const Point3& p : uniform_points(100, 31)) {
    points.push_back({p.x, p.y});
    flat.push_back({p.x, p.y, 0.5});
  }
  const DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  const DelaunayTriangulation3 s = triangulated(flat);
  for (std::uint32_t i = 0; i < 100; ++i) {
    const VoronoiCell2 a = value_of(voronoi_cell(t, {i, 0}, kUnitSquare));
    const VoronoiCell3 b = value_of(voronoi_cell(s, {i, 0}, {{0, 0, 0}, {1, 1, 1}}));
    EXPECT_NEAR(a.area, b.volume, 1e-14);
  }
}

// They bend edges away from neighbours: the centres of both triangles are then in the wrong order.
TEST(PlaneCells, AreRefusedAmongConstraints) {
  DelaunayTriangulation2 t = value_of(
      DelaunayTriangulation2::of(std::vector<Point2>{{0, 0}, {1, 0.1}, {0, 0.2}, {-1, 0.1}}));
  const auto c = t.insert_constraint(t.vertex_at(1), t.vertex_at(3));
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(voronoi_cell(t, t.vertex_at(0), kUnitSquare).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t, kUnitSquare).error().code, ErrorCode::invalid_input);
  ASSERT_TRUE(t.remove_constraint(*c));
  EXPECT_TRUE(voronoi_cells(t, kUnitSquare).ok());
}

TEST(PlaneCells, RefuseWhatIsNone) {
  const DelaunayTriangulation2 t =
      value_of(DelaunayTriangulation2::of(std::vector<Point2>{{0, 0}, {1, 0}, {0, 0x1p301}}));
  const DelaunayVertex v = t.vertex_at(0);
  EXPECT_EQ(voronoi_cell(t, DelaunayVertex(), kUnitSquare).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cell(t, v, {{0, 2}, {1, 1}}).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t, {{0, 0}, {1, NAN}}).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t, kUnitSquare).error().where.vertex, 2U);
  EXPECT_TRUE(value_of(voronoi_cells(DelaunayTriangulation2(), kUnitSquare)).empty());
}

}  // namespace
}  // namespace tetloft::test
