// Disjoint sets over 0 … n−1, and more as they come. The representative of a set is its smallest
// element, so the result depends on the unions only, not on their order.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace tetloft::internal {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  [[nodiscard]] std::size_t find(std::size_t i) const {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Returns false if i and j were united already.
  bool unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    if (j < i) std::swap(i, j);
    parent_[j] = i;
    return true;
  }

  /// One more element, in a set of its own: the number of elements before.
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }

  [[nodiscard]] bool same(std::size_t i, std::size_t j) const { return find(i) == find(j); }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  mutable std::vector<std::size_t> parent_;  // path halving changes no set
};

}  // namespace tetloft::internal
