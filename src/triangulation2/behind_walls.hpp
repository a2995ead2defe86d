// The vertices of a plane with walls by their distance from a point, compared exactly.
//
// With walls the nearest vertex may have no edge to one that is nearly as near, so the search goes
// from triangle to triangle. The segment from the point to a vertex meets triangles one behind the
// other, each beyond an edge that it meets too (where it passes a vertex, around that). An edge is
// as far as the nearest point of its box, which is exact; the vertex is no nearer along any axis
// than where the segment meets the edge, so no nearer than that. Of vertices not found yet each is
// beyond an edge in the queue, hence behind it in order, and what comes first is next.
#pragma once

#include <algorithm>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

#include "core/id_set.hpp"
#include "predicates/distances.hpp"
#include "triangulation2/live_plane.hpp"

namespace tetloft::internal::triangulation2 {

/// As predicates::ByDistance. Requires triangles.
class BehindWalls {
  /// A vertex, or an edge by the nearest point of its box.
  struct Candidate {
    Point3 at;
    double squared = 0;  // distance, rounded
    VertexId vertex;
    HalfEdgeId edge;
  };
  // Edges come before vertices as far away: there may be others behind them.
  [[nodiscard]] auto later() const {
    return [this](const Candidate& a, const Candidate& b) {
      const Sign s = predicates::compare_distances(p_, a.at, a.squared, b.at, b.squared);
      if (s != Sign::zero) return s == Sign::positive;
      if (!a.vertex.valid() || !b.vertex.valid()) return a.vertex.valid() && !b.vertex.valid();
      return b.vertex < a.vertex;
    };
  }

 public:
  BehindWalls(const LivePlane& plane, const Point2& p, VertexId near)
      : plane_(plane), p_{p.x, p.y, 0} {
    const Incremental2& triangles = plane.triangles();
    const TriangleId at = triangles.locate(p, plane.start(p, near));
    if (!triangles.is_ghost(at)) {
      visit(at);
      return;
    }
    // From outside any edge of the hull may be met.
    const HalfEdgeId first = triangles.out(Incremental2::kGhost);
    HalfEdgeId h = first;
    do {
      visit(Incremental2::triangle(h));
      h = triangles.rotate(h);
    } while (h != first);
  }

  /// Requires that next() was not called.
  [[nodiscard]] VertexId first() { return next(); }
  /// The next one by distance, then by id; invalid in the end.
  [[nodiscard]] VertexId next() {
    while (!candidates_.empty()) {
      std::pop_heap(candidates_.begin(), candidates_.end(), later());
      const Candidate c = candidates_.back();
      candidates_.pop_back();
      if (c.vertex.valid()) return c.vertex;
      const TriangleId t = Incremental2::triangle(plane_.triangles().opposite(c.edge));
      if (!plane_.triangles().is_ghost(t)) visit(t);
    }
    return {};
  }

 private:
  void add(const Point3& at, VertexId v, HalfEdgeId h) {
    candidates_.push_back({at, predicates::squared_distance(p_, at), v, h});
    std::push_heap(candidates_.begin(), candidates_.end(), later());
  }
  void add_edge(const Point2& a, const Point2& b, HalfEdgeId h) {
    const auto nearest = [](double p, double u, double v) {
      return std::clamp(p, std::min(u, v), std::max(u, v));
    };
    add({nearest(p_.x, a.x, b.x), nearest(p_.y, a.y, b.y), 0}, {}, h);
  }
  void visit(TriangleId t) {
    if (!visited_.insert(t)) return;
    const Incremental2& triangles = plane_.triangles();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId h = Incremental2::half_edge(t, i);
      const SiteId from = triangles.origin(h), to = triangles.destination(h);
      if (from == Incremental2::kGhost) continue;
      const Point2& a = triangles.point(from);
      const VertexId v = plane_.vertex(from);
      if (found_.insert(v)) add({a.x, a.y, 0}, v, {});
      if (to != Incremental2::kGhost) add_edge(a, triangles.point(to), h);
    }
  }

  const LivePlane& plane_;
  Point3 p_;
  std::vector<Candidate> candidates_;  // a heap
  IdSet<TriangleId> visited_;
  IdSet<VertexId> found_;
};

}  // namespace tetloft::internal::triangulation2
