#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include <tetloft/voronoi.hpp>

#include "core/prng.hpp"
#include "point_sets.hpp"

namespace tetloft::test {
namespace {

using internal::Prng;

constexpr ClippingBox kUnit{{0, 0, 0}, {1, 1, 1}};

double sum_of_volumes(const std::vector<VoronoiCell3>& cells) {
  double sum = 0;
  for (const VoronoiCell3& cell : cells) sum += cell.volume;
  return sum;
}

// Each edge between two faces, run both ways; V − E + F = 2.
void expect_closed(const VoronoiCell3& cell) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::size_t faces = 0;
  for (const VoronoiFace3& face : cell.faces) {
    if (!face.corners.empty()) ++faces;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const std::uint32_t u = face.corners[i], v = face.corners[(i + 1) % face.corners.size()];
      ASSERT_LT(u, cell.corners.size());
      EXPECT_TRUE(edges.insert({u, v}).second);
    }
  }
  for (const auto& [u, v] : edges) EXPECT_TRUE(edges.contains({v, u}));
  if (edges.empty()) return;
  EXPECT_EQ(cell.corners.size() + faces, edges.size() / 2 + 2);
}

TEST(VoronoiCells, FillTheBox) {
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    const DelaunayTriangulation3 t = triangulated(set.points);
    ASSERT_EQ(t.dimension(), set.dimension);
    const std::vector<VoronoiCell3> cells = value_of(voronoi_cells(t, kUnit));
    ASSERT_EQ(cells.size(), t.vertex_count());
    EXPECT_NEAR(sum_of_volumes(cells), 1, 1e-13);
    std::map<BoxSide, double> sides;
    for (const VoronoiCell3& cell : cells) {
      EXPECT_TRUE(cell.bounded);
      expect_closed(cell);
      for (const VoronoiFace3& face : cell.faces) sides[face.side] += face.area;
    }
    for (int side = 1; side <= 6; ++side) {
      EXPECT_NEAR(sides[static_cast<BoxSide>(side)], 1, 1e-13) << side;
    }
  }
}

TEST(VoronoiCells, HaveTheNeighboursOfTheTriangulationAndFacesThatFit) {
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    const DelaunayTriangulation3 t = triangulated(set.points);
    std::map<std::array<DelaunayVertex, 2>, double> areas;
    for (const VoronoiCell3& cell : value_of(voronoi_cells(t, kUnit))) {
      std::vector<DelaunayVertex> neighbours;
      for (const VoronoiFace3& face : cell.faces) {
        EXPECT_EQ(face.neighbour.valid(), face.side == BoxSide::none);
        if (!face.neighbour.valid()) continue;
        neighbours.push_back(face.neighbour);
        areas[{cell.site, face.neighbour}] = face.area;
      }
      EXPECT_EQ(neighbours, t.neighbours(cell.site));
    }
    for (const auto& [pair, area] : areas) {
      // Of tiny clusters on the hull: nearly parallel bisectors of theirs, far away.
      EXPECT_NEAR(area, areas.at({pair[1], pair[0]}), set.name == "clusters" ? 1e-9 : 1e-12);
    }
  }
}

// Whoever is nearest to a point has it in the cell.
TEST(VoronoiCells, HoldWhatIsNearest) {
  Prng prng(5);
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    const DelaunayTriangulation3 t = triangulated(set.points);
    for (int i = 0; i < 20; ++i) {
      const Point3 p{prng.unit(), prng.unit(), prng.unit()};
      DelaunayVertex nearest;
      double least = 1e300;
      for (const DelaunayVertex v : t.vertices()) {
        const Point3& q = t.point(v);
        const double d = std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
        if (d < least) {
          least = d;
          nearest = v;
        }
      }
      const VoronoiCell3 cell = value_of(voronoi_cell(t, nearest, kUnit));
      for (const VoronoiFace3& face : cell.faces) {
        if (face.area < 1e-6) continue;
        const Point3& a = cell.corners[face.corners[0]];
        double volume = 0;  // six times, of the pyramid with apex p
        for (std::size_t k = 2; k < face.corners.size(); ++k) {
          const Point3& b = cell.corners[face.corners[k - 1]];
          const Point3& c = cell.corners[face.corners[k]];
          const Point3 u{a.x - p.x, a.y - p.y, a.z - p.z}, v{b.x - p.x, b.y - p.y, b.z - p.z},
              w{c.x - p.x, c.y - p.y, c.z - p.z};
          volume += u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
                    u.z * (v.x * w.y - v.y * w.x);
        }
        EXPECT_GT(volume, -1e-12);
      }
    }
  }
}

TEST(VoronoiCells, OfACubicLatticeAreCubes) {
  const DelaunayTriangulation3 t = triangulated(cubic_points(5));
  for (const VoronoiCell3& cell : value_of(voronoi_cells(t))) {
    const Point3& p = t.point(cell.site);
    const bool inner = std::min({p.x, p.y, p.z}) > 0 && std::max({p.x, p.y, p.z}) < 1;
    EXPECT_EQ(cell.bounded, inner);
    if (!inner) {
      EXPECT_TRUE(std::isinf(cell.volume));
      continue;
    }
    EXPECT_NEAR(cell.volume, 1.0 / 64, 1e-16);
    expect_closed(cell);
    std::size_t true_faces = 0;
    for (const VoronoiFace3& face : cell.faces) {
      if (face.area == 0) continue;  // the corners are dyadic: nothing is rounded
      EXPECT_NEAR(face.area, 1.0 / 16, 1e-16);
      ++true_faces;
    }
    EXPECT_EQ(true_faces, 6U);
  }
}

TEST(VoronoiCells, WholeOnesAreThoseClippedToABoxThatHoldsThem) {
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    const DelaunayTriangulation3 t = triangulated(set.points);
    for (const VoronoiCell3& cell : value_of(voronoi_cells(t))) {
      EXPECT_EQ(cell.bounded, t.dimension() == 3 && !t.is_on_hull(cell.site));
      EXPECT_EQ(cell.bounded, std::isfinite(cell.volume));
      if (!cell.bounded) continue;
      expect_closed(cell);
      ClippingBox box{cell.corners[0], cell.corners[0]};
      for (const Point3& p : cell.corners) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y),
                    std::max(box.high.z, p.z)};
      }
      const Point3 size{box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
      box = {{box.low.x - size.x, box.low.y - size.y, box.low.z - size.z},
             {box.high.x + size.x, box.high.y + size.y, box.high.z + size.z}};
      const VoronoiCell3 clipped = value_of(voronoi_cell(t, cell.site, box));
      EXPECT_NEAR(clipped.volume / cell.volume, 1, 1e-9);
      ASSERT_EQ(clipped.faces.size(), cell.faces.size());
      const double scale = std::pow(cell.volume, 2.0 / 3);
      for (std::size_t i = 0; i < cell.faces.size(); ++i) {
        EXPECT_NEAR(clipped.faces[i].area / scale, cell.faces[i].area / scale, 1e-7);
      }
    }
  }
}

// Dyadic points, moved by what changes none of their differences.
TEST(VoronoiCells, FarFromTheOriginLoseNothing) {
  Prng prng(9);
  std::vector<Point3> near, far;
  const double shift = 0x1p30;
  for (int i = 0; i < 200; ++i) {
    const auto draw = [&] { return std::ldexp(static_cast<double>(prng.below(1 << 20)), -20); };
    near.push_back({draw(), draw(), draw()});
    far.push_back({near.back().x + shift, near.back().y - shift, near.back().z + shift});
  }
  const DelaunayTriangulation3 t = triangulated(near), moved = triangulated(far);
  const ClippingBox box{{shift, -shift, shift}, {shift + 1, 1 - shift, shift + 1}};
  const std::vector<VoronoiCell3> a = value_of(voronoi_cells(t, kUnit));
  const std::vector<VoronoiCell3> b = value_of(voronoi_cells(moved, box));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].volume, b[i].volume);
}

// Of a cluster 2^40 times smaller than the box: cells deep inside are as large as whole ones.
TEST(VoronoiCells, OfTinyClustersInALargeBoxKeepTheirVolumes) {
  std::vector<Point3> points;
  for (const Point3& p : uniform_points(60, 4)) {
    points.push_back(
        {std::ldexp(p.x - 0.5, -40), std::ldexp(p.y - 0.5, -40), std::ldexp(p.z - 0.5, -40)});
  }
  const DelaunayTriangulation3 t = triangulated(points);
  int inside = 0;
  for (const VoronoiCell3& cell : value_of(voronoi_cells(t))) {
    if (!cell.bounded || cell.volume > 0x1p-120) continue;
    ++inside;
    const double clipped = value_of(voronoi_cell(t, cell.site, {{-1, -1, -1}, {1, 1, 1}})).volume;
    EXPECT_NEAR(clipped / cell.volume, 1, 1e-9);
  }
  EXPECT_GT(inside, 0);
}

TEST(VoronoiCells, AreTheSameOnAnyNumberOfThreads) {
  const DelaunayTriangulation3 t = triangulated(uniform_points(700, 8));
  const std::vector<VoronoiCell3> one = value_of(voronoi_cells(t, kUnit, {.threads = 1}));
  const std::vector<VoronoiCell3> four = value_of(voronoi_cells(t, kUnit, {.threads = 4}));
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].volume, four[i].volume);
    EXPECT_EQ(one[i].corners, four[i].corners);
  }
}

// Tet by tet, as from corners and faces.
TEST(VoronoiVolumes, AreThoseOfTheCells) {
  for (const NamedPoints& set : voronoi_point_sets()) {
    SCOPED_TRACE(set.name);
    DelaunayTriangulation3 t = triangulated(set.points);
    if (t.vertex_count() > 20) {
      EXPECT_TRUE(t.remove(*t.vertices().begin()));
    }
    const std::vector<double> volumes = value_of(voronoi_volumes(t, {.threads = 3}));
    EXPECT_EQ(volumes, value_of(voronoi_volumes(t, {.threads = 1})));
    ASSERT_EQ(volumes.size(), t.vertex_slots());
    std::vector<double> expected(volumes.size());
    for (const VoronoiCell3& cell : value_of(voronoi_cells(t))) {
      expected[cell.site.index] = cell.volume;
    }
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      ASSERT_EQ(std::isinf(volumes[i]), std::isinf(expected[i])) << i;
      if (std::isinf(volumes[i])) continue;
      EXPECT_NEAR(volumes[i], expected[i], 1e-9 * expected[i]) << i;
    }
  }
}

TEST(VoronoiVolumes, DoNotDependOnTheUnit) {
  const std::vector<Point3> points = uniform_points(60, 5);
  const std::vector<double> volumes = value_of(voronoi_volumes(triangulated(points)));
  for (const int power : {-290, -150, 150, 290}) {
    SCOPED_TRACE(power);
    std::vector<Point3> scaled;
    for (const Point3& p : points) {
      scaled.push_back({std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)});
    }
    const std::vector<double> found = value_of(voronoi_volumes(triangulated(scaled)));
    ASSERT_EQ(found.size(), volumes.size());
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      EXPECT_EQ(found[i], std::ldexp(volumes[i], 3 * power));
    }
  }
}

TEST(VoronoiVolumes, RefuseWhatIsTooFar) {
  DelaunayTriangulation3 t = triangulated(cubic_points(3));
  EXPECT_EQ(value_of(voronoi_volumes(DelaunayTriangulation3())).size(), 0U);
  const auto far = value_of(t.insert({0x1p301, 0, 0}));
  EXPECT_EQ(voronoi_volumes(t).error().where.vertex, far.vertex.index);
}

TEST(VoronoiCells, RefuseWhatIsNone) {
  DelaunayTriangulation3 t = triangulated(cubic_points(3));
  const DelaunayVertex gone = t.vertex_at(3), kept = t.vertex_at(4);
  ASSERT_TRUE(t.remove(gone));
  EXPECT_EQ(voronoi_cell(t, gone).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cell(t, DelaunayVertex(), kUnit).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cell(t, kept, {{0, 2, 0}, {1, 1, 1}}).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t, {{0, 0, 0}, {1, 1, NAN}}).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(voronoi_cells(t, {{0, 0, 0}, {1, 1, 0x1p301}}).error().code, ErrorCode::invalid_input);
  const auto far = value_of(t.insert({0x1p301, 0, 0}));
  EXPECT_EQ(voronoi_cell(t, far.vertex, kUnit).error().where.vertex, far.vertex.index);
  EXPECT_EQ(voronoi_cells(t, kUnit).error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(value_of(voronoi_cells(DelaunayTriangulation3(), kUnit)).empty());
  // A box without volume.
  EXPECT_EQ(value_of(voronoi_cell(t, kept, {{0, 0, 0}, {1, 1, 0}})).volume, 0);
}

TEST(VoronoiCells, StopWhenAsked) {
  const DelaunayTriangulation3 t = triangulated(uniform_points(50, 8));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(voronoi_cells(t, kUnit, {.stop = source.get_token()}).error().code,
            ErrorCode::cancelled);
}

}  // namespace
}  // namespace tetloft::test
