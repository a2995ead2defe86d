// IMOD models as tests make them. Shares no code with the product.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::test {

inline std::string imod_integer(std::int64_t value) {
  std::string bytes;
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (shift - 8) & 0xFFU);
  }
  return bytes;
}
inline std::string imod_float(double value) {
  return imod_integer(std::bit_cast<std::int32_t>(static_cast<float>(value)));
}
inline std::string imod_name(std::string name, std::size_t size) {
  name.resize(size);
  return name;
}

struct ImodHeader {
  int objects = 1;
  double z_scale = 1;
  double pixel = 1;
  int unit = -9;
};

inline std::string imod_header(const ImodHeader& header) {
  std::string bytes = "IMODV1.2" + imod_name("a model", 128);
  for (const int maximum : {100, 100, 50}) bytes += imod_integer(maximum);
  bytes += imod_integer(header.objects) + imod_integer(0xF400);
  for (const int setting : {1, 1, 0, 255}) bytes += imod_integer(setting);
  for (const double offset : {0, 0, 0}) bytes += imod_float(offset);
  for (const double scale : {1.0, 1.0, header.z_scale}) bytes += imod_float(scale);
  for (const int current : {0, 0, 0, 3, 128}) bytes += imod_integer(current);
  bytes += imod_float(header.pixel) + imod_integer(header.unit) + imod_integer(0);
  return bytes + imod_float(0) + imod_float(0) + imod_float(0);
}

inline std::string imod_object(const std::string& name, int contours, unsigned flags = 0) {
  std::string bytes = "OBJT" + imod_name(name, 64) + std::string(64, '\0');
  bytes += imod_integer(contours) + imod_integer(flags) + imod_integer(0) + imod_integer(1);
  for (const double colour : {0.0, 1.0, 0.0}) bytes += imod_float(colour);
  bytes += imod_integer(0) + std::string(8, '\1');
  return bytes + imod_integer(0) + imod_integer(0);
}

inline std::string imod_contour(const std::vector<Point3>& points, unsigned flags = 0,
                                int time = 0) {
  std::string bytes = "CONT" + imod_integer(static_cast<std::int64_t>(points.size())) +
                      imod_integer(flags) + imod_integer(time) + imod_integer(0);
  for (const Point3& p : points) bytes += imod_float(p.x) + imod_float(p.y) + imod_float(p.z);
  return bytes;
}

inline std::string imod_piece(const std::string& name, const std::string& data) {
  return name + imod_integer(static_cast<std::int64_t>(data.size())) + data;
}

inline std::string imod_mesh(int vertices, int indices) {
  return "MESH" + imod_integer(vertices) + imod_integer(indices) + imod_integer(0) +
         imod_integer(0) + std::string(static_cast<std::size_t>(12 * vertices + 4 * indices), '\0');
}

/// A square of side 2 in section z.
inline std::vector<Point3> imod_square(double z) {
  return {{0, 0, z}, {2, 0, z}, {2, 2, z}, {0, 2, z}};
}

}  // namespace tetloft::test
