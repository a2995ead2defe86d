// Voronoi cells and natural neighbours of C in the plane are those of C++.
#include <gtest/gtest.h>

#include <array>

#include <tetloft/voronoi2.hpp>

#include "c/changing_numbers.hpp"
#include "c/owned.hpp"
#include "core/prng.hpp"

namespace tetloft::c_test {
namespace {

// An end that there is, as a place in all corners.
std::uint32_t place_of(const VoronoiEdge2& edge, std::size_t k, std::size_t before) {
  if (!edge.inside || edge.ends[k] == VoronoiEdge2::kEndless) return TETLOFT_NO_ID;
  return static_cast<std::uint32_t>(before + edge.ends[k]);
}

void expect_plane_cells(const tetloft_plane_cells* c, const std::vector<VoronoiCell2>& cells) {
  const auto sites = array_of(tetloft_plane_cells_sites, c);
  const auto bounded = array_of(tetloft_plane_cells_bounded, c);
  const auto areas = array_of(tetloft_plane_cells_areas, c);
  const auto corner_begin = array_of(tetloft_plane_cells_corner_begin, c);
  const auto corners = array_of(tetloft_plane_cells_corners, c);
  const auto edge_begin = array_of(tetloft_plane_cells_edge_begin, c);
  const auto neighbours = array_of(tetloft_plane_cells_neighbours, c);
  const auto sides = array_of(tetloft_plane_cells_sides, c);
  const auto inside = array_of(tetloft_plane_cells_inside, c);
  const auto ends = array_of(tetloft_plane_cells_ends, c);
  const auto lengths = array_of(tetloft_plane_cells_lengths, c);
  ASSERT_EQ(sites.size, cells.size());
  ASSERT_EQ(bounded.size, cells.size());
  ASSERT_EQ(areas.size, cells.size());
  ASSERT_EQ(corner_begin.size, cells.size() + 1);
  ASSERT_EQ(edge_begin.size, cells.size() + 1);
  EXPECT_EQ(corner_begin[cells.size()], corners.size);
  for (const std::size_t size :
       {neighbours.size, sides.size, inside.size, ends.size, lengths.size}) {
    ASSERT_EQ(size, edge_begin[cells.size()]);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const VoronoiCell2& cell = cells[i];
    EXPECT_EQ(sites[i], number(cell.site));
    EXPECT_EQ(bounded[i], cell.bounded ? 1 : 0);
    EXPECT_EQ(areas[i], cell.area);
    const std::size_t before = corner_begin[i];
    ASSERT_EQ(corner_begin[i + 1] - before, cell.corners.size());
    if (!cell.corners.empty()) {
      EXPECT_TRUE(same_array(corners.data + 2 * before, cell.corners.size(), cell.corners));
    }
    ASSERT_EQ(edge_begin[i + 1] - edge_begin[i], cell.edges.size());
    for (std::size_t k = 0; k < cell.edges.size(); ++k) {
      const VoronoiEdge2& edge = cell.edges[k];
      const std::size_t e = edge_begin[i] + k;
      EXPECT_EQ(neighbours[e], number(edge.neighbour));
      EXPECT_EQ(sides[e], static_cast<int>(edge.side));
      EXPECT_EQ(inside[e], edge.inside ? 1 : 0);
      EXPECT_EQ(ends[2 * e], place_of(edge, 0, before));
      EXPECT_EQ(ends[2 * e + 1], place_of(edge, 1, before));
      EXPECT_EQ(lengths[e], edge.length);
    }
  }
}

class PlaneCellsOfC : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<Point2> points;
    for (int k = 0; k < 25; ++k) points.push_back({k % 5 * 0.25, k / 5 * 0.25});
    for (int i = 0; i < 20; ++i) points.push_back({random_.unit(), random_.unit()});
    plane_ = DelaunayTriangulation2::of(points).value();
    ASSERT_OK(tetloft_delaunay_plane_create(coordinates(points), points.size(), nullptr, c_.out()));
    ASSERT_TRUE(plane_.remove({12, 0}).ok());
    ASSERT_OK(tetloft_delaunay_plane_remove(c_, 12));
  }
  internal::Prng random_{42};
  DelaunayTriangulation2 plane_;
  Owned<tetloft_delaunay_plane> c_;
};

TEST_F(PlaneCellsOfC, AreThoseOfCpp) {
  const std::array<double, 4> rectangle{-0.5, 0.25, 0.75, 2};
  const ClippingRectangle same{{-0.5, 0.25}, {0.75, 2}};
  Owned<tetloft_plane_cells> cells;
  ASSERT_OK(tetloft_delaunay_plane_cells(c_, nullptr, nullptr, cells.out()));
  expect_plane_cells(cells, voronoi_cells(plane_).value());
  ASSERT_OK(tetloft_delaunay_plane_cells(c_, rectangle.data(), nullptr, cells.out()));
  expect_plane_cells(cells, voronoi_cells(plane_, same).value());
  for (const DelaunayVertex v : plane_.vertices()) {
    ASSERT_OK(tetloft_delaunay_plane_cell(c_, number(v), nullptr, cells.out()));
    expect_plane_cells(cells, {voronoi_cell(plane_, v).value()});
    ASSERT_OK(tetloft_delaunay_plane_cell(c_, number(v), rectangle.data(), cells.out()));
    expect_plane_cells(cells, {voronoi_cell(plane_, v, same).value()});
  }
  expect_found<double, double>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_areas(c_, nullptr, a, n, count);
      },
      voronoi_areas(plane_).value());
}

TEST_F(PlaneCellsOfC, AreRefusedAsInCpp) {
  Owned<tetloft_plane_cells> cells;
  EXPECT_EQ(tetloft_delaunay_plane_cell(c_, 12, nullptr, cells.out()), TETLOFT_INVALID_INPUT);
  const std::array<double, 4> reversed{1, 0, 0, 1};
  EXPECT_EQ(tetloft_delaunay_plane_cells(c_, reversed.data(), nullptr, cells.out()),
            TETLOFT_INVALID_INPUT);
  std::uint32_t constraint = 0;
  ASSERT_OK(
      tetloft_delaunay_plane_insert_constraint(c_, 0, 24, TETLOFT_CROSSING_REFUSE, &constraint));
  EXPECT_EQ(tetloft_delaunay_plane_cells(c_, nullptr, nullptr, cells.out()), TETLOFT_INVALID_INPUT);
}

TEST_F(PlaneCellsOfC, HaveNaturalNeighbours) {
  std::vector<Point2> points;
  for (int i = 0; i < 60; ++i) points.push_back({1.25 * random_.unit() - 0.125, 0.125 * (i % 9)});
  for (const auto kind : {NaturalWeights::sibson, NaturalWeights::laplace}) {
    const auto k = static_cast<std::int32_t>(kind);
    Owned<tetloft_natural_neighbours> all;
    ASSERT_OK(tetloft_delaunay_plane_natural_neighbours_all(c_, coordinates(points), points.size(),
                                                            k, nullptr, all.out()));
    const NaturalNeighboursOfMany expected =
        natural_neighbours_of_many(plane_, points, kind).value();
    expect_array(tetloft_natural_neighbours_begin, all.handle(), expected.begin);
    expect_array(tetloft_natural_neighbours_vertices, all.handle(), numbers(expected.vertices));
    expect_array(tetloft_natural_neighbours_weights, all.handle(), expected.weights);
    for (const Point2& p : points) {
      const Result<NaturalNeighbours> of = natural_neighbours(plane_, p, kind);
      std::array<std::uint64_t, 64> vertices{};
      std::array<double, 64> weights{};
      std::size_t count = 7;
      const tetloft_status status = tetloft_delaunay_plane_natural_neighbours(
          c_, p.x, p.y, k, TETLOFT_NO_VERTEX, vertices.data(), weights.data(), 64, &count);
      ASSERT_EQ(status, of ? TETLOFT_OK : TETLOFT_INVALID_INPUT);
      if (!of) continue;
      EXPECT_TRUE(same_array(vertices.data(), count, numbers(of->vertices)));
      EXPECT_TRUE(same_array(weights.data(), count, of->weights));
    }
  }
}

}  // namespace
}  // namespace tetloft::c_test
