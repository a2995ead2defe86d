// Which constraints go over which edges.
//
// An edge that a constraint goes over twice, as pieces that were rounded may, has it twice.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/ids.hpp>

namespace tetloft::internal::triangulation2 {

class Walls {
 public:
  using Edge = std::array<VertexId, 2>;  // by increasing id
  using Edges = std::map<Edge, std::vector<ConstraintId>>;

  /// A wall that a vertex is about to divide, and its halves.
  struct Division {
    Edge whole;
    Edges halves;
  };

  [[nodiscard]] static Edge edge(VertexId a, VertexId b) { return a < b ? Edge{a, b} : Edge{b, a}; }
  [[nodiscard]] const Edges& edges() const { return edges_; }
  [[nodiscard]] bool empty() const { return edges_.empty(); }
  /// Null where a b is no wall.
  [[nodiscard]] const std::vector<ConstraintId>* over(VertexId a, VertexId b) const {
    const auto found = edges_.find(edge(a, b));
    return found == edges_.end() ? nullptr : &found->second;
  }

  /// If memory ends, nothing has happened.
  void add(VertexId a, VertexId b, const std::vector<ConstraintId>& constraints) {
    std::vector<ConstraintId> all = constraints;
    if (const std::vector<ConstraintId>* there = over(a, b)) {
      all.insert(all.end(), there->begin(), there->end());
    }
    std::sort(all.begin(), all.end());
    edges_[edge(a, b)].swap(all);
  }
  /// True where none is left.
  bool take(VertexId a, VertexId b, ConstraintId c) {
    const auto found = edges_.find(edge(a, b));
    std::erase(found->second, c);
    if (!found->second.empty()) return false;
    edges_.erase(found);
    return true;
  }
  std::vector<ConstraintId> take_all(VertexId a, VertexId b) {
    const auto found = edges_.find(edge(a, b));
    std::vector<ConstraintId> all;
    all.swap(found->second);
    edges_.erase(found);
    return all;
  }

  [[nodiscard]] Division prepare(VertexId a, VertexId b, VertexId middle) const {
    const std::vector<ConstraintId>& all = *over(a, b);
    return {edge(a, b), {{edge(a, middle), all}, {edge(middle, b), all}}};
  }
  /// Does nothing where nothing was prepared.
  void divide(Division& division) noexcept {
    if (division.halves.empty()) return;
    edges_.erase(division.whole);
    edges_.merge(division.halves);
  }
  /// The edge to a vertex w is one to v from now on.
  void rename(VertexId w, VertexId v, VertexId other) noexcept {
    auto node = edges_.extract(edge(w, other));
    if (node.empty()) return;
    node.key() = edge(v, other);
    edges_.insert(std::move(node));
  }

 private:
  Edges edges_;
};

}  // namespace tetloft::internal::triangulation2
