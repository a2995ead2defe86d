// The vertices of a Delaunay triangulation by their distance from a point, compared exactly.
//
// A vertex without a strictly nearer neighbour is nearest of all: its Voronoi cell is bounded by
// the bisectors with its neighbours. So whoever steps from neighbour to neighbour as long as one is
// nearer comes to a nearest vertex, and in order of distance every vertex but the nearest ones has
// a neighbour that came before. The nearest ones, if they are several, lie on a sphere with nothing
// inside; their hull is a union of simplices of every Delaunay triangulation, so edges join them.
// None of it holds of constrained triangulations (triangulation2/behind_walls.hpp).
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

#include "core/id_set.hpp"
#include "predicates/distances.hpp"

namespace tetloft::internal::predicates {

/// Graph has `point(v)`, in space, and `for_each_neighbour(v, visit)`, which may come to a
/// neighbour several times and ends when visit(neighbour) is false.
template <class Graph>
class ByDistance {
 public:
  /// The search starts at the nearest of some vertices, at least one.
  ByDistance(Graph graph, const Point3& p, const std::vector<VertexId>& starts)
      : graph_(std::move(graph)), p_(p) {
    Candidate at = candidate(starts.front());
    for (const VertexId v : starts) take_nearer(at, v);
    bool tied = false;
    while (step(at, tied)) {
    }
    seen_.insert(at.vertex);
    if (tied) {
      collect_nearest(at);
    } else {
      candidates_.push_back(at);
    }
  }

  /// The nearest vertex, of several that of lowest id.
  [[nodiscard]] VertexId first() const { return candidates_.front().vertex; }

  /// The next one by distance, then by id; the nearest at first, invalid in the end.
  [[nodiscard]] VertexId next() {
    if (candidates_.empty()) return {};
    std::pop_heap(candidates_.begin(), candidates_.end(), later());
    const VertexId v = candidates_.back().vertex;
    candidates_.pop_back();
    graph_.for_each_neighbour(v, [&](VertexId u) {
      if (seen_.insert(u)) add(candidate(u));
      return true;
    });
    return v;
  }

 private:
  struct Candidate {
    VertexId vertex;
    double squared = 0;  // distance, rounded
  };
  [[nodiscard]] Candidate candidate(VertexId v) const {
    return {v, squared_distance(p_, graph_.point(v))};
  }
  [[nodiscard]] Sign compare(const Candidate& a, const Candidate& b) const {
    return compare_distances(p_, graph_.point(a.vertex), a.squared, graph_.point(b.vertex),
                             b.squared);
  }
  [[nodiscard]] auto later() const {
    return [this](const Candidate& a, const Candidate& b) {
      const Sign s = compare(a, b);
      return s == Sign::positive || (s == Sign::zero && b.vertex < a.vertex);
    };
  }
  void take_nearer(Candidate& at, VertexId v) const {
    const Candidate other = candidate(v);
    if (compare(other, at) == Sign::negative) at = other;
  }
  // To a neighbour that is nearer, if there is one; else tells whether one is as near.
  [[nodiscard]] bool step(Candidate& at, bool& tied) {
    const Candidate from = at;
    tied = false;
    graph_.for_each_neighbour(from.vertex, [&](VertexId v) {
      const Candidate other = candidate(v);
      const Sign s = compare(other, from);
      if (s == Sign::negative) at = other;
      tied = tied || s == Sign::zero;
      return s != Sign::negative;
    });
    return at.vertex != from.vertex;
  }
  void collect_nearest(const Candidate& nearest) {
    std::vector<Candidate> equal{nearest};
    for (std::size_t k = 0; k < equal.size(); ++k) {
      graph_.for_each_neighbour(equal[k].vertex, [&](VertexId v) {
        if (seen_.contains(v)) return true;
        const Candidate other = candidate(v);
        if (compare(other, nearest) != Sign::zero) return true;
        seen_.insert(v);
        equal.push_back(other);
        return true;
      });
    }
    for (const Candidate& c : equal) add(c);
  }
  void add(const Candidate& c) {
    candidates_.push_back(c);
    std::push_heap(candidates_.begin(), candidates_.end(), later());
  }

  Graph graph_;
  Point3 p_;
  std::vector<Candidate> candidates_;  // a heap, the first one nearest
  IdSet<VertexId> seen_;
};

/// The first k of an order of vertices, or all there are.
template <class Order>
[[nodiscard]] std::vector<VertexId> first_of(Order& order, std::size_t k) {
  std::vector<VertexId> result;
  while (result.size() < k) {
    const VertexId v = order.next();
    if (!v.valid()) break;
    result.push_back(v);
  }
  return result;
}

/// Those of an order by distance from p that are at most `radius` away, the point of v at
/// `point(v)`.
template <class Order, class PointOf>
[[nodiscard]] std::vector<VertexId> within(Order& order, const Point3& p, double radius,
                                           const PointOf& point) {
  std::vector<VertexId> result;
  for (VertexId v = order.next(); v.valid(); v = order.next()) {
    if (compare_distance(p, point(v), radius) == Sign::positive) break;
    result.push_back(v);
  }
  return result;
}

}  // namespace tetloft::internal::predicates
