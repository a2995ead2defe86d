#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include <gtest/gtest.h>

#include <tetloft/voronoi.hpp>

#include "core/prng.hpp"
#include "point_sets.hpp"

namespace tetloft::test {
namespace {

using internal::Prng;

constexpr NaturalWeights kBoth[] = {NaturalWeights::sibson, NaturalWeights::laplace};

Point3 mean(const DelaunayTriangulation3& t, const NaturalNeighbours& n) {
  Point3 sum;
  for (std::size_t i = 0; i < n.vertices.size(); ++i) {
    const Point3& p = t.point(n.vertices[i]);
    sum = {sum.x + n.weights[i] * p.x, sum.y + n.weights[i] * p.y, sum.z + n.weights[i] * p.z};
  }
  return sum;
}

void expect_weights(const DelaunayTriangulation3& t, const Point3& p, double tolerance) {
  for (const NaturalWeights kind : kBoth) {
    SCOPED_TRACE(name_of(kind));
    const NaturalNeighbours n = value_of(natural_neighbours(t, p, kind));
    ASSERT_EQ(n.vertices.size(), n.weights.size());
    EXPECT_TRUE(std::is_sorted(n.vertices.begin(), n.vertices.end()));
    double sum = 0;
    for (const double w : n.weights) {
      EXPECT_GE(w, 0);
      sum += w;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    const Point3 q = mean(t, n);
    EXPECT_NEAR(q.x, p.x, tolerance);
    EXPECT_NEAR(q.y, p.y, tolerance);
    EXPECT_NEAR(q.z, p.z, tolerance);
  }
}

TEST(NaturalNeighbours, HaveThePointAsMean) {
  Prng prng(7);
  for (const NamedPoints& set : voronoi_point_sets()) {
    const DelaunayTriangulation3 t = triangulated(set.points);
    if (t.dimension() < 3) continue;
    SCOPED_TRACE(set.name);
    int inside = 0;
    for (int i = 0; i < 40; ++i) {
      const Point3 p{prng.unit(), prng.unit(), prng.unit()};
      if (value_of(t.locate(p)).kind == LocationKind::outside) continue;
      ++inside;
      expect_weights(t, p, 1e-10);
    }
    EXPECT_GT(inside, 0);
  }
}

// Points of the finer lattice: on edges, facets and in the middle of cubes, and on the hull.
TEST(NaturalNeighbours, OnALatticeToo) {
  const DelaunayTriangulation3 t = triangulated(cubic_points(3));
  for (const Point3& p : cubic_points(9)) expect_weights(t, p, 1e-13);
  const NaturalNeighbours centre = value_of(natural_neighbours(t, {0.25, 0.25, 0.25}));
  for (std::size_t i = 0; i < centre.vertices.size(); ++i) {
    const Point3& p = t.point(centre.vertices[i]);
    const bool corner = std::max({p.x, p.y, p.z}) < 0.75;
    EXPECT_NEAR(centre.weights[i], corner ? 0.125 : 0, 1e-13);
  }
  const NaturalNeighbours face = value_of(natural_neighbours(t, {0.25, 0.25, 0}));
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    const Point3& p = t.point(face.vertices[i]);
    EXPECT_EQ(p.z, 0);
    EXPECT_NEAR(face.weights[i], std::max(p.x, p.y) < 0.75 ? 0.25 : 0, 1e-13);
  }
  const NaturalNeighbours edge = value_of(natural_neighbours(t, {0, 1, 0.125}));
  ASSERT_EQ(edge.vertices.size(), 2U);
  EXPECT_DOUBLE_EQ(std::max(edge.weights[0], edge.weights[1]), 0.75);
}

TEST(NaturalNeighbours, OfAVertexAreItself) {
  for (const std::vector<Point3>& points : {uniform_points(100, 2), cubic_points(4)}) {
    const DelaunayTriangulation3 t = triangulated(points);
    for (const DelaunayVertex v : t.vertices()) {
      for (const NaturalWeights kind : kBoth) {
        const NaturalNeighbours n = value_of(natural_neighbours(t, t.point(v), kind));
        EXPECT_EQ(n.vertices, std::vector<DelaunayVertex>{v});
        EXPECT_EQ(n.weights, std::vector<double>{1});
      }
      // An ulp beside it, and perhaps as near to the hull, goes nearly all to it.
      const Point3& p = t.point(v);
      const Point3 beside{std::nextafter(p.x, 0.5), std::nextafter(p.y, 0.5), p.z};
      const Result<NaturalNeighbours> n = natural_neighbours(t, beside);
      if (!n) continue;
      EXPECT_GT(*std::max_element(n->weights.begin(), n->weights.end()), 1 - 1e-5);
    }
  }
}

// Vertices beside each other, points beside the hull and between them.
TEST(NaturalNeighbours, AmongUlps) {
  constexpr std::uint64_t kSeed = 90;
  Prng prng(kSeed);
  const auto draw = [&] {
    double x = static_cast<double>(prng.below(3)) / 2;
    for (std::uint64_t k = prng.below(3); k > 0; --k) {
      x = std::nextafter(x, prng.chance(0.5) ? 2 : -2);
    }
    return x;
  };
  for (int round = 0; round < 15; ++round) {
    std::vector<Point3> points;
    for (int i = 0; i < 40; ++i) points.push_back({draw(), draw(), draw()});
    const DelaunayTriangulation3 t = triangulated(points);
    for (int i = 0; i < 6; ++i) {
      const Point3 p{draw(), draw(), draw()};
      if (value_of(t.locate(p)).kind != LocationKind::outside) expect_weights(t, p, 1e-5);
    }
  }
}

TEST(NaturalNeighbours, DoNotDependOnTheUnit) {
  const std::vector<Point3> points = uniform_points(60, 5);
  const NaturalNeighbours n = value_of(natural_neighbours(triangulated(points), {0.5, 0.5, 0.5}));
  for (const double k : {0x1p-299, 0x1p299}) {
    std::vector<Point3> scaled;
    for (const Point3& p : points) scaled.push_back({k * p.x, k * p.y, k * p.z});
    const Point3 centre{k / 2, k / 2, k / 2};
    EXPECT_EQ(value_of(natural_neighbours(triangulated(scaled), centre)).weights, n.weights);
  }
}

// What is taken is what the cells lose when the point becomes a vertex.
TEST(NaturalNeighbours, AreWhatAnInsertionTakes) {
  constexpr ClippingBox kLarge{{-9, -9, -9}, {10, 10, 10}};
  DelaunayTriangulation3 t = triangulated(uniform_points(200, 21));
  const Point3 p{0.4, 0.55, 0.5};
  const NaturalNeighbours n = value_of(natural_neighbours(t, p));
  std::vector<double> before;
  for (const DelaunayVertex v : n.vertices) {
    before.push_back(value_of(voronoi_cell(t, v, kLarge)).volume);
  }
  const DelaunayVertex added = value_of(t.insert(p)).vertex;
  EXPECT_EQ(t.neighbours(added), n.vertices);
  const double whole = value_of(voronoi_cell(t, added, kLarge)).volume;
  for (std::size_t i = 0; i < n.vertices.size(); ++i) {
    const double after = value_of(voronoi_cell(t, n.vertices[i], kLarge)).volume;
    EXPECT_NEAR((before[i] - after) / whole, n.weights[i], 1e-9);
  }
}

// Points in and outside of the hull, at vertices, on facets and edges, in no order.
std::vector<Point3> many_points(Prng& prng, std::size_t count) {
  std::vector<Point3> points;
  const auto on_grid = [&] { return static_cast<double>(prng.below(12)) / 8 - 0.125; };
  for (std::size_t i = 0; i < count; ++i) {
    if (prng.chance(0.5)) {
      points.push_back({on_grid(), on_grid(), on_grid()});
    } else {
      points.push_back({1.5 * prng.unit() - 0.25, prng.unit(), prng.unit()});
    }
  }
  return points;
}

TEST(NaturalNeighbours, OfManyAreThoseOfEach) {
  Prng prng(31);
  const std::vector<Point3> points = many_points(prng, 700);
  for (const std::vector<Point3>& of : {uniform_points(150, 3), cubic_points(5)}) {
    const DelaunayTriangulation3 t = triangulated(of);
    for (const NaturalWeights kind : kBoth) {
      const NaturalNeighboursOfMany all =
          value_of(natural_neighbours_of_many(t, points, kind, {.threads = 1}));
      std::size_t outside = 0;
      ASSERT_EQ(all.begin.size(), points.size() + 1);
      EXPECT_EQ(all.begin.front(), 0U);
      EXPECT_EQ(all.begin.back(), all.vertices.size());
      EXPECT_EQ(all.begin.back(), all.weights.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(all.begin[i]);
        const auto last = static_cast<std::ptrdiff_t>(all.begin[i + 1]);
        const Result<NaturalNeighbours> one = natural_neighbours(t, points[i], kind);
        outside += one ? 0U : 1U;
        const NaturalNeighbours expected = one ? *one : NaturalNeighbours{};
        EXPECT_EQ(std::vector(all.vertices.begin() + first, all.vertices.begin() + last),
                  expected.vertices);
        EXPECT_EQ(std::vector(all.weights.begin() + first, all.weights.begin() + last),
                  expected.weights);
      }
      EXPECT_GT(outside, 50U);
      EXPECT_LT(outside, 650U);
      for (const unsigned threads : {2U, 5U}) {
        const NaturalNeighboursOfMany again =
            value_of(natural_neighbours_of_many(t, points, kind, {.threads = threads}));
        EXPECT_EQ(again.begin, all.begin);
        EXPECT_EQ(again.vertices, all.vertices);
        EXPECT_EQ(again.weights, all.weights);
      }
    }
  }
}

TEST(NaturalNeighbours, OfManyAreNoneWithoutSpace) {
  const std::vector<Point3> points(3, Point3{0.25, 0.25, 0});
  for (const std::vector<Point3>& of :
       {std::vector<Point3>{}, std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const NaturalNeighboursOfMany none =
        value_of(natural_neighbours_of_many(triangulated(of), points));
    EXPECT_EQ(none.begin, std::vector<std::size_t>(4));
    EXPECT_TRUE(none.vertices.empty());
  }
  const DelaunayTriangulation3 t = triangulated(cubic_points(3));
  EXPECT_EQ(value_of(natural_neighbours_of_many(t, {})).begin, std::vector<std::size_t>(1));
}

TEST(NaturalNeighbours, OfManyAreRefusedTogether) {
  const DelaunayTriangulation3 t = triangulated(cubic_points(3));
  std::vector<Point3> points(3, Point3{0.5, 0.25, 0.5});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 0x1p301}) {
    points[1].z = bad;
    const Error error = natural_neighbours_of_many(t, points).error();
    EXPECT_EQ(error.code, ErrorCode::invalid_input);
    ASSERT_TRUE(error.where.point.has_value());
    EXPECT_EQ(error.where.point->y, 0.25);
  }
  EXPECT_EQ(natural_neighbours_of_many(t, {}, static_cast<NaturalWeights>(7)).error().code,
            ErrorCode::usage);
  std::stop_source stop;
  stop.request_stop();
  points[1].z = 0.5;
  EXPECT_EQ(natural_neighbours_of_many(t, points, {}, {.threads = 1, .stop = stop.get_token()})
                .error()
                .code,
            ErrorCode::cancelled);
}

TEST(NaturalNeighbours, AreRefusedOutside) {
  const DelaunayTriangulation3 t = triangulated(cubic_points(3));
  const auto code = [&](const Point3& p) { return natural_neighbours(t, p).error().code; };
  EXPECT_EQ(code({0.5, 0.5, std::nextafter(1.0, 2.0)}), ErrorCode::invalid_input);
  EXPECT_EQ(code({-1, 0.5, 0.5}), ErrorCode::invalid_input);
  EXPECT_EQ(code({0.5, std::numeric_limits<double>::quiet_NaN(), 0.5}), ErrorCode::invalid_input);
  EXPECT_EQ(natural_neighbours(t, {}, static_cast<NaturalWeights>(7)).error().code,
            ErrorCode::usage);
  const DelaunayTriangulation3 flat = triangulated({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(natural_neighbours(flat, {0.25, 0.25, 0}).error().code, ErrorCode::invalid_input);
}

}  // namespace
}  // namespace tetloft::test
