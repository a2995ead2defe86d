#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <tetloft/predicates.hpp>
#include <tetloft/voronoi.hpp>

#include "support.hpp"

namespace tetloft::test {
namespace {

TEST(PeriodicVoronoi, OnePointIsItsOwnNeighbour) {
  const std::vector<Point3> points{{0.3, 0.4, 17.5}};
  const PeriodicVoronoi3 diagram = value_of(periodic_voronoi(points, orthorhombic_box(2, 3, 5)));
  ASSERT_EQ(diagram.cells.size(), 1U);
  EXPECT_NEAR(diagram.cells[0].volume, 30, 1e-13);
  std::map<LatticeShift, double> areas;
  for (const PeriodicFace& face : diagram.cells[0].faces) {
    EXPECT_EQ(face.neighbour, 0U);
    if (face.area > 1e-9) areas[face.shift] = face.area;
  }
  EXPECT_EQ(areas.size(), 6U);
  for (const int s : {-1, 1}) {
    EXPECT_NEAR((areas[{s, 0, 0}]), 15, 1e-13);
    EXPECT_NEAR((areas[{0, s, 0}]), 10, 1e-13);
    EXPECT_NEAR((areas[{0, 0, s}]), 6, 1e-13);
  }
}

TEST(PeriodicVoronoi, IsSoundInAllBoxes) {
  for (const NamedBox& named : periodic_boxes()) {
    for (const std::size_t n : {1U, 2U, 3U, 5U, 17U, 120U}) {
      SCOPED_TRACE(named.name + " " + std::to_string(n));
      const std::vector<Point3> points = points_in(named.box, n, n);
      expect_sound(value_of(periodic_voronoi(points, named.box)), points, named.box);
    }
  }
}

TEST(PeriodicVoronoi, IsSoundOfClustersAndLines) {
  const PeriodicBox box{{4, 0, 0}, {1.3, 3.7, 0}, {-0.9, 1.1, 5.2}};
  std::vector<Point3> clustered = points_in(box, 40, 7), row;
  for (Point3& p : clustered) p = {1 + p.x / 4096, 1 + p.y / 4096, 1 + p.z / 4096};
  for (int i = 0; i < 7; ++i) row.push_back({0.25 * i, 0.125 * i, 1});
  for (const std::vector<Point3>& points : {clustered, row}) {
    expect_sound(value_of(periodic_voronoi(points, box)), points, box);
  }
}

// Of some thousand images, far more than any neighbour is away.
TEST(PeriodicVoronoi, IsThatOfManyImages) {
  const PeriodicBox box{{4, 0, 0}, {1.3, 3.7, 0}, {-0.9, 1.1, 5.2}};
  for (const std::size_t n : {2U, 9U, 20U}) {
    const std::vector<Point3> points = points_in(box, n, 30 + n);
    std::vector<Point3> images = points;
    std::vector<LatticeShift> shift_of(n);
    for (int i = 0; i < 125; ++i) {
      const LatticeShift shift{i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2};
      if (shift == LatticeShift{}) continue;
      for (const Point3& p : points) {
        images.push_back(shifted(p, shift, box));
        shift_of.push_back(shift);
      }
    }
    const DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(images));
    const PeriodicVoronoi3 diagram = value_of(periodic_voronoi(points, box));
    for (std::size_t i = 0; i < n; ++i) {
      const VoronoiCell3 cell = value_of(voronoi_cell(t, t.vertex_at(i)));
      EXPECT_NEAR(cell.volume, diagram.cells[i].volume, 1e-10);
      std::map<std::pair<std::size_t, LatticeShift>, double> areas;
      for (const VoronoiFace3& face : cell.faces) {
        areas[{face.neighbour.index % n, shift_of[face.neighbour.index]}] = face.area;
      }
      ASSERT_EQ(areas.size(), diagram.cells[i].faces.size());
      for (const PeriodicFace& face : diagram.cells[i].faces) {
        EXPECT_NEAR(face.area, areas.at({face.neighbour, face.shift}), 1e-10);
      }
    }
  }
}

// What a box's vectors are is not what its lattice is; nor is where a point was given.
TEST(PeriodicVoronoi, DoesNotDependOnTheBasisNorOnImages) {
  const PeriodicBox box = orthorhombic_box(4, 2, 3);  // dyadic, all of it
  const PeriodicBox skewed{{4, 0, 0}, {4096, 2, 0}, {-400, 64, 3}};
  const std::vector<Point3> points = points_in(box, 30, 3, 16);
  std::vector<Point3> elsewhere = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int k = static_cast<int>(i) - 15;
    elsewhere[i] = shifted(points[i], {k * 100, -k * k, 7 * k}, box);
  }
  const PeriodicVoronoi3 a = value_of(periodic_voronoi(points, box));
  const PeriodicVoronoi3 b = value_of(periodic_voronoi(elsewhere, skewed));
  expect_sound(b, elsewhere, skewed);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(a.cells[i].volume, b.cells[i].volume, 1e-13);
    std::set<std::array<double, 3>> to_a, to_b;
    for (const PeriodicFace& f : a.cells[i].faces) {
      const Point3 p = shifted(points[f.neighbour], f.shift, box);
      to_a.insert({p.x - points[i].x, p.y - points[i].y, p.z - points[i].z});
    }
    for (const PeriodicFace& f : b.cells[i].faces) {
      const Point3 p = shifted(elsewhere[f.neighbour], f.shift, skewed);
      to_b.insert({p.x - elsewhere[i].x, p.y - elsewhere[i].y, p.z - elsewhere[i].z});
    }
    EXPECT_EQ(to_a, to_b);
  }
}

// Positive, of the torus (V − E + F − T = 0, F = 2 T), of the box's volume, once each; and on a
// coarse grid, where nothing is rounded and many spheres have more than four points, empty.
TEST(PeriodicDelaunay, TetsFillTheBoxAndTheirSpheresAreEmpty) {
  const PeriodicBox box{{4, 0, 0}, {1, 3, 0}, {-1, 1, 4}};
  for (const std::size_t n : {1U, 2U, 6U}) {
    std::vector<Point3> points = points_in(box, n, n + 2, 2);
    const std::vector<PeriodicTet> tets = value_of(periodic_delaunay(points, box)).tets;
    const PeriodicVoronoi3 diagram = value_of(periodic_voronoi(points, box));
    std::size_t faces = 0;
    for (const PeriodicCell& cell : diagram.cells) faces += cell.faces.size();
    EXPECT_EQ(tets.size(), faces / 2 - n);
    EXPECT_TRUE(std::is_sorted(tets.begin(), tets.end()));
    EXPECT_EQ(std::adjacent_find(tets.begin(), tets.end()), tets.end());
    double sum = 0;
    for (const PeriodicTet& tet : tets) {
      std::array<Point3, 4> p;
      for (std::size_t i = 0; i < 4; ++i) p[i] = shifted(points[tet.points[i]], tet.shifts[i], box);
      EXPECT_EQ(tet.shifts[0], LatticeShift{});
      EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), Sign::positive);
      const auto minus = [&](std::size_t i) {
        return Point3{p[i].x - p[0].x, p[i].y - p[0].y, p[i].z - p[0].z};
      };
      sum += volume_of({minus(1), minus(2), minus(3)}) / 6;
      for (int k = 0; k < 343; ++k) {
        for (const Point3& q : points) {
          const Point3 image = shifted(q, {k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3}, box);
          EXPECT_NE(insphere(p[0], p[1], p[2], p[3], image), Sign::positive);
        }
      }
    }
    EXPECT_NEAR(sum, volume_of(box), 1e-10);
  }
}

TEST(PeriodicSets, AreTheSameOnAnyNumberOfThreads) {
  const PeriodicBox box = orthorhombic_box(1, 1, 1);
  const std::vector<Point3> points = points_in(box, 600, 12);
  const PeriodicVoronoi3 one = value_of(periodic_voronoi(points, box, {.threads = 1}));
  const PeriodicVoronoi3 four = value_of(periodic_voronoi(points, box, {.threads = 4}));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one.cells[i].volume, four.cells[i].volume);
    EXPECT_EQ(one.cells[i].corners, four.cells[i].corners);
  }
  EXPECT_EQ(value_of(periodic_delaunay(points, box, {.threads = 1})).tets,
            value_of(periodic_delaunay(points, box, {.threads = 4})).tets);
}

ErrorCode refusal(const std::vector<Point3>& points, const PeriodicBox& box) {
  const auto result = periodic_voronoi(points, box);
  if (result) return ErrorCode::usage;
  EXPECT_EQ(periodic_delaunay(points, box).error().message, result.error().message);
  return result.error().code;
}

TEST(PeriodicSets, RefuseWhatIsNone) {
  const PeriodicBox box = orthorhombic_box(1, 2, 3);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Point3 p{0.5, 0.25, 0.125};
  EXPECT_EQ(refusal({p}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), ErrorCode::invalid_input);
  EXPECT_EQ(refusal({p}, orthorhombic_box(1, kNan, 1)), ErrorCode::invalid_input);
  EXPECT_EQ(refusal({p}, orthorhombic_box(1, 0x1p301, 1)), ErrorCode::invalid_input);
  EXPECT_EQ(refusal({p}, orthorhombic_box(1, 1, 0x1p30)), ErrorCode::unrepresentable);
  // Its reduction takes larger integers than are exact.
  EXPECT_EQ(refusal({p}, {{-931239, 931301, -931115},
                          {-33598315004.0, 33600687605.0, -33593569642.0},
                          {729818398729390.0, -729869936071737.0, 729715320569196.0}}),
            ErrorCode::unrepresentable);
  EXPECT_EQ(refusal({p, {kNan, 0, 0}}, box), ErrorCode::invalid_input);
  EXPECT_EQ(refusal({{1e50, 0, 0}}, box), ErrorCode::unrepresentable);
  EXPECT_EQ(periodic_voronoi(std::vector<Point3>{p}, orthorhombic_box(1, 1, 4000)).error().code,
            ErrorCode::work_limit);
  const Error same =
      periodic_voronoi(std::vector<Point3>{{0, 0, 0}, p, {1.5, -1.75, 3.125}}, box).error();
  EXPECT_EQ(same.code, ErrorCode::invalid_input);
  EXPECT_EQ(same.where.vertex, 2U);
  EXPECT_NE(same.message.find("points 1 and 2"), std::string::npos);
  EXPECT_TRUE(value_of(periodic_voronoi({}, box)).cells.empty());
  EXPECT_TRUE(value_of(periodic_delaunay({}, box)).tets.empty());
}

TEST(PeriodicSets, StopWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const std::vector<Point3> points{{0, 0, 0}};
  const PeriodicBox box = orthorhombic_box(1, 1, 1);
  EXPECT_EQ(periodic_voronoi(points, box, {.stop = source.get_token()}).error().code,
            ErrorCode::cancelled);
  EXPECT_EQ(periodic_delaunay(points, box, {.stop = source.get_token()}).error().code,
            ErrorCode::cancelled);
}

}  // namespace
}  // namespace tetloft::test
