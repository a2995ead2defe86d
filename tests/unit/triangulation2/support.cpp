#include "support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <tetloft/predicates.hpp>

namespace tetloft::test {
namespace {

using Triple = std::array<std::uint32_t, 3>;

double grid(Prng& prng, std::uint64_t side) { return static_cast<double>(prng.below(side)); }

Point2 on_integer_circle(Prng& prng) {
  // All of squared length 4225.
  constexpr std::array<std::array<double, 2>, 5> kinds{
      {{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}}};
  std::array<double, 2> v = kinds[prng.below(kinds.size())];
  prng.shuffle(v);
  for (double& x : v) x = prng.chance(0.5) ? -x : x;
  return {v[0], v[1]};
}

// The lowest first, as it turns.
Triple rotated(Triple t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

testing::AssertionResult equals_row(const DelaunayTriangulation2& t,
                                    std::vector<DelaunayVertex> row) {
  std::sort(row.begin(), row.end(), [&](DelaunayVertex a, DelaunayVertex b) {
    return canonical_less(t.point(a), t.point(b));
  });
  std::vector<std::array<DelaunayVertex, 2>> edges;
  for (std::size_t i = 1; i < row.size(); ++i) {
    edges.push_back({std::min(row[i - 1], row[i]), std::max(row[i - 1], row[i])});
  }
  std::sort(edges.begin(), edges.end());
  if (t.edges() != edges) return testing::AssertionFailure() << "edges of a row";
  if (t.hull() != row) return testing::AssertionFailure() << "ends of a row";
  if (t.triangle_count() != 0 || t.triangle_slots() != 0) {
    return testing::AssertionFailure() << "triangles of a row";
  }
  return testing::AssertionSuccess();
}

int dimension_of(const std::vector<Point2>& points) {
  for (const Point2& p : points) {
    for (const Point2& q : points) {
      if (q == p || q == points[0] || p == points[0]) continue;
      if (orient2d(points[0], p, q) != Sign::zero) return 2;
    }
  }
  return static_cast<int>(std::min<std::size_t>(points.size(), 2)) - 1;
}

// Every edge of the hull has all points on its left side or on it, between whose ends none lies.
testing::AssertionResult is_hull(const DelaunayTriangulation2& t,
                                 const std::vector<DelaunayVertex>& live) {
  const std::vector<DelaunayVertex> hull = t.hull();
  const std::set<DelaunayVertex> on_hull(hull.begin(), hull.end());
  if (on_hull.size() != hull.size()) return testing::AssertionFailure() << "hull passes twice";
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2& a = t.point(hull[i]);
    const Point2& b = t.point(hull[(i + 1) % hull.size()]);
    for (const DelaunayVertex v : live) {
      const Sign s = orient2d(a, b, t.point(v));
      if (s == Sign::negative) return testing::AssertionFailure() << "a point beyond the hull";
      if (s == Sign::zero && !on_hull.contains(v)) {
        return testing::AssertionFailure() << "a point that is missing in the hull";
      }
    }
  }
  for (const DelaunayVertex v : live) {
    if (t.is_on_hull(v) != on_hull.contains(v)) return testing::AssertionFailure() << "is_on_hull";
  }
  return testing::AssertionSuccess();
}

}  // namespace

std::vector<PlaneSource> plane_sources() {
  return {
      {"square",
       [](Prng& r) {
         return Point2{r.unit(), r.unit()};
       }},
      {"lattice",
       [](Prng& r) {
         return Point2{grid(r, 6), grid(r, 5)};
       }},
      {"small lattice",
       [](Prng& r) {
         return Point2{grid(r, 3), grid(r, 3)};
       }},
      {"circle", on_integer_circle},
      {"line",
       [](Prng& r) {
         const double x = grid(r, 12);
         return Point2{x, 1 - 2 * x};
       }},
      {"line and a few",
       [](Prng& r) {
         return Point2{grid(r, 8), r.chance(0.15) ? 1.0 + grid(r, 2) : 0};
       }},
      {"two lines",
       [](Prng& r) {
         return Point2{grid(r, 8), 3 * grid(r, 2)};
       }},
      {"one ulp apart",
       [](Prng& r) {
         const double u = 0x1p-52;
         return Point2{1 + u * grid(r, 5), 1 + u * grid(r, 5)};
       }},
      {"beside a line by an ulp",
       [](Prng& r) {
         const double x = 1 + grid(r, 16) / 16;
         return Point2{x, std::nextafter(x / 3, r.chance(0.5) ? 0.0 : 9.0)};
       }},
      {"clusters of many scales",
       [](Prng& r) {
         const double s = std::ldexp(1.0, -static_cast<int>(r.below(30)) * 8);
         return Point2{s * grid(r, 4), s * grid(r, 4)};
       }},
      {"few places",
       [](Prng& r) {
         return Point2{grid(r, 2), grid(r, 2)};
       }},
  };
}

testing::AssertionResult equals_batch(const DelaunayTriangulation2& t) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  if (live.size() != t.vertex_count()) return testing::AssertionFailure() << "count of vertices";
  std::vector<Point2> points;
  for (const DelaunayVertex v : live) points.push_back(t.point(v));
  if (t.dimension() != dimension_of(points)) return testing::AssertionFailure() << "dimension";
  if (t.dimension() < 2) return equals_row(t, live);

  const Triangulation2 batch = value_of(delaunay2(points));
  std::set<Triple> expected;
  for (const PlaneTriangleVertices& v : batch.triangles) {
    expected.insert(
        rotated({live[v[0].index()].index, live[v[1].index()].index, live[v[2].index()].index}));
  }
  std::set<Triple> found;
  std::map<DelaunayVertex, std::size_t> degree;
  std::set<std::array<DelaunayVertex, 2>> edges;
  for (const TriangleId triangle : t.triangles()) {
    const std::array<DelaunayVertex, 3> v = t.vertices(triangle);
    found.insert(rotated({v[0].index, v[1].index, v[2].index}));
    const std::array<TriangleId, 3> across = t.neighbours(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      ++degree[v[i]];
      const DelaunayVertex from = v[(i + 1) % 3], to = v[(i + 2) % 3];
      edges.insert({std::min(from, to), std::max(from, to)});
      if (!across[i].valid()) continue;
      const std::array<DelaunayVertex, 3> w = t.vertices(across[i]);
      const auto at = static_cast<std::size_t>(std::find(w.begin(), w.end(), to) - w.begin());
      if (at == 3 || w[(at + 1) % 3] != from || t.neighbours(across[i])[(at + 2) % 3] != triangle) {
        return testing::AssertionFailure() << "neighbours that do not fit";
      }
    }
  }
  if (found != expected) {
    return testing::AssertionFailure() << found.size() << " triangles for " << expected.size();
  }
  if (found.size() != t.triangle_count()) {
    return testing::AssertionFailure() << "count of triangles";
  }
  const auto all_edges = t.edges();
  if (!std::equal(all_edges.begin(), all_edges.end(), edges.begin(), edges.end())) {
    return testing::AssertionFailure() << "edges";
  }
  for (const DelaunayVertex v : live) {
    if (t.star(v).size() != degree[v]) return testing::AssertionFailure() << "a star";
  }
  return is_hull(t, live);
}

}  // namespace tetloft::test
