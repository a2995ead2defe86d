// Median splits along the longer side, by a work list.
#include "check/box_tree.hpp"

#include <numeric>

namespace tetloft::internal::checking {

namespace {

constexpr std::uint32_t kLeafSize = 8;

// Twice the centre, for boxes of any size: an unbounded side counts as far away.
double doubled_centre(double low, double high) {
  constexpr double kFar = 0x1p1020;
  return std::clamp(low, -kFar, kFar) + std::clamp(high, -kFar, kFar);
}

}  // namespace

BoxTree::BoxTree(std::vector<Box2> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  if (boxes_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size()), 0});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::uint32_t begin = nodes_[n].begin;
    const std::uint32_t end = nodes_[n].end;
    Box2 box = boxes_[order_[begin]];
    for (std::uint32_t k = begin + 1; k < end; ++k) box.include(boxes_[order_[k]]);
    nodes_[n].box = box;
    if (end - begin <= kLeafSize) continue;
    const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const auto key = [&](std::uint32_t i) {
      const Box2& b = boxes_[i];
      const double centre =
          by_x ? doubled_centre(b.low.x, b.high.x) : doubled_centre(b.low.y, b.high.y);
      return std::pair(centre, i);
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    nodes_[n].children = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, begin, middle, 0});
    nodes_.push_back({{}, middle, end, 0});
  }
}

}  // namespace tetloft::internal::checking
