// Frames as numbers, and points taken back to the stack.
#include "io/vtu_frame.hpp"

namespace tetloft::internal::io {

namespace {

// The inverse of an exchange of coordinates is its transpose.
Point3 exchanged_back(const Frame& frame, const Point3& p) {
  const auto& [a, b, c] = frame.axes;
  return place(Frame{{Point3{a.x, b.x, c.x}, Point3{a.y, b.y, c.y}, Point3{a.z, b.z, c.z}}, {}}, p);
}

}  // namespace

std::array<double, kFrameNumbers> numbers_of(const Frame& frame) {
  const auto& [a, b, c] = frame.axes;
  const Point3& o = frame.origin;
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, o.x, o.y, o.z};
}

Frame frame_of(const std::vector<double>& n) {
  return {{Point3{n[0], n[1], n[2]}, Point3{n[3], n[4], n[5]}, Point3{n[6], n[7], n[8]}},
          {n[9], n[10], n[11]}};
}

bool take_back(const Frame& frame, const std::vector<double>& stack_points,
               IdVector<VertexId, Point3>& points) {
  const bool exact = is_exact(frame);
  if (!exact && stack_points.size() != 3 * points.size()) return false;
  IdVector<VertexId, Point3> back;
  back.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[VertexId(i)];
    back.push_back(
        exact ? exchanged_back(frame, p)
              : Point3{stack_points[3 * i], stack_points[3 * i + 1], stack_points[3 * i + 2]});
    if (place(frame, back[VertexId(i)]) != p) return false;
  }
  points = std::move(back);
  return true;
}

}  // namespace tetloft::internal::io
