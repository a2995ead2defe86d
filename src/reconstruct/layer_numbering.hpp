// Items of the layers of a slab with sections between, such as regions, in one sequence.
#pragma once

#include <cstddef>
#include <vector>

namespace tetloft::internal {

class LayerNumbering {
 public:
  void add_layer(std::size_t items) { first_.push_back(first_.back() + items); }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  [[nodiscard]] std::size_t size(std::size_t layer) const {
    return first_[layer + 1] - first_[layer];
  }
  [[nodiscard]] std::size_t of(std::size_t layer, std::size_t item) const {
    return first_[layer] + item;
  }

 private:
  std::vector<std::size_t> first_{0};
};

}  // namespace tetloft::internal
