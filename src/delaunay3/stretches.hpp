// Arrays cut into stretches, for several threads.
#pragma once

#include <algorithm>
#include <cstddef>

namespace tetloft::internal::delaunay3_detail {

/// Stretches of an array that threads work on: their number depends on its length alone.
struct Stretches {
  std::size_t items = 0;
  std::size_t count = 1;

  /// Of about `length` items each, `most` at most.
  static Stretches of(std::size_t items, std::size_t length, std::size_t most) {
    return {items, std::clamp<std::size_t>(items / length, 1, most)};
  }

  [[nodiscard]] std::size_t begin(std::size_t k) const { return items * k / count; }
  [[nodiscard]] std::size_t end(std::size_t k) const { return begin(k + 1); }
};

}  // namespace tetloft::internal::delaunay3_detail
