// Building the packed tree: tiles of boxes by x, then by y, then parents level by level.
#include "spatial/box_tree.hpp"

#include <cmath>
#include <numeric>

namespace tetloft::internal {

BoxTree2::BoxTree2(std::span<const Box2> boxes) : order_(boxes.size()) {
  const std::size_t n = boxes.size();
  if (n == 0) return;
  std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
    return boxes[i].x0 != boxes[j].x0 ? boxes[i].x0 < boxes[j].x0 : i < j;
  });
  const double leaves = static_cast<double>(n) / static_cast<double>(kFanOut);
  const std::size_t strip = kFanOut * static_cast<std::size_t>(std::ceil(std::sqrt(leaves)));
  for (std::size_t first = 0; first < n; first += strip) {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(std::min(first + strip, n));
    std::sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      return boxes[i].y0 != boxes[j].y0 ? boxes[i].y0 < boxes[j].y0 : i < j;
    });
  }
  leaf_.reserve(n);
  for (const std::uint32_t i : order_) leaf_.push_back(boxes[i]);

  std::span<const Box2> below = leaf_;
  nodes_.reserve(n / (kFanOut - 1) + 12);  // never reallocates: `below` stays valid
  while (level_.empty() || below.size() > 1) {
    level_.push_back(nodes_.size());
    for (std::size_t first = 0; first < below.size(); first += kFanOut) {
      Box2 box;
      for (const Box2& child : below.subspan(first, std::min(kFanOut, below.size() - first))) {
        box.add(child);
      }
      nodes_.push_back(box);
    }
    below = std::span<const Box2>(nodes_).subspan(level_.back());
  }
}

}  // namespace tetloft::internal
