// triangles_touch() against the oracle, its images under exact maps, and cases by hand.
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "contact/contact.hpp"
#include "core/prng.hpp"
#include "unit/contact/oracle.hpp"

namespace tetloft::contact_test {

using namespace internal;
namespace {

TriangleVertices triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {VertexId(a), VertexId(b), VertexId(c)};
}

std::vector<Grid3> grid(Int nx, Int ny, Int nz) {
  std::vector<Grid3> points;
  for (Int z = 0; z < nz; ++z) {
    for (Int y = 0; y < ny; ++y) {
      for (Int x = 0; x < nx; ++x) points.push_back({x, y, z});
    }
  }
  return points;
}

std::vector<Point3> to_points(const std::vector<Grid3>& points) {
  std::vector<Point3> result;
  for (const Grid3& p : points) {
    result.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  }
  return result;
}

/// All pairs of the triangles, degenerate ones included, on the given points.
void expect_agreement_on_all_pairs(const std::vector<Grid3>& points) {
  const std::vector<Point3> doubles = to_points(points);
  std::vector<TriangleVertices> triangles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) triangles.push_back(triangle(i, k, j));
    }
  }
  for (const TriangleVertices& a : triangles) {
    for (const TriangleVertices& b : triangles) {
      ASSERT_EQ(triangles_touch(doubles, a, b), oracle_touch(points, a, b))
          << a[0].value() << ' ' << a[1].value() << ' ' << a[2].value() << " / " << b[0].value()
          << ' ' << b[1].value() << ' ' << b[2].value();
    }
  }
}

TEST(TrianglesTouch, AgreesWithLinearAlgebraOnAllTrianglesOfACube) {
  expect_agreement_on_all_pairs(grid(2, 2, 2));
}

TEST(TrianglesTouch, AgreesWithLinearAlgebraOnAllTrianglesOfAPlaneGrid) {
  expect_agreement_on_all_pairs(grid(3, 3, 1));
}

/// Two triangles on a small grid that share 0 to 3 vertices by id.
struct Sample {
  std::vector<Grid3> points;
  TriangleVertices a, b;
  std::size_t shared = 0;
};

Sample random_sample(Prng& random) {
  Sample s;
  const bool flat = random.chance(0.2);
  const std::uint64_t size = 2 + random.below(3);
  for (int i = 0; i < 6; ++i) {
    s.points.push_back({static_cast<Int>(random.below(size + 1)),
                        static_cast<Int>(random.below(size)),
                        flat ? 0 : static_cast<Int>(random.below(size))});
  }
  if (flat && random.chance(0.5)) {
    for (Grid3& p : s.points) p = {p[0], p[1], p[0] + 2 * p[1]};
  }
  s.shared = random.below(10) == 0 ? 3 : random.below(3);
  std::array<std::size_t, 3> b{3, 4, 5};
  for (std::size_t i = 0; i < s.shared; ++i) b[i] = i;
  std::array<std::size_t, 3> a{0, 1, 2};
  random.shuffle(a);
  random.shuffle(b);
  s.a = triangle(a[0], a[1], a[2]);
  s.b = triangle(b[0], b[1], b[2]);
  return s;
}

TEST(TrianglesTouch, AgreesWithLinearAlgebraOnRandomGridTriangles) {
  Prng random(21);
  std::array<std::array<int, 2>, 4> seen{};
  for (int round = 0; round < 25000; ++round) {
    const Sample s = random_sample(random);
    const bool expected = oracle_touch(s.points, s.a, s.b);
    ++seen[s.shared][expected ? 1 : 0];
    const std::vector<Point3> points = to_points(s.points);
    ASSERT_EQ(triangles_touch(points, s.a, s.b), expected) << "round " << round;
    ASSERT_EQ(triangles_touch(points, s.b, s.a), expected) << "swapped, round " << round;
  }
  for (std::size_t shared = 0; shared < 3; ++shared) {
    EXPECT_GT(seen[shared][0], 1000) << shared;
    EXPECT_GT(seen[shared][1], 1000) << shared;
  }
}

TEST(TrianglesTouch, IsInvariantUnderExactAffineMaps) {
  // Contact is an affine notion; these maps are exact in doubles on small integers. The
  // shears make slivers of everything, the powers of two leave every filter's range.
  const double big = 0x1p50;
  const double odd = 20000003.0;  // 16 times its square is below 2^53
  const std::vector<std::function<Point3(const Point3&)>> maps{
      [](const Point3& p) {
        return Point3{p.z, p.x, p.y};
      },
      [](const Point3& p) {
        return Point3{p.y, -p.x, p.z};
      },
      [=](const Point3& p) {
        return Point3{p.x + big, p.y - big, p.z + big};
      },
      [=](const Point3& p) {
        return Point3{p.x + odd * p.y, p.y, p.z};
      },
      [=](const Point3& p) {
        return Point3{p.x + odd * p.z, p.y - odd * p.z, p.z};
      },
      [=](const Point3& p) {
        return Point3{p.x + odd * p.y, p.y + odd * p.z, odd * (p.x + odd * p.y) + p.z};
      },
      [](const Point3& p) {
        return Point3{p.x * 0x1p1000, p.y * 0x1p1000, p.z * 0x1p1000};
      },
      [](const Point3& p) {
        return Point3{p.x * 0x1p-1074, p.y * 0x1p-1074, p.z * 0x1p-1074};
      },
      [](const Point3& p) {
        return Point3{p.x * 0x1p1000, p.y, p.z * 0x1p-1000};
      },
  };
  Prng random(22);
  for (int round = 0; round < 1500; ++round) {
    const Sample s = random_sample(random);
    const bool expected = oracle_touch(s.points, s.a, s.b);
    const std::vector<Point3> points = to_points(s.points);
    for (std::size_t m = 0; m < maps.size(); ++m) {
      std::vector<Point3> image;
      for (const Point3& p : points) image.push_back(maps[m](p));
      ASSERT_EQ(triangles_touch(image, s.a, s.b), expected) << "map " << m << " round " << round;
    }
  }
}

TEST(TrianglesTouch, OneUlpDecides) {
  // The plane x + y + z = 1, and a second triangle with one vertex near a point of it.
  const double third = 0.3125;  // exact, and 0.3125 + 0.3125 + 0.375 = 1
  const double on = 0.375;
  const double above = std::nextafter(on, 1.0);
  const double below = std::nextafter(on, 0.0);
  for (const auto& [z, expected] : {std::pair{on, true}, {above, false}, {below, true}}) {
    const std::vector<Point3> points{{1, 0, 0},         {0, 1, 0}, {0, 0, 1},
                                     {third, third, z}, {1, 1, 2}, {2, 1, 1}};
    EXPECT_EQ(triangles_touch(points, triangle(0, 1, 2), triangle(3, 4, 5)), expected) << z;
  }
}

TEST(TrianglesTouch, OneUlpOffAnEdgeDecides) {
  // In the plane z = 7: a vertex at the middle of the edge from (0, 0) to (1, 3).
  const double x = 0.5;
  for (const auto& [at, expected] :
       {std::pair{x, true}, {std::nextafter(x, 1.0), false}, {std::nextafter(x, 0.0), true}}) {
    const std::vector<Point3> points{{0, 0, 7},    {1, 3, 7}, {-1, 3, 7},
                                     {at, 1.5, 7}, {5, 1, 7}, {5, 2, 7}};
    EXPECT_EQ(triangles_touch(points, triangle(0, 1, 2), triangle(3, 4, 5)), expected) << at;
  }
}

/// A case by hand: triangle 0 1 2 is (0,0,0), (4,0,0), (0,4,0).
struct Case {
  const char* name;
  std::array<Grid3, 3> others;  // vertices 3, 4, 5
  std::array<std::size_t, 3> b;
  bool touch;
};

TEST(TrianglesTouch, DecidesEachKindOfContact) {
  const std::vector<Case> cases{
      {"pierced face", {{{1, 1, -1}, {1, 1, 1}, {5, 5, 1}}}, {3, 4, 5}, true},
      {"vertex in face", {{{1, 1, 0}, {1, 1, 1}, {5, 5, 1}}}, {3, 4, 5}, true},
      {"vertex on edge", {{{2, 2, 0}, {1, 1, 1}, {5, 5, 1}}}, {3, 4, 5}, true},
      {"vertex on vertex", {{{0, 0, 0}, {1, 1, 1}, {5, 5, 1}}}, {3, 4, 5}, true},
      {"edge crosses edge", {{{2, -1, -1}, {2, 1, 1}, {2, -5, 1}}}, {3, 4, 5}, true},
      {"edge in face", {{{1, 1, 0}, {1, 2, 0}, {1, 1, 3}}}, {3, 4, 5}, true},
      {"edge on edge, overlapping", {{{2, 0, 0}, {6, 0, 0}, {2, 0, 3}}}, {3, 4, 5}, true},
      {"edge on edge, end to end", {{{4, 0, 0}, {6, 0, 0}, {5, 0, 3}}}, {3, 4, 5}, true},
      {"edge beyond edge", {{{5, 0, 0}, {6, 0, 0}, {5, 0, 3}}}, {3, 4, 5}, false},
      {"above", {{{1, 1, 1}, {1, 2, 1}, {2, 1, 1}}}, {3, 4, 5}, false},
      {"beside, crossing the plane", {{{5, 1, -1}, {5, 1, 1}, {7, 1, 1}}}, {3, 4, 5}, false},
      {"coplanar inside", {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}, {3, 4, 5}, true},
      {"coplanar around", {{{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}}, {3, 4, 5}, true},
      {"coplanar apart", {{{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}}, {3, 4, 5}, false},
      {"coplanar, vertex on edge", {{{2, 2, 0}, {4, 3, 0}, {3, 4, 0}}}, {3, 4, 5}, true},
      {"shared edge, folded", {{{1, 1, 1}, {9, 9, 9}, {9, 9, 9}}}, {0, 1, 3}, false},
      {"shared edge, flat", {{{1, -3, 0}, {9, 9, 9}, {9, 9, 9}}}, {0, 1, 3}, false},
      {"shared edge, folded onto", {{{1, 3, 0}, {9, 9, 9}, {9, 9, 9}}}, {1, 0, 3}, true},
      {"shared vertex only", {{{-1, 0, 0}, {0, -1, 1}, {9, 9, 9}}}, {0, 3, 4}, false},
      {"shared vertex, pierced", {{{1, 2, 1}, {2, 1, -1}, {9, 9, 9}}}, {0, 3, 4}, true},
      {"shared vertex, edge in face", {{{1, 1, 0}, {2, 1, 1}, {9, 9, 9}}}, {0, 3, 4}, true},
      {"shared vertex, edge on edge", {{{8, 0, 0}, {2, -1, 1}, {9, 9, 9}}}, {0, 3, 4}, true},
      {"shared vertex, fan", {{{-1, 0, 0}, {-1, -1, 0}, {9, 9, 9}}}, {0, 3, 4}, false},
      {"shared vertex, fan touching", {{{0, 2, 0}, {-2, 1, 0}, {9, 9, 9}}}, {0, 3, 4}, true},
      {"shared vertex, fan around", {{{8, -1, 0}, {-1, 8, 0}, {9, 9, 9}}}, {0, 3, 4}, true},
      {"the same", {{{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}}, {2, 0, 1}, true},
      {"shared edge, other at the same place",
       {{{0, 4, 0}, {9, 9, 9}, {9, 9, 9}}},
       {0, 1, 3},
       true},
      {"segment through face", {{{1, 1, -1}, {1, 1, 1}, {1, 1, 0}}}, {3, 4, 5}, true},
      {"segment beside", {{{5, 1, -1}, {5, 1, 1}, {5, 1, 0}}}, {3, 4, 5}, false},
      {"point in face", {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, {3, 4, 5}, true},
      {"point above", {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, {3, 4, 5}, false},
      {"vertex named twice", {{{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}}, {0, 3, 3}, true},
  };
  for (const Case& c : cases) {
    std::vector<Grid3> grid_points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    grid_points.insert(grid_points.end(), c.others.begin(), c.others.end());
    const std::vector<Point3> points = to_points(grid_points);
    const TriangleVertices b = triangle(c.b[0], c.b[1], c.b[2]);
    EXPECT_EQ(triangles_touch(points, triangle(0, 1, 2), b), c.touch) << c.name;
    EXPECT_EQ(triangles_touch(points, b, triangle(2, 1, 0)), c.touch) << c.name;
    EXPECT_EQ(oracle_touch(grid_points, triangle(0, 1, 2), b), c.touch) << "oracle: " << c.name;
  }
}

TEST(TrianglesTouch, TwoSegmentsMeetOnlyWhereTheyDo) {
  const std::vector<Point3> points{{0, 0, 0}, {4, 4, 4}, {2, 2, 2}, {2, 2, 2},
                                   {2, 2, 9}, {3, 3, 4}, {3, 3, 9}};
  EXPECT_TRUE(triangles_touch(points, triangle(0, 1, 2), triangle(3, 4, 4)));
  EXPECT_FALSE(triangles_touch(points, triangle(0, 1, 2), triangle(5, 6, 6)));
  EXPECT_TRUE(triangles_touch(points, triangle(2, 2, 2), triangle(3, 3, 3)));
  EXPECT_FALSE(triangles_touch(points, triangle(2, 2, 2), triangle(5, 5, 5)));
}

TEST(TrianglesTouch, SegmentsInOneCoordinatePlaneMayOverlapInBoxOnly) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = [axis](double u, double v) {
      std::array<double, 3> p{};
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      return Point3{p[0], p[1], p[2]};
    };
    const std::vector<Point3> points{at(0, 0), at(4, 4), at(2, 0), at(4, 3), at(0, 3)};
    EXPECT_FALSE(triangles_touch(points, triangle(0, 1, 1), triangle(2, 3, 3)));
    EXPECT_TRUE(triangles_touch(points, triangle(0, 1, 1), triangle(3, 4, 4)));
  }
}

}  // namespace
}  // namespace tetloft::contact_test
