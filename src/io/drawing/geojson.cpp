// GeoJSON level lines and bands as a drawing.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/cursor.hpp"
#include "io/drawing/bands.hpp"
#include "io/drawing/geojson_heights.hpp"
#include "io/drawing/geojson_scan.hpp"
#include "io/drawing/geojson_write.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// No other format begins with a brace and a name in quotes.
bool is_json_object(std::string_view bytes) {
  TextCursor cursor(bytes);
  const auto skip = [&] {
    for (cursor.skip_white(); cursor.peek() == '\x1E'; cursor.skip_white()) cursor.advance();
  };
  skip();
  if (cursor.peek() != '{') return false;
  cursor.advance();
  skip();
  return cursor.peek() == '"';
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

// Degrees, as far as it can be told: the coordinates fit, and nothing names another system.
bool seems_geographic(const GeoContents& contents) {
  const auto named = [&](std::string_view code) {
    return contents.crs.find(code) != std::string::npos;
  };
  if (named("4326") || named("4269") || named("4258") || named("CRS84")) return true;
  if (!contents.crs.empty()) return false;
  return std::all_of(contents.lines.begin(), contents.lines.end(), [](const DrawnLine& line) {
    return std::all_of(line.points.begin(), line.points.end(),
                       [](const Point3& p) { return std::abs(p.x) <= 180 && std::abs(p.y) <= 90; });
  });
}

void warn_of_coordinates(const GeoContents& contents, std::vector<Warning>& warnings) {
  if (!contents.crs.empty()) {
    warnings.push_back({"the file names the coordinate system " + in_quotes(contents.crs) +
                            " (a \"crs\", which GeoJSON has no more); coordinates are taken as "
                            "they stand",
                        {}});
  }
  if (contents.lines.empty() || !seems_geographic(contents)) return;
  warnings.push_back(
      {"the coordinates seem to be longitudes and latitudes in degrees, and heights "
       "are not: distances, volumes and what is near are distorted; project the "
       "file first, to a system in metres",
       {}});
}

void warn_of_left_out(const GeoContents& contents, std::vector<Warning>& warnings) {
  const auto tell = [&](std::size_t n, const std::string& one, const std::string& many) {
    if (n > 0) warnings.push_back({"left out: " + counted(n, one, many), {}});
  };
  tell(contents.points, "point, which bounds nothing", "points, which bound nothing");
  tell(contents.without_geometry, "feature without geometry", "features without geometry");
  tell(contents.empty, "geometry without coordinates", "geometries without coordinates");
}

// Third coordinates beside a property: both may be heights.
void warn_of_third_coordinates(const GeoContents& contents, const GeoHeights& heights,
                               std::vector<Warning>& warnings) {
  std::size_t differ = 0;
  for (std::size_t i = 0; i < contents.lines.size(); ++i) {
    if (!heights.of[i] || contents.height[i] == GeoHeight::none) continue;
    const double z = contents.lines[i].points.front().z;
    if (contents.height[i] == GeoHeight::varying || (z != 0 && z != *heights.of[i])) ++differ;
  }
  if (differ == 0) return;
  warnings.push_back({"third coordinates, which differ from " + heights.source + " on " +
                          counted(differ, "line", "lines") + ", are left out",
                      {}});
}

void take_heights(GeoContents& contents, const GeoHeights& heights,
                  std::vector<Warning>& warnings) {
  warn_of_third_coordinates(contents, heights, warnings);
  std::size_t without = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < contents.lines.size(); ++i) {
    DrawnLine& line = contents.lines[i];
    if (!heights.of[i]) {
      line.left_out = true;
      if (without++ == 0) first = line.line;
      continue;
    }
    for (Point3& p : line.points) p.z = *heights.of[i];
  }
  warnings.push_back({"heights are " + heights.source +
                          (heights.bands ? ", of bands: the solid at each height is all of the "
                                           "bands that begin there or above"
                                         : ""),
                      {}});
  if (without == 0) return;
  Warning warning{"left out: " + counted(without, "line", "lines") + " without " + heights.source,
                  {}};
  warning.where.line = first;
  warnings.push_back(std::move(warning));
}

Result<Drawing> read_geojson(const Source& source, const ReadOptions& options) {
  Result<GeoContents> contents = scan_geojson(source.bytes, source.name);
  if (!contents) return contents.error();
  Drawing drawing;
  drawing.exact_heights = true;
  // Polygons, which writers close along frames and cut from cells, touch and fold back.
  drawing.may_touch = contents->polygons > 0;
  warn_of_left_out(*contents, drawing.warnings);
  warn_of_coordinates(*contents, drawing.warnings);
  const Result<GeoHeights> heights = find_heights(*contents, options.property);
  if (heights) {
    take_heights(*contents, *heights, drawing.warnings);
    if (heights->bands) {
      drawing.prepare = [](Drawing& all) {
        return unite_bands(all.structures.front().lines, all.warnings);
      };
    }
  } else {
    if (!options.property.empty()) return heights.error();
    // The lines can be counted all the same.
    for (DrawnLine& line : contents->lines) line.left_out = true;
    Warning warning{heights.error().message, {}};
    drawing.warnings.push_back(warning);
    drawing.prepare = [error = heights.error()](Drawing&) -> Result<void> { return error; };
  }
  drawing.structures.push_back({0, {}, std::move(contents->lines)});
  return drawing;
}

}  // namespace

extern constinit const Format geojson_format{
    .name = "geojson",
    .summary = "GeoJSON level lines and bands",
    .extensions = {".geojson", ".json", ".geojsonl", ".geojsons"},
    .recognise = is_json_object,
    .read_drawing = read_geojson,
    .write_stack = write_geojson};

}  // namespace tetloft::internal::io
