// Axis-parallel boxes and a static tree over them, to find the boxes that meet a query.
//
// Packed bottom-up after one sort-tile-recursive pass (Leutenegger, Lopez and Edgington,
// "STR: a simple and efficient algorithm for R-tree packing", ICDE 1997). Only compares
// coordinates: what it leaves out is exactly disjoint.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal {

/// A closed box; the default one is empty.
struct Box2 {
  double x0 = std::numeric_limits<double>::infinity();
  double y0 = std::numeric_limits<double>::infinity();
  double x1 = -std::numeric_limits<double>::infinity();
  double y1 = -std::numeric_limits<double>::infinity();

  void add(const Point2& p) {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
  void add(const Box2& b) {
    x0 = std::min(x0, b.x0);
    y0 = std::min(y0, b.y0);
    x1 = std::max(x1, b.x1);
    y1 = std::max(y1, b.y1);
  }
  /// How far b is outside along x and y; 0 where their ranges have a point in common.
  [[nodiscard]] Point2 offset(const Box2& b) const {
    return {std::max({x0 - b.x1, b.x0 - x1, 0.0}), std::max({y0 - b.y1, b.y0 - y1, 0.0})};
  }
  [[nodiscard]] Point2 offset(const Point2& p) const { return offset({p.x, p.y, p.x, p.y}); }
  /// Do the closed boxes share a point?
  [[nodiscard]] bool meets(const Box2& b) const {
    return x0 <= b.x1 && b.x0 <= x1 && y0 <= b.y1 && b.y0 <= y1;
  }
  /// Do the open boxes share a point?
  [[nodiscard]] bool overlaps(const Box2& b) const {
    return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1;
  }
};

[[nodiscard]] inline Box2 box_of(const Point2& a, const Point2& b) {
  Box2 box;
  box.add(a);
  box.add(b);
  return box;
}

class BoxTree2 {
 public:
  explicit BoxTree2(std::span<const Box2> boxes);

  /// Calls visit(i) for every box i that meets `query`, in no particular but reproducible
  /// order.
  template <class Visit>
  void query(const Box2& query, Visit visit) const {
    if (level_.empty() || !nodes_[level_.back()].meets(query)) return;
    // At most kFanOut − 1 siblings wait on each of at most 11 levels (8^11 > 2^32).
    Waiting stack[kFanOut * 12];
    std::size_t top = 0;
    stack[top++] = {static_cast<std::uint32_t>(level_.size() - 1), 0};
    while (top > 0) {
      const Waiting node = stack[--top];
      const std::size_t first = std::size_t{node.index} * kFanOut;
      if (node.level == 0) {
        const std::size_t last = std::min(first + kFanOut, order_.size());
        for (std::size_t k = first; k < last; ++k) {
          if (leaf_[k].meets(query)) visit(std::size_t{order_[k]});
        }
        continue;
      }
      const std::uint32_t below = node.level - 1;
      const std::size_t count = level_[below + 1] - level_[below];
      const std::size_t last = std::min(first + kFanOut, count);
      for (std::size_t k = first; k < last; ++k) {
        if (nodes_[level_[below] + k].meets(query)) {
          stack[top++] = {below, static_cast<std::uint32_t>(k)};
        }
      }
    }
  }

  /// Calls visit(i) for boxes roughly from the one of the least offset(box) on, and always for
  /// those of at most within(): what that returns may decrease from visit to visit. Requires that
  /// offset() of a box is not above that of a box in it.
  template <class Offset, class Visit, class Within>
  void query_least(Offset offset, Visit visit, Within within) const {
    if (level_.empty()) return;
    struct Candidate {
      double offset;
      Waiting node;
    };
    Candidate stack[kFanOut * 12];
    std::size_t top = 0;
    stack[top++] = {0, {static_cast<std::uint32_t>(level_.size() - 1), 0}};
    while (top > 0) {
      const Candidate from = stack[--top];
      if (from.offset > within()) continue;
      const std::size_t first = std::size_t{from.node.index} * kFanOut;
      if (from.node.level == 0) {
        const std::size_t last = std::min(first + kFanOut, order_.size());
        for (std::size_t k = first; k < last; ++k) {
          if (offset(leaf_[k]) <= within()) visit(std::size_t{order_[k]});
        }
        continue;
      }
      const std::uint32_t below = from.node.level - 1;
      const std::size_t count = level_[below + 1] - level_[below];
      const std::size_t last = std::min(first + kFanOut, count);
      const std::size_t bottom = top;
      for (std::size_t k = first; k < last; ++k) {
        stack[top++] = {offset(nodes_[level_[below] + k]), {below, static_cast<std::uint32_t>(k)}};
      }
      // The nearest is taken up first.
      std::sort(stack + bottom, stack + top, [](const Candidate& a, const Candidate& b) {
        return a.offset != b.offset ? a.offset > b.offset : a.node.index > b.node.index;
      });
    }
  }
  /// The same for boxes near p: by the distance to it, which is off by four units in the last place
  /// at most, and by 2^-536 where squares underflow. Requires coordinates that can be squared.
  template <class Visit, class Within>
  void query_nearest(const Point2& p, Visit visit, Within within) const {
    const auto offset = [&](const Box2& box) {
      const Point2 outside = box.offset(p);
      return std::sqrt(outside.x * outside.x + outside.y * outside.y);
    };
    query_least(offset, visit, within);
  }

 private:
  static constexpr std::size_t kFanOut = 8;
  struct Waiting {
    std::uint32_t level, index;
  };

  std::vector<std::uint32_t> order_;  // box indices, tile by tile
  std::vector<Box2> leaf_;            // leaf_[k] is box order_[k]
  std::vector<Box2> nodes_;           // level by level, leaves' parents first
  std::vector<std::size_t> level_;    // level_[h]: the first node of level h
};

}  // namespace tetloft::internal
