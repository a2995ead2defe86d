// Surfaces as files have them, polygons of numbered points, on their way to triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

namespace tetloft::internal::io {

class PolygonList {
 public:
  void add_point(const Point3& p) { read_.mesh.points.push_back(p); }
  [[nodiscard]] std::size_t points() const { return read_.mesh.points.size(); }

  /// Corners by number of point, which may follow later: as a fan of triangles around the first
  /// one. Of fewer than three corners there are none. `place` is for missing().
  void add_polygon(const std::vector<std::uint32_t>& corners, std::size_t place);

  /// The highest number of a point, and where it is first, if no such point came.
  struct Missing {
    std::uint32_t point = 0;
    std::size_t place = 0;
  };
  [[nodiscard]] std::optional<Missing> missing() const;

  /// What was read, with a warning of polygons without triangles.
  [[nodiscard]] ReadTriangles take(const std::string& name);

 private:
  ReadTriangles read_;
  std::size_t small_ = 0;  // of fewer than three corners
  std::optional<Missing> highest_;
};

}  // namespace tetloft::internal::io
