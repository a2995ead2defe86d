// What a triangulation of the plane has to be, by the public predicates alone.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/target.hpp"

namespace tetloft::fuzz {

using Edge = std::array<DelaunayVertex, 2>;
/// The edges that constraints go over, and which.
using WallsOf = std::map<Edge, std::vector<ConstraintId>>;

inline Edge edge_of(DelaunayVertex u, DelaunayVertex v) { return {std::min(u, v), std::max(u, v)}; }

inline bool are_apart(Sign a, Sign b) { return a != Sign::zero && a == -b; }

/// Do a b and c d cross inside of both?
inline bool cross_inside(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return are_apart(orient2d(a, b, c), orient2d(a, b, d)) &&
         are_apart(orient2d(c, d, a), orient2d(c, d, b));
}

/// Does p lie on a b, and is no end of it?
inline bool is_between(const Point2& p, const Point2& a, const Point2& b) {
  return p != a && p != b && orient2d(a, b, p) == Sign::zero &&
         canonical_less(a, p) == canonical_less(p, b);
}

/// A point inside of a triangle that is wide enough to have its rounded centre of gravity there.
inline bool has_centre(const std::array<Point2, 3>& t, Point2& centre) {
  centre = {t[0].x / 3 + t[1].x / 3 + t[2].x / 3, t[0].y / 3 + t[1].y / 3 + t[2].y / 3};
  for (std::size_t i = 0; i < 3; ++i) {
    if (orient2d(t[i], t[(i + 1) % 3], centre) != Sign::positive) return false;
  }
  return true;
}

class PlaneOracle {
 public:
  explicit PlaneOracle(const DelaunayTriangulation2& t) : t_(t) {
    for (const DelaunayVertex v : t.vertices()) live_.push_back(v);
    for (const ConstraintId c : t.constraints()) {
      for (const Edge& e : t.edges(c)) walls_[e].push_back(c);
    }
  }
  [[nodiscard]] bool is_held(DelaunayVertex v) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const WallsOf::value_type& wall) {
      return wall.first[0] == v || wall.first[1] == v;
    });
  }
  [[nodiscard]] bool crosses_a_wall(const Point2& a, const Point2& b) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const WallsOf::value_type& wall) {
      return cross_inside(a, b, t_.point(wall.first[0]), t_.point(wall.first[1]));
    });
  }

  /// Edges, hull, neighbours and counts fit each other, and circles are empty as far as is seen.
  void require_all() const {
    require_walls();
    if (t_.dimension() < 2) return require_row();
    require_mesh();
    require_hull();
    require_empty_circles();
    if (walls_.empty()) return require_batch();
    if (live_.size() <= kFew) require_nothing_is_seen();
  }
  /// The edges that a straight constraint goes over.
  [[nodiscard]] std::vector<Edge> edges_on(DelaunayVertex u, DelaunayVertex v) const {
    std::vector<DelaunayVertex> row{u, v};
    for (const DelaunayVertex w : live_) {
      if (is_between(t_.point(w), t_.point(u), t_.point(v))) row.push_back(w);
    }
    return joined(std::move(row));
  }
  /// By odd crossing of a ray, where triangles are wide enough to have a point to start it at. No
  /// two constraints may lie over each other but where `walls` says so.
  void require_inside(const std::vector<TriangleId>& inside) const {
    for (const TriangleId t : t_.triangles()) {
      Point2 p;
      if (!has_centre(corners(t), p)) continue;
      bool is_inside = false;
      for (const auto& [edge, over] : walls_) {
        Point2 low = t_.point(edge[0]), high = t_.point(edge[1]);
        if (high.y < low.y) std::swap(low, high);
        const bool crosses =
            low.y <= p.y && p.y < high.y && orient2d(low, high, p) == Sign::positive;
        if (crosses && over.size() % 2 != 0) is_inside = !is_inside;
      }
      require(std::binary_search(inside.begin(), inside.end(), t) == is_inside,
              "a triangle is inside, or is not");
    }
  }
  [[nodiscard]] bool has_loose_end() const {
    std::map<DelaunayVertex, std::size_t> degree;
    for (const auto& [edge, over] : walls_) {
      for (const DelaunayVertex v : edge) degree[v] += over.size();
    }
    return std::any_of(degree.begin(), degree.end(),
                       [](const auto& entry) { return entry.second % 2 != 0; });
  }

 private:
  static constexpr std::size_t kFew = 12;

  [[nodiscard]] std::array<Point2, 3> corners(TriangleId t) const {
    const auto v = t_.vertices(t);
    return {t_.point(v[0]), t_.point(v[1]), t_.point(v[2])};
  }
  [[nodiscard]] std::vector<Edge> joined(std::vector<DelaunayVertex> row) const {
    std::sort(row.begin(), row.end(), [&](DelaunayVertex a, DelaunayVertex b) {
      return canonical_less(t_.point(a), t_.point(b));
    });
    std::vector<Edge> edges;
    for (std::size_t i = 1; i < row.size(); ++i) edges.push_back(edge_of(row[i - 1], row[i]));
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  void require_walls() const {
    const std::vector<Edge> edges = t_.edges();
    for (const auto& [edge, over] : walls_) {
      require(std::binary_search(edges.begin(), edges.end(), edge), "a wall is no edge");
      require(t_.constraints(edge[1], edge[0]) == over, "an edge has other constraints");
    }
  }
  void require_row() const {
    require(t_.dimension() == std::min(static_cast<int>(live_.size()), 2) - 1, "dimension");
    for (const DelaunayVertex u : live_) {
      for (const DelaunayVertex v : live_) {
        require(orient2d(t_.point(live_[0]), t_.point(u), t_.point(v)) == Sign::zero,
                "points in no row");
      }
    }
    require(t_.edges() == joined(live_), "other edges of a row");
    require(t_.triangle_count() == 0 && t_.triangle_slots() == 0, "triangles of a row");
  }

  // Each triangle knows its neighbours and is counter-clockwise; the Euler count.
  void require_mesh() const {
    std::size_t triangles = 0;
    std::set<Edge> edges;
    for (const TriangleId t : t_.triangles()) {
      ++triangles;
      const auto p = corners(t);
      require(orient2d(p[0], p[1], p[2]) == Sign::positive, "a triangle is clockwise or flat");
      const auto v = t_.vertices(t);
      const auto across = t_.neighbours(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const DelaunayVertex from = v[(i + 1) % 3], to = v[(i + 2) % 3];
        edges.insert(edge_of(from, to));
        if (!across[i].valid()) continue;
        const std::size_t k = beyond(across[i], from, to);
        require(t_.neighbours(across[i])[k] == t, "a neighbour does not know it");
      }
    }
    const std::vector<Edge> all = t_.edges();
    require(std::equal(all.begin(), all.end(), edges.begin(), edges.end()), "other edges");
    const std::size_t hull = t_.hull().size();
    require(triangles == t_.triangle_count() && triangles + hull + 2 == 2 * live_.size() &&
                edges.size() + hull + 3 == 3 * live_.size(),
            "counts of triangles and edges");
  }
  // Which vertex of `t` lies beyond the edge that its neighbour has from `from` to `to`.
  [[nodiscard]] std::size_t beyond(TriangleId t, DelaunayVertex from, DelaunayVertex to) const {
    const auto v = t_.vertices(t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[(k + 1) % 3] == to && v[(k + 2) % 3] == from) return k;
    }
    require(false, "neighbours do not share their edge");
    return 0;
  }
  void require_hull() const {
    const std::vector<DelaunayVertex> hull = t_.hull();
    const std::set<DelaunayVertex> on_hull(hull.begin(), hull.end());
    require(on_hull.size() == hull.size(), "the hull passes twice");
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point2 a = t_.point(hull[i]), b = t_.point(hull[(i + 1) % hull.size()]);
      for (const DelaunayVertex v : live_) {
        const Sign s = orient2d(a, b, t_.point(v));
        require(s == Sign::positive || (s == Sign::zero && on_hull.contains(v)),
                "a vertex beyond the hull, or missing in it");
      }
    }
    for (const DelaunayVertex v : live_) {
      require(t_.is_on_hull(v) == on_hull.contains(v), "a vertex is on the hull, or is not");
    }
  }
  // Across all edges but walls: by Lee and Lin (1986) that is the constrained triangulation.
  void require_empty_circles() const {
    for (const TriangleId t : t_.triangles()) {
      const auto p = corners(t);
      const auto v = t_.vertices(t);
      const auto across = t_.neighbours(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const DelaunayVertex from = v[(i + 1) % 3], to = v[(i + 2) % 3];
        if (!across[i].valid() || walls_.contains(edge_of(from, to))) continue;
        const DelaunayVertex w = t_.vertices(across[i])[beyond(across[i], from, to)];
        require(incircle_perturbed(p[0], p[1], p[2], t_.point(w)) == Sign::negative,
                "an edge that is not locally Delaunay");
      }
    }
  }
  void require_batch() const {
    std::vector<Point2> points;
    for (const DelaunayVertex v : live_) points.push_back(t_.point(v));
    const Result<Triangulation2> batch = delaunay2(points);
    require(batch.ok(), "the batch refuses its points");
    std::set<std::array<DelaunayVertex, 3>> expected, found;
    const auto add = [](std::set<std::array<DelaunayVertex, 3>>& to,
                        std::array<DelaunayVertex, 3> t) {
      std::sort(t.begin(), t.end());
      to.insert(t);
    };
    for (const PlaneTriangleVertices& t : batch->triangles) {
      add(expected, {live_[t[0].index()], live_[t[1].index()], live_[t[2].index()]});
    }
    for (const TriangleId t : t_.triangles()) add(found, t_.vertices(t));
    require(found == expected, "other triangles than the batch");
  }
  // The definition: from a point inside of a triangle no vertex in its circle is seen.
  void require_nothing_is_seen() const {
    for (const TriangleId t : t_.triangles()) {
      const auto p = corners(t);
      Point2 from;
      if (!has_centre(p, from)) continue;
      for (const DelaunayVertex v : live_) {
        const Point2 to = t_.point(v);
        if (incircle_perturbed(p[0], p[1], p[2], to) != Sign::positive) continue;
        const bool hidden =
            std::any_of(walls_.begin(), walls_.end(), [&](const WallsOf::value_type& wall) {
              const Point2 a = t_.point(wall.first[0]), b = t_.point(wall.first[1]);
              return cross_inside(from, to, a, b) || is_between(a, from, to) ||
                     is_between(b, from, to);
            });
        require(hidden, "a vertex in the circle of a triangle is seen from inside");
      }
    }
  }

  const DelaunayTriangulation2& t_;
  std::vector<DelaunayVertex> live_;
  WallsOf walls_;
};

}  // namespace tetloft::fuzz
