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

bool is_near(const Slab& slab, TetId t, const Point2& p) {
  bool left = false, right = false, below = false, above = false;
  for (const SlabVertexId v : slab.vertices(t)) {
    const Point2 q = flat(slab, v);
    left = left || q.x <= p.x;
    right = right || q.x >= p.x;
    below = below || q.y <= p.y;
    above = above || q.y >= p.y;
  }
  return left && right && below && above;
}

}  // namespace

std::vector<TetId> tets_over(const Slab& slab, const Point2& p) {
  std::vector<TetId> over;
  for (const TetId t : slab.tets()) {
    if (!is_near(slab, t, p)) continue;
    for (int i = 0; i < 4; ++i) {
      if (!contains(face(slab, t, i), p)) continue;
      over.push_back(t);
      break;
    }
  }
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
