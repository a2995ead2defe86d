// Sorting many lists of which nearly all are short.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>

namespace tetloft::internal {

/// Sorts; a short list by insertion, without what std::sort does before that.
template <class T, class Less = std::less<>>
void sort_few(std::span<T> list, const Less& less = {}) {
  constexpr std::size_t kFew = 16;  // as std::sort has it, mostly
  if (list.size() > kFew) {
    std::sort(list.begin(), list.end(), less);
    return;
  }
  for (std::size_t i = 1; i < list.size(); ++i) {
    const T moved = list[i];
    std::size_t k = i;
    for (; k > 0 && less(moved, list[k - 1]); --k) list[k] = list[k - 1];
    list[k] = moved;
  }
}

}  // namespace tetloft::internal
