// GeoJSON (RFC 7946, and the 2008 specification with its "crs") as it stands: lines, and the
// properties of what holds them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/drawing/drawing.hpp"

namespace tetloft::internal::io {

/// A property that is a number, a number as text, or a range as text ("0-5").
struct GeoProperty {
  std::uint32_t name = 0;  ///< position in GeoContents::names
  bool range = false;
  double low = 0;   ///< the number
  double high = 0;  ///< of a range; else as `low`
};

/// What a Feature, or a geometry with members of its own, says of the lines in it. Those within
/// others stand before them.
struct GeoHolder {
  std::size_t first_line = 0;
  std::size_t end_line = 0;
  std::size_t first_property = 0;
  std::size_t end_property = 0;
};

enum class GeoHeight : std::uint8_t { none, constant, varying };

struct GeoContents {
  std::vector<DrawnLine> lines;   ///< rings and lines; z is 0 where a position has none
  std::vector<GeoHeight> height;  ///< by line: third coordinates of all its positions
  std::vector<GeoHolder> holders;
  std::vector<GeoProperty> properties;
  std::vector<std::string> names;
  std::size_t points = 0;            ///< Points, and those of MultiPoints
  std::size_t without_geometry = 0;  ///< features of null
  std::size_t empty = 0;             ///< geometries without positions
  std::size_t polygons = 0;          ///< rings
  std::string crs;                   ///< name of the coordinate reference system
};

/// Errors invalid_input with the line.
[[nodiscard]] Result<GeoContents> scan_geojson(std::string_view bytes, const std::string& name);

}  // namespace tetloft::internal::io
