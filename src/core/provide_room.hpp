// Memory before it is needed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/pages.hpp"

namespace tetloft::internal {

/// So many more items find room without memory, in constant time for each on average: reserve()
/// alone may take exactly what is asked for, and move everything each time. Large arrays are
/// not twice in memory while they move.
template <class T>
void provide_room(std::vector<T>& items, std::size_t more) {
  if (items.capacity() - items.size() >= more) return;
  const std::size_t room = std::max(2 * items.capacity(), items.size() + more);
  if constexpr (std::is_trivially_copyable_v<T>) {
    std::vector<T> wide;
    wide.reserve(room);
    core::hand_over(std::span<T>(items), [&](std::span<const T> some) {
      wide.insert(wide.end(), some.begin(), some.end());
    });
    items = std::move(wide);
  } else {
    items.reserve(room);
  }
}

}  // namespace tetloft::internal
