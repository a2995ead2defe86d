// Coordinates of formats that hold float32 only: vertices that differ as doubles may coincide
// there, and triangles lose their area.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::io {

using FloatPoint = std::array<float, 3>;

/// Rounded; −0 becomes 0, since readers merge vertices by their bits.
[[nodiscard]] FloatPoint float_point(const Point3& p);

/// Why `points` cannot be written, in a format of this name, if a coordinate is beyond float32.
[[nodiscard]] std::optional<Error> beyond_float32(const std::vector<Point3>& points,
                                                  const std::string& format);

/// What rounding breaks, decided exactly: distinct vertices that merge, triangles that become flat.
class Float32Loss {
 public:
  explicit Float32Loss(std::string format) : format_(std::move(format)) {}

  /// A mesh by its points, distinct, and as they are written; finite.
  void add(const std::vector<Point3>& points,
           const std::vector<std::array<std::uint32_t, 3>>& triangles,
           const std::vector<FloatPoint>& written);

  /// One of vertices and one of triangles, each naming the first place; without any, one of
  /// the volume, if more than a thousandth of it changes: less is what float32 takes from any
  /// surface that its digits suffice for.
  [[nodiscard]] std::vector<Warning> warnings() const;

 private:
  struct Count {
    std::size_t number = 0;
    Point3 place;  ///< of the first
  };
  [[nodiscard]] Warning warning(const char* does, const Count& count, const char* what,
                                const char* whats, const char* so) const;

  std::string format_;
  Count merged_, flattened_;
  double volume_ = 0, written_volume_ = 0;  ///< within the surfaces
};

}  // namespace tetloft::internal::io
