// Parts of space with about as many points each: boxes, by cuts along the axes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay3_detail {

/// Where a set is cut in two.
enum class Cuts : std::uint8_t {
  even,    ///< at the quantile: as many points to each part
  sparse,  ///< where the points are sparsest, within a factor of two of that
};

class Partition {
 public:
  /// Up to `parts` boxes by a sample of points, which is put into another order.
  Partition(std::span<Point3> sample, std::size_t parts, Cuts cuts);

  /// The number of parts: fewer than asked for where the points of the sample lie in too few planes
  /// across each axis.
  [[nodiscard]] std::size_t parts() const { return parts_; }
  /// The part of a point, any point.
  [[nodiscard]] std::uint32_t part_of(const Point3& p) const {
    std::size_t at = 0;
    while (nodes_[at].axis < 3) at = nodes_[at].child + (at_or_above(nodes_[at], p) ? 1U : 0U);
    return nodes_[at].child;
  }

 private:
  // A box: cut, or a part.
  struct Node {
    std::uint32_t axis = 3;   // across which it is cut; 3: it is a part
    std::uint32_t child = 0;  // the node below the cut, above it the next; or the part
    double cut = 0;
  };

  [[nodiscard]] static bool at_or_above(const Node& node, const Point3& p) {
    return (node.axis == 0 ? p.x : node.axis == 1 ? p.y : p.z) >= node.cut;
  }
  void divide(std::size_t node, std::span<Point3> sample, std::size_t parts, Cuts cuts);

  std::vector<Node> nodes_;
  std::size_t parts_ = 0;
};

}  // namespace tetloft::internal::delaunay3_detail
