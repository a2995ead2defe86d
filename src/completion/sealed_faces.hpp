// VV faces that should be open and that a complex seals, and SS faces that should be solid and are
// not: by what D holds over a point well inside the face.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/point.hpp>

#include "completion/void_space.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

/// What D holds over points of the plane.
class TetsOver {
 public:
  /// The slab must outlive this.
  explicit TetsOver(const Slab& slab) : slab_(slab) {}

  /// The tets that a vertical line through the point meets, by id. The first call makes a tree of
  /// all of them.
  [[nodiscard]] std::vector<TetId> operator()(const Point2& p);

 private:
  const Slab& slab_;
  std::optional<BoxTree2> tree_;
};

/// Does the line stay in the void?
[[nodiscard]] bool is_open(const Slab& slab, const VoidSpace& space, const std::vector<TetId>& over,
                           const Point2& p);

}  // namespace tetloft::internal
