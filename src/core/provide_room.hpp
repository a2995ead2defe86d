// Memory before it is needed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tetloft::internal {

/// So many more items find room without memory, in constant time for each on average: reserve()
/// alone may take exactly what is asked for, and move everything each time.
template <class T>
void provide_room(std::vector<T>& items, std::size_t more) {
  if (items.capacity() - items.size() >= more) return;
  items.reserve(std::max(2 * items.capacity(), items.size() + more));
}

}  // namespace tetloft::internal
