// Counting sort of items 0 … n − 1 by a small integer key: the one way to group
// things here, because it is linear and its order depends on nothing but the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetloft::internal {

/// Items grouped by key, ascending in each group.
class Buckets {
 public:
  /// key(i) is a number below key_count, or any larger one to leave item i out.
  template <class Key>
  Buckets(std::size_t key_count, std::size_t item_count, Key&& key) : begin_(key_count + 1) {
    for (std::size_t i = 0; i < item_count; ++i) {
      const std::size_t k = key(i);
      if (k < key_count) ++begin_[k + 1];
    }
    for (std::size_t k = 0; k < key_count; ++k) begin_[k + 1] += begin_[k];
    items_.resize(begin_[key_count]);
    for (std::size_t i = 0; i < item_count; ++i) {
      const std::size_t k = key(i);
      if (k < key_count) items_[begin_[k]++] = static_cast<std::uint32_t>(i);
    }
    // Filling moved every begin to its group's end, which is the next group's begin.
    for (std::size_t k = key_count; k > 0; --k) begin_[k] = begin_[k - 1];
    begin_[0] = 0;
  }

  /// Puts value(i) in the place of each item i; groups and their order stay.
  template <class Value>
  void replace(Value&& value) {
    for (std::uint32_t& item : items_) item = value(item);
  }

  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t key) const {
    return {items_.data() + begin_[key], begin_[key + 1] - begin_[key]};
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> items_;
};

}  // namespace tetloft::internal
