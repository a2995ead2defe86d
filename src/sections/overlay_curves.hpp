// The contours of a section as flat arrays, for an overlay: edges, turning, and trees to find them.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

class OverlayCurves {
 public:
  /// Consecutive edges of one contour, the unit of the tree.
  struct Block {
    std::uint32_t first, last;
  };

  explicit OverlayCurves(const Section& section);

  // Vertices of all contours one after another; edge v leads from vertex v to next(v).
  [[nodiscard]] std::uint32_t edge_count() const { return first_.back(); }
  [[nodiscard]] std::uint32_t contour_count() const {
    return static_cast<std::uint32_t>(first_.size() - 1);
  }
  [[nodiscard]] std::uint32_t contour(std::uint32_t edge) const { return contour_[edge]; }
  [[nodiscard]] std::uint32_t next(std::uint32_t v) const {
    return v + 1 == first_[contour_[v] + 1] ? first_[contour_[v]] : v + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t v) const {
    return v == first_[contour_[v]] ? first_[contour_[v] + 1] - 1 : v - 1;
  }
  [[nodiscard]] const Point2& start(std::uint32_t edge) const { return at_[edge]; }
  [[nodiscard]] const Point2& end(std::uint32_t edge) const { return at_[next(edge)]; }
  /// Does the edge lead from the lower to the higher end, in canonical order?
  [[nodiscard]] bool rises(std::uint32_t edge) const {
    return canonical_less(start(edge), end(edge));
  }
  [[nodiscard]] const Point2& low(std::uint32_t edge) const {
    return rises(edge) ? start(edge) : end(edge);
  }
  [[nodiscard]] const Point2& high(std::uint32_t edge) const {
    return rises(edge) ? end(edge) : start(edge);
  }
  /// The lowest vertex of a contour in canonical order.
  [[nodiscard]] const Point2& lowest(std::uint32_t contour) const { return at_[lowest_[contour]]; }

  /// Half turns, counter-clockwise ones less clockwise ones, at the vertices before v in the
  /// arrays. A vertex makes one where the contour changes between rising and falling.
  [[nodiscard]] std::int32_t turns_before(std::uint32_t v) const { return turns_before_[v]; }
  /// Of the whole contour: 2 or −2.
  [[nodiscard]] std::int32_t turns(std::uint32_t contour) const {
    return turns_before_[first_[contour + 1]] - turns_before_[first_[contour]];
  }
  [[nodiscard]] bool is_counter_clockwise(std::uint32_t contour) const {
    return turns(contour) > 0;
  }

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] const std::vector<Box2>& block_boxes() const { return block_boxes_; }
  /// Over blocks().
  [[nodiscard]] const BoxTree2& tree() const { return tree_; }

 private:
  void count_turns();
  void make_blocks();

  std::vector<Point2> at_;
  std::vector<std::uint32_t> contour_;      // of a vertex
  std::vector<std::uint32_t> first_;        // first_[c]: the first vertex; one more than contours
  std::vector<std::uint32_t> lowest_;       // of a contour
  std::vector<std::int32_t> turns_before_;  // one more than vertices
  std::vector<Block> blocks_;
  std::vector<Box2> block_boxes_;
  BoxTree2 tree_;
};

}  // namespace tetloft::internal::sections
