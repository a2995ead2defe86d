// Scanning GeoJSON without recursion: objects that are open stand on a stack, and members may come
// in any order, so that what an object is may be known only where it ends.
#include "io/drawing/geojson_scan.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "io/drawing/range_text.hpp"
#include "io/json_scan.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

enum class GeoType : std::uint8_t {
  unknown,
  point,
  multi_point,
  line_string,
  multi_line_string,
  polygon,
  multi_polygon,
  geometry_collection,
  feature,
  feature_collection,
};

struct GeoTypeRow {
  std::string_view name;
  GeoType type;
  int nesting = 0;  // of its coordinates: 1 a position
};
constexpr std::array<GeoTypeRow, 9> kGeoTypes{{{"Point", GeoType::point, 1},
                                               {"MultiPoint", GeoType::multi_point, 2},
                                               {"LineString", GeoType::line_string, 2},
                                               {"MultiLineString", GeoType::multi_line_string, 3},
                                               {"Polygon", GeoType::polygon, 3},
                                               {"MultiPolygon", GeoType::multi_polygon, 4},
                                               {"GeometryCollection", GeoType::geometry_collection},
                                               {"Feature", GeoType::feature},
                                               {"FeatureCollection", GeoType::feature_collection}}};
constexpr int kDeepestCoordinates = 4;

const GeoTypeRow* row_of(GeoType type) {
  for (const GeoTypeRow& row : kGeoTypes) {
    if (row.type == type) return &row;
  }
  return nullptr;
}

// An object that is not closed yet.
struct OpenObject {
  GeoType type = GeoType::unknown;
  std::size_t line = 0;
  std::size_t first_line = 0;  // of the contents
  std::optional<int> nesting;  // of its coordinates, where it has any; 0: empty
  bool in_array = false;       // within its "features" or "geometries"
  bool has_children = false;   // it has such an array, or a "geometry"
  bool null_geometry = false;
  std::vector<GeoProperty> properties;
};

class GeoScanner {
 public:
  GeoScanner(std::string_view bytes, const std::string& name) : json_(bytes, name) {}

  Result<GeoContents> scan() {
    for (;;) {
      const Result<JsonEvent> event = json_.next();
      if (!event) return event.error();
      if (event->kind == JsonKind::end) break;
      if (Result<void> taken = take(*event); !taken) return taken.error();
    }
    if (!seen_object_) return json_.complain("the file holds no GeoJSON object", 1);
    return std::move(contents_);
  }

 private:
  Result<void> take(const JsonEvent& event) {
    const bool elements = open_.empty() || open_.back().in_array;
    if (elements && event.kind == JsonKind::open_object) {
      push(event.line);
      return {};
    }
    if (open_.empty()) return json_.complain("GeoJSON is an object", event.line);
    OpenObject& object = open_.back();
    if (object.in_array) {
      if (event.kind == JsonKind::close_array) {
        object.in_array = false;
        return {};
      }
      if (event.kind == JsonKind::null) return {};
      return json_.complain("an object is due here", event.line);
    }
    if (event.kind == JsonKind::close_object) return close();
    return take_member(object, event);
  }

  void push(std::size_t line) {
    seen_object_ = true;
    OpenObject object;
    object.line = line;
    object.first_line = contents_.lines.size();
    open_.push_back(std::move(object));
  }

  Result<void> take_member(OpenObject& object, const JsonEvent& key) {
    const Result<JsonEvent> value = json_.next();
    if (!value) return value.error();
    if (key.text == "type") return take_type(object, *value);
    if (key.text == "coordinates" && value->kind == JsonKind::open_array) {
      return take_coordinates(object, *value);
    }
    const bool collection = key.text == "features" || key.text == "geometries";
    if (collection && value->kind == JsonKind::open_array) {
      object.has_children = object.in_array = true;
      return check_children(object);
    }
    if (key.text == "geometry" && value->kind == JsonKind::open_object) {
      object.has_children = true;
      if (Result<void> fits = check_children(object); !fits) return fits;
      push(value->line);
      return {};
    }
    if (key.text == "geometry" && value->kind == JsonKind::null) object.null_geometry = true;
    if (key.text == "properties" && value->kind == JsonKind::open_object) {
      return take_properties(object);
    }
    if (key.text == "crs" && value->kind == JsonKind::open_object) return take_crs();
    if (key.text != "id") add_property(object, key.text, *value);
    return json_.skip(*value);
  }

  Result<void> take_type(OpenObject& object, const JsonEvent& value) {
    if (value.kind != JsonKind::string) {
      return json_.complain("the type of a GeoJSON object is no text", value.line);
    }
    for (const GeoTypeRow& row : kGeoTypes) {
      if (value.text == row.name) object.type = row.type;
    }
    if (object.type != GeoType::unknown) return {};
    return json_.complain(in_quotes(value.text) + " is no type of GeoJSON" +
                              (value.text == "Topology" ? ": convert TopoJSON to GeoJSON" : ""),
                          value.line);
  }

  Result<void> check_children(const OpenObject& object) {
    if (!object.nesting) return {};
    return json_.complain("an object has both coordinates and parts", object.line);
  }

  void add_property(OpenObject& object, const std::string& name, const JsonEvent& value) {
    GeoProperty property;
    if (value.kind == JsonKind::number && value.finite) {
      property.low = property.high = value.number;
    } else if (value.kind == JsonKind::string) {
      const std::optional<TextRange> range = parse_range(value.text);
      if (!range) return;
      property.low = range->low;
      property.high = range->high;
      property.range = range->is_range;
    } else {
      return;
    }
    const auto known = name_ids_.emplace(name, static_cast<std::uint32_t>(name_ids_.size()));
    if (known.second) contents_.names.push_back(name);
    property.name = known.first->second;
    object.properties.push_back(property);
  }

  Result<void> take_properties(OpenObject& object) {
    for (;;) {
      const Result<JsonEvent> key = json_.next();
      if (!key) return key.error();
      if (key->kind == JsonKind::close_object) return {};
      const Result<JsonEvent> value = json_.next();
      if (!value) return value.error();
      add_property(object, key->text, *value);
      if (Result<void> passed = json_.skip(*value); !passed) return passed;
    }
  }

  // "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::4269"}}
  Result<void> take_crs() {
    bool named = false;
    for (const std::size_t outside = json_.depth() - 1; json_.depth() > outside;) {
      const Result<JsonEvent> event = json_.next();
      if (!event) return event.error();
      if (named && event->kind == JsonKind::string) contents_.crs = event->text;
      named = event->kind == JsonKind::key &&
              (event->text == "name" || event->text == "code" || event->text == "href");
    }
    return {};
  }

  // Arrays in arrays: what each holds is told by what its first element is.
  Result<void> take_coordinates(OpenObject& object, const JsonEvent& from) {
    if (object.nesting || object.has_children) {
      return json_.complain("an object has coordinates twice, or beside parts", from.line);
    }
    std::vector<int> holds(1, 0);  // of each array that is open: 0 nothing yet, 1 numbers, …
    std::array<double, 3> position{};
    std::size_t numbers = 0;
    line_ = {};
    line_.line = from.line;
    line_height_ = GeoHeight::constant;
    int nesting = 0;
    while (!holds.empty()) {
      const Result<JsonEvent> event = json_.next();
      if (!event) return event.error();
      if (event->kind == JsonKind::open_array) {
        if (holds.back() == 1 || holds.size() == kDeepestCoordinates) return malformed(*event);
        holds.push_back(0);
        numbers = 0;
        if (line_.points.empty()) line_.line = event->line;
      } else if (event->kind == JsonKind::number) {
        if (holds.back() > 1) return malformed(*event);
        if (!event->finite) return json_.complain("a coordinate is too large", event->line);
        holds.back() = 1;
        if (numbers < 3) position[numbers] = event->number;
        ++numbers;
      } else if (event->kind == JsonKind::close_array) {
        nesting = holds.back();
        holds.pop_back();
        if (nesting == 1) {
          if (numbers < 2) return malformed(*event);
          add_position({position[0], position[1], numbers > 2 ? position[2] : 0}, numbers > 2);
        }
        if (nesting == 2) finish_line();
        if (holds.empty() || nesting == 0) continue;
        if (holds.back() != 0 && holds.back() != nesting + 1) return malformed(*event);
        holds.back() = nesting + 1;
      } else {
        return malformed(*event);
      }
    }
    object.nesting = nesting;
    return {};
  }

  Error malformed(const JsonEvent& event) const {
    return json_.complain("coordinates are arrays of positions, of two numbers or more each",
                          event.line);
  }

  void add_position(const Point3& p, bool has_z) {
    if (!has_z) line_height_ = GeoHeight::none;
    if (line_height_ == GeoHeight::constant && !line_.points.empty() &&
        p.z != line_.points.front().z) {
      line_height_ = GeoHeight::varying;
    }
    line_.points.push_back(p);
  }

  void finish_line() {
    line_.points.shrink_to_fit();
    contents_.lines.push_back(std::move(line_));
    contents_.height.push_back(line_height_);
    line_ = {};
    line_height_ = GeoHeight::constant;
  }

  Result<void> close() {
    OpenObject object = std::move(open_.back());
    open_.pop_back();
    if (object.type == GeoType::unknown) {
      return json_.complain("an object of GeoJSON has no type", object.line);
    }
    if (object.nesting) {
      if (Result<void> fits = settle_geometry(object); !fits) return fits;
    }
    if (object.null_geometry) ++contents_.without_geometry;
    const bool keeps = object.type != GeoType::feature_collection && !object.properties.empty();
    if (keeps && contents_.lines.size() > object.first_line) {
      const std::size_t first = contents_.properties.size();
      contents_.properties.insert(contents_.properties.end(), object.properties.begin(),
                                  object.properties.end());
      contents_.holders.push_back(
          {object.first_line, contents_.lines.size(), first, contents_.properties.size()});
    }
    return {};
  }

  // The type tells what the coordinates are: the lines that were found are rings, or lines, or
  // no lines.
  Result<void> settle_geometry(const OpenObject& object) {
    const GeoTypeRow& row = *row_of(object.type);
    if (*object.nesting != 0 && *object.nesting != row.nesting) {
      return json_.complain("the coordinates are not those of a " + std::string(row.name),
                            object.line);
    }
    if (*object.nesting == 0) ++contents_.empty;
    const std::size_t first = object.first_line;
    if (object.type == GeoType::point) contents_.points += *object.nesting == 0 ? 0U : 1U;
    if (object.type == GeoType::multi_point) {
      for (std::size_t i = first; i < contents_.lines.size(); ++i) {
        contents_.points += contents_.lines[i].points.size();
      }
      contents_.lines.resize(first);
      contents_.height.resize(first);
    }
    const bool rings = object.type == GeoType::polygon || object.type == GeoType::multi_polygon;
    for (std::size_t i = first; i < contents_.lines.size(); ++i) {
      DrawnLine& line = contents_.lines[i];
      const bool returns = line.points.size() > 1 && line.points.front() == line.points.back();
      line.kind = rings || returns ? LineKind::closed : LineKind::open;
    }
    if (rings) contents_.polygons += contents_.lines.size() - first;
    return {};
  }

  JsonScanner json_;
  GeoContents contents_;
  std::vector<OpenObject> open_;
  std::map<std::string, std::uint32_t> name_ids_;
  DrawnLine line_;  // the one that is read
  GeoHeight line_height_ = GeoHeight::constant;
  bool seen_object_ = false;
};

}  // namespace

Result<GeoContents> scan_geojson(std::string_view bytes, const std::string& name) {
  return GeoScanner(bytes, name).scan();
}

}  // namespace tetloft::internal::io
