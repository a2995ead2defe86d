// Nearest triangles and segments: a tree of boxes, searched from the nearest box on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>

#include "comparison/triangle_mesh.hpp"

namespace tetloft::bench {

struct Box3 {
  Point3 low{kFar, kFar, kFar};
  Point3 high{-kFar, -kFar, -kFar};
  void extend(const Point3& p);
  /// Square of the distance from p; 0 inside.
  [[nodiscard]] double distance2(const Point3& p) const;

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
};

/// A balanced tree over items with boxes, each node halved at the median of the box centres along
/// their longest extent.
class BoxHierarchy {
 public:
  explicit BoxHierarchy(std::span<const Box3> boxes);

  /// The least distance2(item) below `bound`, over all items; `bound` if there is none. Requires
  /// that distance2(item) is no less than the distance to the item's box.
  template <class Distance2>
  [[nodiscard]] double nearest2(const Point3& p, double bound, Distance2&& distance2) const {
    if (nodes_.empty()) return bound;
    // The farther child waits; a tree of 2^32 items is no deeper.
    std::array<std::pair<double, std::uint32_t>, 64> waiting;
    std::size_t n = 0;
    waiting[n++] = {nodes_[0].box.distance2(p), 0};
    while (n > 0) {
      const auto [distance, at] = waiting[--n];
      if (distance >= bound) continue;
      const Node& node = nodes_[at];
      if (node.left == 0) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
          const double d = distance2(items_[i]);
          if (d < bound) bound = d;
        }
        continue;
      }
      std::pair<double, std::uint32_t> near{nodes_[node.left].box.distance2(p), node.left};
      std::pair<double, std::uint32_t> far{nodes_[node.left + 1].box.distance2(p), node.left + 1};
      if (far.first < near.first) std::swap(near, far);
      waiting[n++] = far;
      waiting[n++] = near;
    }
    return bound;
  }

 private:
  // items_[begin … end − 1]; a leaf iff left is 0, else the children are left and left + 1.
  struct Node {
    Box3 box;
    std::uint32_t begin = 0, end = 0, left = 0;
  };
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

/// Squares of distances of a point.
[[nodiscard]] double distance2_to_segment(const Point3& p, const Point3& a, const Point3& b);
[[nodiscard]] double distance2_to_triangle(const Point3& p, const Point3& a, const Point3& b,
                                           const Point3& c);

/// Distances to a surface.
class SurfaceSearch {
 public:
  explicit SurfaceSearch(const TriangleMesh& mesh);
  /// Infinite if there are no triangles.
  [[nodiscard]] double distance(const Point3& p) const;

 private:
  std::vector<std::array<Point3, 3>> triangles_;
  BoxHierarchy boxes_;
};

}  // namespace tetloft::bench
