#include "planar_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetloft::test {

Points lattice(int nx, int ny) {
  Points points;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) points.push_back({double(x), double(y)});
  }
  return points;
}

Points uniform(std::size_t n, Prng& prng) {
  Points points(n);
  for (Point2& p : points) p = {prng.unit(), prng.unit()};
  return points;
}

Points grid_subset(std::size_t n, int side, Prng& prng) {
  Points points = lattice(side, side);
  prng.shuffle(points);
  points.resize(std::min(n, points.size()));
  return points;
}

Points integer_circle(int squared_radius) {
  Points points;
  for (int x = -squared_radius; x <= squared_radius; ++x) {
    for (int y = -squared_radius; y <= squared_radius; ++y) {
      if (x * x + y * y == squared_radius) points.push_back({double(x), double(y)});
    }
  }
  return points;
}

Points scattered_exponents(std::size_t n, int low, int high, Prng& prng) {
  const auto draw = [&] {
    const int exponent = low + int(prng.below(std::uint64_t(high - low + 1)));
    return std::ldexp(prng.between(0.5, 1), exponent) * (prng.chance(0.5) ? 1 : -1);
  };
  Points points(n);
  for (Point2& p : points) {
    p.x = draw();
    p.y = draw();
  }
  return points;
}

Points times(Points points, double factor) {
  for (Point2& p : points) p = {p.x * factor, p.y * factor};
  return points;
}

Graph polygon(Points points) {
  Graph graph;
  graph.points = std::move(points);
  const std::size_t n = graph.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    graph.segments.push_back({PlaneVertexId(i), PlaneVertexId((i + 1) % n)});
  }
  return graph;
}

Graph star_polygon(std::size_t n, double low, Prng& prng) {
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * double(i) / double(n);
    const double radius = prng.between(low, 1);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(std::move(points));
}

Graph skyline(int n, int height, Prng& prng) {
  Points points;
  for (int x = n; x >= 0; --x) {
    points.push_back({double(x), double(prng.below(std::uint64_t(height)))});
  }
  points.push_back({0, -1});
  points.push_back({double(n), -1});
  return polygon(std::move(points));
}

Graph fan(std::size_t n, double sector, Prng& prng) {
  Graph graph;
  graph.points.push_back({0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = sector * double(i) / double(n);
    const double length = prng.between(0.1, 1);
    graph.points.push_back({length * std::cos(angle), length * std::sin(angle)});
    graph.segments.push_back({PlaneVertexId(0), PlaneVertexId(i + 1)});
  }
  return graph;
}

Graph operator+(Graph a, const Graph& b) {
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Segment& s : b.segments) {
    a.segments.push_back({PlaneVertexId(s[0].index() + n), PlaneVertexId(s[1].index() + n)});
  }
  return a;
}

Graph shuffled(const Graph& graph, Prng& prng, std::vector<std::size_t>* renamed) {
  std::vector<std::size_t> from(graph.points.size());
  std::iota(from.begin(), from.end(), std::size_t{0});
  prng.shuffle(from);
  Graph result;
  std::vector<std::size_t> name(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    result.points.push_back(graph.points[from[i]]);
    name[from[i]] = i;
  }
  for (const Segment& s : graph.segments) {
    Segment moved{PlaneVertexId(name[s[0].index()]), PlaneVertexId(name[s[1].index()])};
    if (prng.chance(0.5)) std::swap(moved[0], moved[1]);
    result.segments.push_back(moved);
  }
  prng.shuffle(result.segments);
  if (renamed != nullptr) *renamed = name;
  return result;
}

Points sorted(Points points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  return points;
}

}  // namespace tetloft::test
