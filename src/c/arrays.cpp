#include "c/arrays.hpp"

namespace tetloft::internal::c {

void require_countable(std::size_t count) {
  if (count >= TETLOFT_NO_ID) {
    throw Failed(Error{ErrorCode::invalid_input, "2^32 - 1 elements or more have no ids", {}});
  }
}

std::vector<Point2> plane_points(const double* xy, std::size_t count) {
  require_array(xy, count, sizeof(Point2), "xy");
  require_countable(count);
  std::vector<Point2> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {xy[2 * i], xy[2 * i + 1]};
  return points;
}

std::vector<Point3> space_points(const double* xyz, std::size_t count) {
  require_array(xyz, count, sizeof(Point3), "xyz");
  require_countable(count);
  std::vector<Point3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
  }
  return points;
}

PeriodicBox periodic_box(const double* vectors) {
  require_array(vectors, 3, sizeof(Point3), "box");
  const double* const v = vectors;
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
}

std::vector<TetVertices> tets_of(const std::uint32_t* tets, std::size_t count) {
  if (count >= std::size_t{1} << 30) {
    throw Failed(Error{ErrorCode::invalid_input, "2^30 tets or more", {}});
  }
  return id_tuples<VertexId, 4>(tets, count, "tets");
}

std::string text_of(const char* text, const char* name) {
  if (text == nullptr) fail_usage(std::string(name) + " is NULL");
  return text;
}

std::string_view bytes_of(const void* data, std::size_t size) {
  require_array(data, size, 1, "data");
  return {static_cast<const char*>(data), size};
}

}  // namespace tetloft::internal::c
