// Items in order, each once.
#pragma once

#include <algorithm>
#include <vector>

namespace tetloft::internal {

template <class Item>
void sort_distinct(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace tetloft::internal
