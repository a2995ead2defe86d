// Voronoi cells, natural neighbours and periodic sets of C are those of C++.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <tetloft/periodic.hpp>
#include <tetloft/voronoi.hpp>

#include "c/changing_numbers.hpp"
#include "c/owned.hpp"
#include "core/prng.hpp"

namespace tetloft::c_test {
namespace {

// All arrays of cells.
struct CellArrays {
  explicit CellArrays(const tetloft_cells* c)
      : sites(array_of(tetloft_cells_sites, c)),
        bounded(array_of(tetloft_cells_bounded, c)),
        volumes(array_of(tetloft_cells_volumes, c)),
        corner_begin(array_of(tetloft_cells_corner_begin, c)),
        corners(array_of(tetloft_cells_corners, c)),
        face_begin(array_of(tetloft_cells_face_begin, c)),
        neighbours(array_of(tetloft_cells_neighbours, c)),
        sides(array_of(tetloft_cells_sides, c)),
        faces_bounded(array_of(tetloft_cells_faces_bounded, c)),
        areas(array_of(tetloft_cells_areas, c)),
        face_corner_begin(array_of(tetloft_cells_face_corner_begin, c)),
        face_corners(array_of(tetloft_cells_face_corners, c)),
        shifts(array_of(tetloft_cells_shifts, c)),
        normals(array_of(tetloft_cells_normals, c)) {}
  Array<Number> sites;
  Array<std::uint8_t> bounded;
  Array<double> volumes;
  Array<std::size_t> corner_begin;
  Array<double> corners;
  Array<std::size_t> face_begin;
  Array<Number> neighbours;
  Array<std::uint8_t> sides;
  Array<std::uint8_t> faces_bounded;
  Array<double> areas;
  Array<std::size_t> face_corner_begin;
  Array<std::uint32_t> face_corners;
  Array<std::int32_t> shifts;
  Array<double> normals;
};

// As many as of `cells` cells.
void expect_whole(const CellArrays& c, std::size_t cells, bool is_periodic) {
  EXPECT_EQ(c.sites.size, cells);
  EXPECT_EQ(c.bounded.size, cells);
  EXPECT_EQ(c.volumes.size, cells);
  ASSERT_EQ(c.corner_begin.size, cells + 1);
  ASSERT_EQ(c.face_begin.size, cells + 1);
  EXPECT_EQ(c.corner_begin[0], 0U);
  EXPECT_EQ(c.face_begin[0], 0U);
  EXPECT_EQ(c.corner_begin[cells], c.corners.size);
  const std::size_t faces = c.face_begin[cells];
  for (const std::size_t size : {c.neighbours.size, c.sides.size, c.faces_bounded.size,
                                 c.areas.size, c.face_corner_begin.size - 1}) {
    EXPECT_EQ(size, faces);
  }
  EXPECT_EQ(c.face_corner_begin[faces], c.face_corners.size);
  EXPECT_EQ(c.shifts.size, is_periodic ? faces : 0);
  EXPECT_EQ(c.normals.size, is_periodic ? faces : 0);
}

void expect_corners(const CellArrays& c, std::size_t cell, const std::vector<Point3>& expected) {
  const std::size_t begin = c.corner_begin[cell];
  ASSERT_EQ(c.corner_begin[cell + 1] - begin, expected.size());
  if (expected.empty()) return;
  EXPECT_TRUE(same_array(c.corners.data + 3 * begin, expected.size(), expected));
}

// Of face f of the cell: places in all corners there, in those of the cell here.
void expect_face_corners(const CellArrays& c, std::size_t cell, std::size_t f,
                         const std::vector<std::uint32_t>& expected) {
  const std::size_t begin = c.face_corner_begin[f];
  ASSERT_EQ(c.face_corner_begin[f + 1] - begin, expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(c.face_corners[begin + k], c.corner_begin[cell] + expected[k]);
  }
}

void expect_cells(const tetloft_cells* handle, const std::vector<VoronoiCell3>& cells) {
  const CellArrays c(handle);
  expect_whole(c, cells.size(), false);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const VoronoiCell3& cell = cells[i];
    EXPECT_EQ(c.sites[i], number(cell.site));
    EXPECT_EQ(c.bounded[i], cell.bounded ? 1 : 0);
    EXPECT_EQ(c.volumes[i], cell.volume);
    expect_corners(c, i, cell.corners);
    ASSERT_EQ(c.face_begin[i + 1] - c.face_begin[i], cell.faces.size());
    for (std::size_t k = 0; k < cell.faces.size(); ++k) {
      const std::size_t f = c.face_begin[i] + k;
      EXPECT_EQ(c.neighbours[f], number(cell.faces[k].neighbour));
      EXPECT_EQ(c.sides[f], static_cast<int>(cell.faces[k].side));
      EXPECT_EQ(c.faces_bounded[f], cell.faces[k].bounded ? 1 : 0);
      EXPECT_EQ(c.areas[f], cell.faces[k].area);
      expect_face_corners(c, i, f, cell.faces[k].corners);
    }
  }
}

// Points of a lattice, and others, some gone again: there are generations, and places without one.
class CellsOfC : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<Point3> points;
    for (int k = 0; k < 27; ++k) {
      points.push_back({k % 3 * 0.5, k / 3 % 3 * 0.5, k / 9 * 0.5});
    }
    for (int i = 0; i < 20; ++i) points.push_back({random_.unit(), random_.unit(), random_.unit()});
    triangulation_ = DelaunayTriangulation3::of(points).value();
    ASSERT_OK(tetloft_delaunay_create(coordinates(points), points.size(), nullptr, c_.out()));
    for (const Number gone : {Number{30}, Number{46}, Number{13}}) {
      ASSERT_TRUE(triangulation_.remove({static_cast<std::uint32_t>(gone), 0}).ok());
      ASSERT_OK(tetloft_delaunay_remove(c_, gone));
    }
    Number made = 0;
    ASSERT_OK(tetloft_delaunay_insert(c_, 0.3, 0.4, 0.5, TETLOFT_NO_VERTEX, &made, nullptr));
    ASSERT_EQ(made, number(triangulation_.insert({0.3, 0.4, 0.5}).value().vertex));
    ASSERT_NE(made >> 32, 0U) << "a place used again";
  }
  internal::Prng random_{40};
  DelaunayTriangulation3 triangulation_;
  Owned<tetloft_delaunay> c_;
};

TEST_F(CellsOfC, AreThoseOfCpp) {
  Owned<tetloft_cells> cells;
  ASSERT_OK(tetloft_delaunay_cells(c_, nullptr, nullptr, cells.out()));
  expect_cells(cells, voronoi_cells(triangulation_).value());
  const std::array<double, 6> box{-0.5, 0.25, -1, 1, 1.5, 0.75};
  const ClippingBox same{{-0.5, 0.25, -1}, {1, 1.5, 0.75}};
  ASSERT_OK(tetloft_delaunay_cells(c_, box.data(), nullptr, cells.out()));
  expect_cells(cells, voronoi_cells(triangulation_, same).value());
  for (const DelaunayVertex v : triangulation_.vertices()) {
    ASSERT_OK(tetloft_delaunay_cell(c_, number(v), nullptr, cells.out()));
    expect_cells(cells, {voronoi_cell(triangulation_, v).value()});
    ASSERT_OK(tetloft_delaunay_cell(c_, number(v), box.data(), cells.out()));
    expect_cells(cells, {voronoi_cell(triangulation_, v, same).value()});
  }
}

TEST_F(CellsOfC, AreRefusedAsInCpp) {
  Owned<tetloft_cells> cells;
  for (const Number gone : {Number{13}, Number{1000}, Number{TETLOFT_NO_VERTEX}}) {
    EXPECT_EQ(tetloft_delaunay_cell(c_, gone, nullptr, cells.out()), TETLOFT_INVALID_INPUT);
  }
  const std::array<double, 6> reversed{1, 0, 0, 0, 1, 1};
  EXPECT_EQ(tetloft_delaunay_cells(c_, reversed.data(), nullptr, cells.out()),
            TETLOFT_INVALID_INPUT);
  EXPECT_EQ(tetloft_delaunay_cell(c_, 0, reversed.data(), cells.out()), TETLOFT_INVALID_INPUT);
}

TEST_F(CellsOfC, HaveVolumesAndSpheres) {
  expect_found<double, double>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_volumes(c_, nullptr, a, n, count);
      },
      voronoi_volumes(triangulation_).value());

  std::size_t count = 0;
  ASSERT_OK(tetloft_delaunay_circumspheres(c_, nullptr, 0, &count));
  ASSERT_EQ(count, triangulation_.tet_count());
  std::vector<std::array<double, 4>> spheres(count);
  ASSERT_OK(tetloft_delaunay_circumspheres(c_, spheres.front().data(), count, &count));
  std::size_t k = 0;
  for (const TetId t : triangulation_.tets()) {
    std::vector<Point3> p;
    for (const DelaunayVertex v : triangulation_.vertices(t)) {
      p.push_back(triangulation_.point(v));
    }
    const Sphere3 sphere = circumsphere(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(spheres[k],
              (std::array{sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius}));
    std::array<double, 4> one{};
    ASSERT_OK(tetloft_circumsphere(coordinates(p), one.data()));
    EXPECT_EQ(one, spheres[k++]);
  }
  const std::vector<Point3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  std::array<double, 4> sphere{};
  ASSERT_OK(tetloft_circumsphere(coordinates(flat), sphere.data()));
  EXPECT_TRUE(std::isinf(sphere[3]));
}

TEST_F(CellsOfC, HaveNaturalNeighbours) {
  std::vector<Point3> points;
  for (int i = 0; i < 60; ++i) {
    points.push_back({1.25 * random_.unit() - 0.125, random_.unit(), 0.25 * (i % 5)});
  }
  for (const auto kind : {NaturalWeights::sibson, NaturalWeights::laplace}) {
    const auto k = static_cast<std::int32_t>(kind);
    Owned<tetloft_natural_neighbours> all;
    ASSERT_OK(tetloft_delaunay_natural_neighbours_all(c_, coordinates(points), points.size(), k,
                                                      nullptr, all.out()));
    const auto begin = array_of(tetloft_natural_neighbours_begin, all.handle());
    const auto vertices = array_of(tetloft_natural_neighbours_vertices, all.handle());
    const auto weights = array_of(tetloft_natural_neighbours_weights, all.handle());
    ASSERT_EQ(begin.size, points.size() + 1);
    EXPECT_EQ(begin[points.size()], vertices.size);
    EXPECT_EQ(vertices.size, weights.size);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point3& p = points[i];
      const Result<NaturalNeighbours> expected = natural_neighbours(triangulation_, p, kind);
      std::vector<Number> one(64);
      std::vector<double> of_one(64);
      std::size_t count = 7;
      const tetloft_status status = tetloft_delaunay_natural_neighbours(
          c_, p.x, p.y, p.z, k, TETLOFT_NO_VERTEX, one.data(), of_one.data(), one.size(), &count);
      if (!expected) {
        ++refused;
        EXPECT_EQ(status, TETLOFT_INVALID_INPUT);
        EXPECT_EQ(begin[i + 1], begin[i]);
        continue;
      }
      ASSERT_OK(status);
      ASSERT_EQ(count, expected->vertices.size());
      ASSERT_EQ(begin[i + 1] - begin[i], count);
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(one[j], number(expected->vertices[j]));
        EXPECT_EQ(of_one[j], expected->weights[j]);
        EXPECT_EQ(vertices[begin[i] + j], one[j]);
        EXPECT_EQ(weights[begin[i] + j], of_one[j]);
      }
    }
    EXPECT_GT(refused, 0U);
    EXPECT_LT(refused, 50U);
  }
  std::size_t count = 0;
  std::array<Number, 2> few{};
  std::array<double, 2> of_few{};
  ASSERT_OK(
      tetloft_delaunay_natural_neighbours(c_, 0.1, 0.2, 0.3, 0, 0, nullptr, nullptr, 0, &count));
  EXPECT_GT(count, 3U);
  EXPECT_EQ(tetloft_delaunay_natural_neighbours(c_, 0.1, 0.2, 0.3, 0, 0, few.data(), of_few.data(),
                                                2, &count),
            TETLOFT_TOO_SMALL);
  EXPECT_EQ(few, (std::array<Number, 2>{})) << "nothing is written";
  EXPECT_EQ(
      tetloft_delaunay_natural_neighbours(c_, 0.1, 0.2, 0.3, 0, 0, few.data(), nullptr, 2, &count),
      TETLOFT_USAGE);
  EXPECT_EQ(tetloft_delaunay_natural_neighbours(c_, 0.1, 0.2, 0.3, 2, 0, few.data(), of_few.data(),
                                                2, &count),
            TETLOFT_USAGE);
}

// Of few points and of many, in a box as skewed as it may be.
TEST(PeriodicSetsOfC, AreThoseOfCpp) {
  internal::Prng random(41);
  const PeriodicBox box{{2, 0.25, 0}, {1.5, 2, 0.5}, {-3, 1, 2.5}};
  const std::array<double, 9> same{2, 0.25, 0, 1.5, 2, 0.5, -3, 1, 2.5};
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{40}}) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < n; ++i) {
      points.push_back({9 * random.unit(), 9 * random.unit(), random.unit()});
    }
    Owned<tetloft_cells> cells;
    ASSERT_OK(tetloft_periodic_voronoi(coordinates(points), n, same.data(), nullptr, cells.out()));
    const PeriodicVoronoi3 expected = periodic_voronoi(points, box).value();
    const CellArrays c(cells);
    expect_whole(c, n, true);
    for (std::size_t i = 0; i < n; ++i) {
      const PeriodicCell& cell = expected.cells[i];
      EXPECT_EQ(c.sites[i], i);
      EXPECT_EQ(c.bounded[i], 1);
      EXPECT_EQ(c.volumes[i], cell.volume);
      expect_corners(c, i, cell.corners);
      ASSERT_EQ(c.face_begin[i + 1] - c.face_begin[i], cell.faces.size());
      for (std::size_t k = 0; k < cell.faces.size(); ++k) {
        const PeriodicFace& face = cell.faces[k];
        const std::size_t f = c.face_begin[i] + k;
        EXPECT_EQ(c.neighbours[f], face.neighbour);
        EXPECT_EQ(c.sides[f], TETLOFT_SIDE_NONE);
        EXPECT_EQ(c.faces_bounded[f], 1);
        EXPECT_EQ(c.areas[f], face.area);
        EXPECT_TRUE(same_array(c.shifts.data + 3 * f, 3, face.shift));
        EXPECT_TRUE(same_array(c.normals.data + 3 * f, 1, std::vector<Point3>{face.normal}));
        expect_face_corners(c, i, f, face.corners);
      }
    }
    Owned<tetloft_periodic_tets> tets;
    ASSERT_OK(tetloft_periodic_delaunay(coordinates(points), n, same.data(), nullptr, tets.out()));
    const auto of = array_of(tetloft_periodic_tets_points, tets.handle());
    const auto shifts = array_of(tetloft_periodic_tets_shifts, tets.handle());
    const std::vector<PeriodicTet> expected_tets = periodic_delaunay(points, box).value().tets;
    ASSERT_EQ(of.size, expected_tets.size());
    ASSERT_EQ(shifts.size, expected_tets.size());
    for (std::size_t t = 0; t < of.size; ++t) {
      EXPECT_TRUE(same_array(of.data + 4 * t, 4, expected_tets[t].points));
      EXPECT_TRUE(same_array(shifts.data + 12 * t, 4, expected_tets[t].shifts));
    }
  }
}

TEST(PeriodicSetsOfC, AreRefusedAsInCpp) {
  const std::vector<Point3> twice{{0, 0, 0}, {1, 0, 0}};
  const std::array<double, 9> unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<double, 9> flat{1, 0, 0, 0, 1, 0, 1, 1, 0};
  Owned<tetloft_cells> cells;
  Owned<tetloft_periodic_tets> tets;
  EXPECT_EQ(tetloft_periodic_voronoi(coordinates(twice), 2, unit.data(), nullptr, cells.out()),
            TETLOFT_INVALID_INPUT);
  EXPECT_EQ(tetloft_periodic_delaunay(coordinates(twice), 2, unit.data(), nullptr, tets.out()),
            TETLOFT_INVALID_INPUT);
  EXPECT_EQ(tetloft_periodic_voronoi(coordinates(twice), 1, flat.data(), nullptr, cells.out()),
            TETLOFT_INVALID_INPUT);
}

}  // namespace
}  // namespace tetloft::c_test
