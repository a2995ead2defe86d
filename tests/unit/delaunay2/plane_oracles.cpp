#include "plane_oracles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <tetloft/predicates.hpp>

#include "support/exact/predicates.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::test {

namespace {

using oracle::Rational;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

using Edge = std::pair<std::size_t, std::size_t>;

Edge undirected(PlaneVertexId a, PlaneVertexId b) { return std::minmax({a.index(), b.index()}); }

/// Each point's index, or for a repeated point the lowest index of its like.
std::vector<std::size_t> firsts(std::span<const Point2> points) {
  std::map<std::pair<double, double>, std::size_t> seen;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    first.push_back(seen.emplace(std::pair{points[i].x + 0.0, points[i].y + 0.0}, i).first->second);
  }
  return first;
}

double ulp(double value) {
  const double magnitude = std::abs(value);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

/// |cross product| ≤ (tolerance in x) |dy| + (tolerance in y) |dx|: some point that close
/// along both axes lies on the line.
bool is_near_line(const Point2& a, const Point2& c, const Point2& b, double ulps) {
  const auto x = [](const Point2& p) { return Rational::exactly(p.x); };
  const auto y = [](const Point2& p) { return Rational::exactly(p.y); };
  const Rational dx = x(b) - x(a);
  const Rational dy = y(b) - y(a);
  const Rational cross = dx * (y(c) - y(a)) - dy * (x(c) - x(a));
  const Rational off_x = Rational::exactly(ulps * ulp(std::max(std::abs(a.x), std::abs(b.x))));
  const Rational off_y = Rational::exactly(ulps * ulp(std::max(std::abs(a.y), std::abs(b.y))));
  return cross.abs() <= off_x * dy.abs() + off_y * dx.abs();
}

}  // namespace

Triangulation2 triangulate(std::span<const Point2> points) {
  Result<Triangulation2> result = delaunay2(points);
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result).value();
}

Conforming2 conform(const Graph& graph, const ConformingOptions& options) {
  Result<Conforming2> result = conforming_delaunay2(graph.points, graph.segments, options);
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result).value();
}

ConformingOptions all_gabriel(const Graph& graph) {
  ConformingOptions options;
  options.gabriel.assign(graph.segments.size(), true);
  return options;
}

std::vector<PlaneTriangleVertices> brute_force_triangles(std::span<const Point2> points) {
  const std::vector<std::size_t> first = firsts(points);
  std::vector<std::size_t> use;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (first[i] == i) use.push_back(i);
  }
  std::vector<PlaneTriangleVertices> triangles;
  for (std::size_t i = 0; i < use.size(); ++i) {
    for (std::size_t j = i + 1; j < use.size(); ++j) {
      for (std::size_t k = j + 1; k < use.size(); ++k) {
        std::size_t b = use[j];
        std::size_t c = use[k];
        const int turn = oracle::orient2d(points[use[i]], points[b], points[c]);
        if (turn == 0) continue;
        if (turn < 0) std::swap(b, c);
        const bool empty = std::none_of(use.begin(), use.end(), [&](std::size_t d) {
          return d != use[i] && d != b && d != c &&
                 oracle::incircle_perturbed(points[use[i]], points[b], points[c], points[d]) > 0;
        });
        if (empty) triangles.push_back({PlaneVertexId(use[i]), PlaneVertexId(b), PlaneVertexId(c)});
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

AssertionResult is_canonical(const Triangulation2& t) {
  const std::vector<Point2>& points = t.points.raw();
  if (t.neighbours.size() != t.triangles.size()) return AssertionFailure() << "array sizes";
  if (!std::is_sorted(t.triangles.begin(), t.triangles.end())) {
    return AssertionFailure() << "triangles are not sorted";
  }
  std::map<Edge, std::size_t> directed;  // → 3 triangle + opposite corner
  std::vector<bool> used(points.size(), false);
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    const PlaneTriangleVertices& v = t.triangles[TriangleId(i)];
    if (std::min({v[0], v[1], v[2]}) != v[0]) return AssertionFailure() << "rotation of " << i;
    if (oracle::orient2d(t.points[v[0]], t.points[v[1]], t.points[v[2]]) <= 0) {
      return AssertionFailure() << "triangle " << i << " is not counter-clockwise";
    }
    for (std::size_t k = 0; k < 3; ++k) {
      used[v[k].index()] = true;
      const Edge edge{v[(k + 1) % 3].index(), v[(k + 2) % 3].index()};
      if (!directed.emplace(edge, 3 * i + k).second) return AssertionFailure() << "edge twice";
    }
  }
  std::map<std::size_t, std::size_t> hull;  // successor, counter-clockwise
  for (const auto& [edge, corner] : directed) {
    const auto twin = directed.find({edge.second, edge.first});
    const TriangleId expected =
        twin == directed.end() ? TriangleId() : TriangleId(twin->second / 3);
    if (t.neighbours[TriangleId(corner / 3)][corner % 3] != expected) {
      return AssertionFailure() << "neighbour of " << corner / 3;
    }
    if (twin == directed.end() && !hull.emplace(edge).second) {
      return AssertionFailure() << "hull passes a vertex twice";
    }
  }
  const std::vector<std::size_t> first = firsts(points);
  std::size_t distinct = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (first[v] == v) ++distinct;
    if (!t.triangles.empty() && used[v] != (first[v] == v)) {
      return AssertionFailure() << "use of vertex " << v;
    }
  }
  if (t.triangles.empty()) return AssertionSuccess();
  std::size_t steps = 0;
  int rises = 0;  // a convex closed curve turns left and goes around once
  std::size_t v = hull.begin()->first;
  do {
    const auto at = hull.find(v);
    if (at == hull.end() || hull.count(at->second) == 0) return AssertionFailure() << "hull open";
    const std::size_t w = at->second;
    const std::size_t x = hull.at(w);
    if (oracle::orient2d(points[v], points[w], points[x]) < 0) {
      return AssertionFailure() << "hull is not convex at " << w;
    }
    if (canonical_less(points[w], points[v]) && canonical_less(points[w], points[x])) ++rises;
    v = w;
    ++steps;
  } while (v != hull.begin()->first && steps <= hull.size());
  if (steps != hull.size() || rises != 1) return AssertionFailure() << "hull is not one curve";
  if (t.triangles.size() != 2 * distinct - 2 - hull.size()) {
    return AssertionFailure() << "Euler: " << t.triangles.size() << " triangles, " << distinct
                              << " vertices, hull of " << hull.size();
  }
  return AssertionSuccess();
}

AssertionResult is_locally_delaunay(const Triangulation2& t, Trust predicates) {
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    for (const TriangleId other : t.neighbours[TriangleId(i)]) {
      if (!other.valid() || other.index() < i) continue;
      const PlaneTriangleVertices& a = t.triangles[TriangleId(i)];
      for (const PlaneVertexId v : t.triangles[other]) {
        if (std::find(a.begin(), a.end(), v) != a.end()) continue;
        const Point2 p[] = {t.points[a[0]], t.points[a[1]], t.points[a[2]], t.points[v]};
        const int sign = predicates == Trust::definition
                             ? oracle::incircle_perturbed(p[0], p[1], p[2], p[3])
                             : static_cast<int>(incircle_perturbed(p[0], p[1], p[2], p[3]));
        if (sign >= 0) {
          return AssertionFailure() << "vertex " << v.value() << " in circle of triangle " << i;
        }
      }
    }
  }
  return AssertionSuccess();
}

AssertionResult respects(const Conforming2& c, const Graph& graph) {
  const Triangulation2& t = c.triangulation;
  const std::size_t n = graph.points.size();
  if (t.points.size() != n + c.split.size()) return AssertionFailure() << "number of points";
  if (!std::equal(graph.points.begin(), graph.points.end(), t.points.begin())) {
    return AssertionFailure() << "input points moved";
  }
  if (c.chains.size() != graph.segments.size()) return AssertionFailure() << "number of chains";
  std::set<Edge> edges;
  for (const PlaneTriangleVertices& v : t.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(undirected(v[k], v[(k + 1) % 3]));
  }
  std::size_t described = 0;
  for (std::size_t s = 0; s < c.chains.size(); ++s) {
    const std::vector<PlaneVertexId>& chain = c.chains[s];
    const Segment& segment = graph.segments[s];
    if (chain.size() < 2 || chain.front() != segment[0] || chain.back() != segment[1]) {
      return AssertionFailure() << "ends of chain " << s;
    }
    const Point2& a = t.points[segment[0]];
    const Point2& b = t.points[segment[1]];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (edges.count(undirected(chain[i], chain[i + 1])) == 0) {
        return AssertionFailure() << "chain " << s << " leaves the edges at " << i;
      }
      const Point2& p = t.points[chain[i]];
      const Point2& q = t.points[chain[i + 1]];
      const bool forward_x = a.x == b.x ? p.x == q.x : (p.x == q.x || (p.x < q.x) == (a.x < b.x));
      const bool forward_y = a.y == b.y ? p.y == q.y : (p.y == q.y || (p.y < q.y) == (a.y < b.y));
      if (!forward_x || !forward_y || p == q) {
        return AssertionFailure() << "chain " << s << " turns back at " << i;
      }
      if (i == 0) continue;
      ++described;
      if (chain[i].index() < n) return AssertionFailure() << "chain " << s << " meets the input";
      const SplitVertex& split = c.split[chain[i].index() - n];
      if (split.segment != s || split.position != i - 1) {
        return AssertionFailure() << "description of vertex " << chain[i].value();
      }
      if (!is_near_line(a, p, b, 4)) return AssertionFailure() << "chain " << s << " strays";
    }
  }
  if (described != c.split.size()) return AssertionFailure() << "inserted points in no chain";
  return AssertionSuccess();
}

AssertionResult is_gabriel(const Conforming2& c, const Graph& graph) {
  const Points& points = c.triangulation.points.raw();
  // Coordinates as integers of a common unit: exact, and quicker than fractions.
  int unit = 1023;
  for (const Point2& p : points) {
    unit = std::min({unit, oracle::BigInt::exponent_of(p.x), oracle::BigInt::exponent_of(p.y)});
  }
  struct BigPoint {
    oracle::BigInt x, y;
  };
  std::vector<BigPoint> big;
  for (const Point2& p : points) {
    big.push_back({oracle::BigInt::from_scaled(p.x, unit), oracle::BigInt::from_scaled(p.y, unit)});
  }
  for (std::size_t s = 0; s < graph.segments.size(); ++s) {
    for (std::size_t i = 0; i + 1 < c.chains[s].size(); ++i) {
      const BigPoint& a = big[c.chains[s][i].index()];
      const BigPoint& b = big[c.chains[s][i + 1].index()];
      for (std::size_t v = 0; v < big.size(); ++v) {
        if (v == c.chains[s][i].index() || v == c.chains[s][i + 1].index()) continue;
        const oracle::BigInt dot =
            (a.x - big[v].x) * (b.x - big[v].x) + (a.y - big[v].y) * (b.y - big[v].y);
        if (dot.sign() <= 0) {
          return AssertionFailure() << "vertex " << v << " encroaches upon segment " << s;
        }
      }
    }
  }
  return AssertionSuccess();
}

Points inserted(const Conforming2& c, const Graph& graph) {
  const Points& all = c.triangulation.points.raw();
  return sorted(Points(all.begin() + static_cast<std::ptrdiff_t>(graph.points.size()), all.end()));
}

}  // namespace tetloft::test
