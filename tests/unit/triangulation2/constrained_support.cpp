#include "constrained_support.hpp"

#include <algorithm>

#include <tetloft/predicates.hpp>

namespace tetloft::test {
namespace {

bool is_inside_segment(const Point2& p, const Point2& a, const Point2& b) {
  return p != a && p != b && orient2d(a, b, p) == Sign::zero &&
         canonical_less(a, p) == canonical_less(p, b);
}

}  // namespace

bool cross_properly(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto apart = [](Sign s, Sign t) { return s != Sign::zero && s == -t; };
  return apart(orient2d(a, b, c), orient2d(a, b, d)) && apart(orient2d(c, d, a), orient2d(c, d, b));
}

std::set<Edge> constrained_edges(const DelaunayTriangulation2& t) {
  std::set<Edge> result;
  for (const ConstraintId c : t.constraints()) {
    for (const Edge& e : t.edges(c)) result.insert(e);
  }
  return result;
}

testing::AssertionResult covers_its_segment(const DelaunayTriangulation2& t, ConstraintId c) {
  const auto [u, v] = t.ends(c);
  std::vector<DelaunayVertex> row{u, v};
  for (const DelaunayVertex w : t.vertices()) {
    if (is_inside_segment(t.point(w), t.point(u), t.point(v))) row.push_back(w);
  }
  std::sort(row.begin(), row.end(), [&](DelaunayVertex a, DelaunayVertex b) {
    return canonical_less(t.point(a), t.point(b));
  });
  std::vector<Edge> expected;
  for (std::size_t i = 1; i < row.size(); ++i) {
    expected.push_back({std::min(row[i - 1], row[i]), std::max(row[i - 1], row[i])});
  }
  std::sort(expected.begin(), expected.end());
  if (t.edges(c) != expected) return testing::AssertionFailure() << "edges of a constraint";
  for (const Edge& e : expected) {
    const std::vector<ConstraintId> over = t.constraints(e[1], e[0]);
    if (!std::binary_search(over.begin(), over.end(), c)) {
      return testing::AssertionFailure() << "an edge does not know its constraint";
    }
  }
  return testing::AssertionSuccess();
}

std::set<std::array<DelaunayVertex, 3>> triangles_by_vertices(const DelaunayTriangulation2& t) {
  std::set<std::array<DelaunayVertex, 3>> result;
  for (const TriangleId triangle : t.triangles()) {
    auto v = t.vertices(triangle);
    std::sort(v.begin(), v.end());
    result.insert(v);
  }
  return result;
}

testing::AssertionResult are_same_constrained(const DelaunayTriangulation2& a,
                                              const DelaunayTriangulation2& b) {
  if (live_vertices(a) != live_vertices(b) || a.vertex_slots() != b.vertex_slots() ||
      a.vertex_count() != b.vertex_count()) {
    return testing::AssertionFailure() << "vertices";
  }
  for (const DelaunayVertex v : a.vertices()) {
    if (a.point(v) != b.point(v)) return testing::AssertionFailure() << "a point";
  }
  if (a.dimension() != b.dimension() || a.edges() != b.edges() ||
      triangles_by_vertices(a) != triangles_by_vertices(b)) {
    return testing::AssertionFailure() << "triangles";
  }
  if (a.constraints() != b.constraints() || a.constraint_count() != b.constraint_count()) {
    return testing::AssertionFailure() << "constraints";
  }
  for (const ConstraintId c : a.constraints()) {
    if (a.ends(c) != b.ends(c) || a.edges(c) != b.edges(c)) {
      return testing::AssertionFailure() << "a constraint";
    }
  }
  return testing::AssertionSuccess();
}

DelaunayTriangulation2 constrained_at_random(const PlaneSource& source, Prng& prng) {
  DelaunayTriangulation2 t;
  for (int step = 0; step < 60; ++step) {
    const std::vector<DelaunayVertex> live = live_vertices(t);
    const auto draw = [&] { return live[prng.below(live.size())]; };
    const std::vector<ConstraintId> constraints = t.constraints();
    if (live.size() < 6 || prng.chance(0.55)) {
      (void)value_of(t.insert(source.draw(prng)));
    } else if (prng.chance(0.2)) {
      (void)t.remove(draw());  // refused where a constraint holds it
    } else if (!constraints.empty() && prng.chance(0.2)) {
      succeed(t.remove_constraint(constraints[prng.below(constraints.size())]));
    } else {
      (void)t.insert_constraint(draw(), draw(),
                                prng.chance(0.5) ? Crossing::split : Crossing::refuse);
    }
  }
  return t;
}

namespace {

// Of points whose coordinates are multiples of three, few: no vertex in a triangle's perturbed
// circle is seen from its centre of gravity.
testing::AssertionResult sees_no_vertex_in_circles(const DelaunayTriangulation2& t,
                                                   const std::set<Edge>& walls) {
  for (const TriangleId triangle : t.triangles()) {
    const auto v = t.vertices(triangle);
    const Point2 a = t.point(v[0]), b = t.point(v[1]), c = t.point(v[2]);
    const Point2 centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    for (const DelaunayVertex w : t.vertices()) {
      const Point2 p = t.point(w);
      if (incircle_perturbed(a, b, c, p) != Sign::positive) continue;
      const bool hidden = std::any_of(walls.begin(), walls.end(), [&](const Edge& e) {
        const Point2 from = t.point(e[0]), to = t.point(e[1]);
        return cross_properly(centre, p, from, to) || is_inside_segment(from, centre, p) ||
               is_inside_segment(to, centre, p);
      });
      if (!hidden) return testing::AssertionFailure() << "a vertex in a circle is seen";
    }
  }
  return testing::AssertionSuccess();
}

}  // namespace

testing::AssertionResult is_constrained_delaunay(const DelaunayTriangulation2& t,
                                                 bool multiples_of_three) {
  const std::set<Edge> walls = constrained_edges(t);
  const std::vector<Edge> edges = t.edges();
  for (const Edge& e : walls) {
    if (!std::binary_search(edges.begin(), edges.end(), e)) {
      return testing::AssertionFailure() << "a constrained edge is missing";
    }
  }
  if (t.dimension() < 2) return testing::AssertionSuccess();
  double area = 0;
  const auto cross = [](const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; };
  for (const TriangleId triangle : t.triangles()) {
    const auto v = t.vertices(triangle);
    const Point2 a = t.point(v[0]), b = t.point(v[1]), c = t.point(v[2]);
    if (orient2d(a, b, c) != Sign::positive) return testing::AssertionFailure() << "a flat one";
    area += cross(a, b) + cross(b, c) + cross(c, a);
    const auto across = t.neighbours(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!across[i].valid()) continue;
      const DelaunayVertex from = v[(i + 1) % 3], to = v[(i + 2) % 3];
      const auto w = t.vertices(across[i]);
      const auto at = static_cast<std::size_t>(std::find(w.begin(), w.end(), to) - w.begin());
      if (at == 3 || w[(at + 1) % 3] != from) return testing::AssertionFailure() << "neighbours";
      if (walls.contains({std::min(from, to), std::max(from, to)})) continue;
      if (incircle_perturbed(a, b, c, t.point(w[(at + 2) % 3])) != Sign::negative) {
        return testing::AssertionFailure() << "an edge that is not locally Delaunay";
      }
    }
  }
  if (!multiples_of_three) return testing::AssertionSuccess();
  const std::vector<DelaunayVertex> hull = t.hull();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    area -= cross(t.point(hull[i]), t.point(hull[(i + 1) % hull.size()]));
  }
  if (area != 0) return testing::AssertionFailure() << "areas";
  return sees_no_vertex_in_circles(t, walls);
}

}  // namespace tetloft::test
