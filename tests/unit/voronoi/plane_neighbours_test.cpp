// Natural neighbours in the plane.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <tetloft/voronoi2.hpp>

#include "core/prng.hpp"
#include "point_sets.hpp"

namespace tetloft::test {
namespace {

using internal::Prng;

constexpr NaturalWeights kBothKinds[] = {NaturalWeights::sibson, NaturalWeights::laplace};

DelaunayTriangulation2 plane_of(const std::vector<Point2>& points) {
  return value_of(DelaunayTriangulation2::of(points));
}

std::vector<Point2> square_lattice(int n) {
  std::vector<Point2> points;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) points.push_back({x / (n - 1.0), y / (n - 1.0)});
  }
  return points;
}

std::vector<Point2> uniform_plane_points(std::size_t n, std::uint64_t seed) {
  std::vector<Point2> points;
  for (const Point3& p : uniform_points(n, seed)) points.push_back({p.x, p.y});
  return points;
}

void expect_mean(const DelaunayTriangulation2& t, const Point2& p, double tolerance) {
  for (const NaturalWeights kind : kBothKinds) {
    SCOPED_TRACE(name_of(kind));
    const NaturalNeighbours n = value_of(natural_neighbours(t, p, kind));
    ASSERT_EQ(n.vertices.size(), n.weights.size());
    EXPECT_TRUE(std::is_sorted(n.vertices.begin(), n.vertices.end()));
    double sum = 0;
    Point2 mean{0, 0};
    for (std::size_t i = 0; i < n.vertices.size(); ++i) {
      EXPECT_GE(n.weights[i], 0);
      sum += n.weights[i];
      const Point2& q = t.point(n.vertices[i]);
      mean = {mean.x + n.weights[i] * q.x, mean.y + n.weights[i] * q.y};
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_NEAR(mean.x, p.x, tolerance);
    EXPECT_NEAR(mean.y, p.y, tolerance);
  }
}

TEST(PlaneNeighbours, HaveThePointAsMean) {
  Prng prng(7);
  for (const NamedPoints& set : voronoi_point_sets()) {
    std::vector<Point2> points;
    for (const Point3& p : set.points) points.push_back({p.x, p.y});
    const DelaunayTriangulation2 t = plane_of(points);
    if (t.dimension() < 2) continue;
    SCOPED_TRACE(set.name);
    int inside = 0;
    for (int i = 0; i < 60; ++i) {
      const Point2 p{prng.unit(), prng.unit()};
      if (value_of(t.locate(p)).kind == LocationKind::outside) continue;
      ++inside;
      expect_mean(t, p, 1e-10);
    }
    EXPECT_GT(inside, 0);
  }
}

// Points of the finer lattice: on edges, in the middle of squares, and on the hull.
TEST(PlaneNeighbours, OnALatticeToo) {
  const DelaunayTriangulation2 t = plane_of(square_lattice(3));
  for (const Point2& p : square_lattice(17)) expect_mean(t, p, 1e-14);
  const NaturalNeighbours centre = value_of(natural_neighbours(t, {0.25, 0.25}));
  for (std::size_t i = 0; i < centre.vertices.size(); ++i) {
    const Point2& p = t.point(centre.vertices[i]);
    EXPECT_NEAR(centre.weights[i], std::max(p.x, p.y) < 0.75 ? 0.25 : 0, 1e-15);
  }
  const NaturalNeighbours edge = value_of(natural_neighbours(t, {0, 0.125}));
  ASSERT_EQ(edge.vertices.size(), 2U);
  EXPECT_DOUBLE_EQ(std::max(edge.weights[0], edge.weights[1]), 0.75);
}

// What is taken is what the cells lose when the point becomes a vertex; edges over distances.
TEST(PlaneNeighbours, AreWhatAnInsertionTakes) {
  constexpr ClippingRectangle kLarge{{-9, -9}, {10, 10}};
  const DelaunayTriangulation2 t = plane_of(uniform_plane_points(300, 21));
  Prng prng(4);
  for (int round = 0; round < 40; ++round) {
    const Point2 p{0.2 + 0.6 * prng.unit(), 0.2 + 0.6 * prng.unit()};
    const NaturalNeighbours taken = value_of(natural_neighbours(t, p));
    const NaturalNeighbours along = value_of(natural_neighbours(t, p, NaturalWeights::laplace));
    DelaunayTriangulation2 with = t;
    const DelaunayVertex added = value_of(with.insert(p)).vertex;
    ASSERT_EQ(with.neighbours(added), taken.vertices);
    ASSERT_EQ(along.vertices, taken.vertices);
    const VoronoiCell2 cell = value_of(voronoi_cell(with, added, kLarge));
    double sum = 0;
    std::vector<double> ratios;
    for (const VoronoiEdge2& edge : cell.edges) {
      const Point2& q = with.point(edge.neighbour);
      ratios.push_back(edge.length / std::hypot(q.x - p.x, q.y - p.y));
      sum += ratios.back();
    }
    for (std::size_t i = 0; i < taken.vertices.size(); ++i) {
      const double before = value_of(voronoi_cell(t, taken.vertices[i], kLarge)).area;
      const double after = value_of(voronoi_cell(with, taken.vertices[i], kLarge)).area;
      EXPECT_NEAR((before - after) / cell.area, taken.weights[i], 1e-9);
      EXPECT_NEAR(ratios[i] / sum, along.weights[i], 1e-12);
    }
  }
}

TEST(PlaneNeighbours, OfAVertexAreItself) {
  for (const std::vector<Point2>& points : {uniform_plane_points(100, 2), square_lattice(4)}) {
    const DelaunayTriangulation2 t = plane_of(points);
    for (const DelaunayVertex v : t.vertices()) {
      for (const NaturalWeights kind : kBothKinds) {
        const NaturalNeighbours n = value_of(natural_neighbours(t, t.point(v), kind));
        EXPECT_EQ(n.vertices, std::vector<DelaunayVertex>{v});
        EXPECT_EQ(n.weights, std::vector<double>{1});
      }
      // An ulp beside it, and perhaps as near to the hull, goes nearly all to it.
      const Point2& p = t.point(v);
      const Result<NaturalNeighbours> n =
          natural_neighbours(t, {std::nextafter(p.x, 0.5), std::nextafter(p.y, 0.5)});
      if (!n) continue;
      EXPECT_GT(*std::max_element(n->weights.begin(), n->weights.end()), 1 - 1e-5);
    }
  }
}

// Vertices beside each other, points beside the hull and between them.
TEST(PlaneNeighbours, AmongUlps) {
  Prng prng(90);
  const auto draw = [&] {
    double x = static_cast<double>(prng.below(3)) / 2;
    for (std::uint64_t k = prng.below(3); k > 0; --k) {
      x = std::nextafter(x, prng.chance(0.5) ? 2 : -2);
    }
    return x;
  };
  for (int round = 0; round < 60; ++round) {
    std::vector<Point2> points;
    for (int i = 0; i < 25; ++i) points.push_back({draw(), draw()});
    const DelaunayTriangulation2 t = plane_of(points);
    if (t.dimension() < 2) continue;
    for (int i = 0; i < 20; ++i) {
      const Point2 p{draw(), draw()};
      if (value_of(t.locate(p)).kind != LocationKind::outside) expect_mean(t, p, 1e-5);
    }
  }
}

TEST(PlaneNeighbours, DoNotDependOnTheUnit) {
  const std::vector<Point2> points = uniform_plane_points(60, 5);
  for (const NaturalWeights kind : kBothKinds) {
    const NaturalNeighbours n = value_of(natural_neighbours(plane_of(points), {0.5, 0.5}, kind));
    for (const double k : {0x1p-299, 0x1p299}) {
      std::vector<Point2> scaled;
      for (const Point2& p : points) scaled.push_back({k * p.x, k * p.y});
      EXPECT_EQ(value_of(natural_neighbours(plane_of(scaled), {k / 2, k / 2}, kind)).weights,
                n.weights);
    }
  }
}

TEST(PlaneNeighbours, OfManyAreThoseOfEach) {
  Prng prng(12);
  for (const std::vector<Point2>& points :
       {uniform_plane_points(300, 8), square_lattice(5), {{0, 0}, {1, 1}}, {}}) {
    const DelaunayTriangulation2 t = plane_of(points);
    std::vector<Point2> asked;
    for (int i = 0; i < 700; ++i) {
      asked.push_back({1.2 * prng.unit() - 0.1, static_cast<double>(prng.below(9)) / 8});
    }
    for (const NaturalWeights kind : kBothKinds) {
      for (const unsigned threads : {1U, 3U}) {
        const NaturalNeighboursOfMany many =
            value_of(natural_neighbours_of_many(t, asked, kind, {.threads = threads}));
        ASSERT_EQ(many.begin.size(), asked.size() + 1);
        EXPECT_EQ(many.begin.back(), many.vertices.size());
        for (std::size_t i = 0; i < asked.size(); ++i) {
          const auto first = static_cast<std::ptrdiff_t>(many.begin[i]);
          const auto last = static_cast<std::ptrdiff_t>(many.begin[i + 1]);
          const Result<NaturalNeighbours> one = natural_neighbours(t, asked[i], kind);
          const NaturalNeighbours expected = one ? *one : NaturalNeighbours();
          EXPECT_EQ(std::vector(many.vertices.begin() + first, many.vertices.begin() + last),
                    expected.vertices);
          EXPECT_EQ(std::vector(many.weights.begin() + first, many.weights.begin() + last),
                    expected.weights);
        }
      }
    }
  }
}

TEST(PlaneNeighbours, AreRefusedOutsideAndAmongConstraints) {
  DelaunayTriangulation2 t = plane_of(square_lattice(3));
  const auto code = [&](const Point2& p) { return natural_neighbours(t, p).error().code; };
  EXPECT_EQ(code({0.5, std::nextafter(1.0, 2.0)}), ErrorCode::invalid_input);
  EXPECT_EQ(code({-1, 0.5}), ErrorCode::invalid_input);
  EXPECT_EQ(code({std::numeric_limits<double>::quiet_NaN(), 0.5}), ErrorCode::invalid_input);
  EXPECT_EQ(natural_neighbours(t, {}, static_cast<NaturalWeights>(7)).error().code,
            ErrorCode::usage);
  EXPECT_EQ(natural_neighbours(plane_of({{0, 0}, {1, 1}}), {0.5, 0.5}).error().code,
            ErrorCode::invalid_input);
  EXPECT_EQ(natural_neighbours(plane_of({{0, 0}, {1, 0}, {0, 0x1p301}}), {0.25, 0.25}).error().code,
            ErrorCode::invalid_input);
  const auto c = t.insert_constraint(t.vertex_at(0), t.vertex_at(1));
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(code({0.3, 0.3}), ErrorCode::invalid_input);
  const std::vector<Point2> asked{{0.3, 0.3}};
  EXPECT_EQ(natural_neighbours_of_many(t, asked).error().code, ErrorCode::invalid_input);
  ASSERT_TRUE(t.remove_constraint(*c).ok());
  EXPECT_TRUE(natural_neighbours(t, {0.3, 0.3}).ok());
}

}  // namespace
}  // namespace tetloft::test
