// A static tree of boxes in the plane: which boxes meet a box, and what is nearest to a
// point. Boxes may be unbounded. An oracle's: it shares nothing with spatial/box_tree, which the
// reconstruction uses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::checking {

struct Box2 {
  Point2 low, high;

  [[nodiscard]] bool meets(const Box2& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
  /// The largest of the distances in x and in y: never more than the Euclidean distance.
  [[nodiscard]] double distance(const Point2& p) const {
    return std::max({0.0, low.x - p.x, p.x - high.x, low.y - p.y, p.y - high.y});
  }
  void include(const Box2& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
  }
};

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<Box2> boxes);

  /// Calls visit(i) for each box i that meets `box`, until it returns false.
  template <class Visit>
  void meeting(const Box2& box, Visit&& visit) const {
    if (boxes_.empty()) return;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!node.box.meets(box)) continue;
      if (node.children != 0) {
        stack.push_back(node.children + 1);
        stack.push_back(node.children);
        continue;
      }
      for (std::uint32_t k = node.begin; k < node.end; ++k) {
        if (boxes_[order_[k]].meets(box) && !visit(order_[k])) return;
      }
    }
  }

  /// The least distance(i) over all boxes i, or the first found that is at most `enough`,
  /// or `most` if none is less. Requires distance(i) ≥ the box's distance from p.
  template <class Distance>
  [[nodiscard]] double nearest(const Point2& p, double enough, double most,
                               Distance&& distance) const {
    double best = most;
    if (boxes_.empty()) return best;
    std::vector<std::pair<double, std::uint32_t>> stack{{nodes_[0].box.distance(p), 0}};
    while (!stack.empty()) {
      const auto [at_least, index] = stack.back();
      stack.pop_back();
      if (at_least >= best) continue;
      const Node& node = nodes_[index];
      if (node.children == 0) {
        for (std::uint32_t k = node.begin; k < node.end; ++k) {
          best = std::min(best, distance(order_[k]));
          if (best <= enough) return best;
        }
        continue;
      }
      std::pair<double, std::uint32_t> near{nodes_[node.children].box.distance(p), node.children};
      std::pair<double, std::uint32_t> far{nodes_[node.children + 1].box.distance(p),
                                           node.children + 1};
      if (far.first < near.first) std::swap(near, far);
      stack.push_back(far);
      stack.push_back(near);
    }
    return best;
  }

 private:
  struct Node {
    Box2 box;
    std::uint32_t begin = 0, end = 0;  // of order_
    std::uint32_t children = 0;        // the first of two; 0 for a leaf
  };
  std::vector<Box2> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace tetloft::internal::checking
