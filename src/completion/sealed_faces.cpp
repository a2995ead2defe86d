#include "completion/sealed_faces.hpp"

#include <algorithm>
#include <array>

#include <tetloft/predicates.hpp>

namespace tetloft::internal {

namespace {

Point2 flat(const Slab& slab, SlabVertexId v) {
  return slab.section_of(v).point(slab.in_section(v));
}

// In the triangle, its border included. Of a flat one, on it.
bool contains(const std::array<Point2, 3>& triangle, const Point2& p) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign side = orient2d(triangle[i], triangle[(i + 1) % 3], p);
    left = left || side == Sign::positive;
    right = right || side == Sign::negative;
  }
  return !(left && right);
}

std::array<Point2, 3> face(const Slab& slab, TetId t, int i) {
  std::array<Point2, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] = flat(slab, slab.vertex(t, kFaceVertex[static_cast<std::size_t>(i)][k]));
  }
  return points;
}

std::vector<Box2> boxes_of(const Slab& slab) {
  std::vector<Box2> boxes;
  boxes.reserve(slab.tet_count());
  for (const TetId t : slab.tets()) {
    Box2& box = boxes.emplace_back();
    for (const SlabVertexId v : slab.vertices(t)) box.add(flat(slab, v));
  }
  return boxes;
}

}  // namespace

std::vector<TetId> TetsOver::operator()(const Point2& p) {
  if (!tree_) tree_.emplace(boxes_of(slab_));
  std::vector<TetId> over;
  tree_->query(box_of(p, p), [&](std::size_t near) {
    const TetId t(near);
    for (int i = 0; i < 4; ++i) {
      if (!contains(face(slab_, t, i), p)) continue;
      over.push_back(t);
      break;
    }
  });
  std::sort(over.begin(), over.end());
  return over;
}

bool is_open(const Slab& slab, const VoidSpace& space, const std::vector<TetId>& over,
             const Point2& p) {
  for (const TetId t : over) {
    if (!space.is_void(t)) return false;
    for (int i = 0; i < 4; ++i) {
      if (contains(face(slab, t, i), p) && space.is_closed(t, 0xFU & ~(1U << i))) return false;
    }
  }
  return true;
}

}  // namespace tetloft::internal
