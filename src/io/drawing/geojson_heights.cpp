#include "io/drawing/geojson_heights.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// By lower case, without blanks, '-' and '_'.
constexpr std::array<std::string_view, 17> kElevations{
    "elev",    "elevation",        "elevations", "ele",      "height", "z",
    "zvalue",  "zcoord",           "alt",        "altitude", "hoehe",  "h",
    "contour", "contourelevation", "contourele", "cota",     "quota"};
constexpr std::array<std::string_view, 12> kLevels{
    "level",      "value", "val",   "isovalue",   "isoline", "contourvalue",
    "levelvalue", "depth", "tiefe", "bathymetry", "title",   "threshold"};
// Ends of names, by the lower or upper bound of a band.
constexpr std::array<std::array<std::string_view, 2>, 4> kBounds{
    {{"min", "max"}, {"lower", "upper"}, {"low", "high"}, {"from", "to"}}};
// What numbers, styles and measures: simplestyle, shapefiles, OpenStreetMap.
constexpr std::array<std::string_view, 40> kDecoys{
    "strokewidth", "strokeopacity", "fillopacity", "opacity",     "markersize", "linewidth",
    "width",       "weight",        "zindex",      "id",          "fid",        "gid",
    "oid",         "uid",           "objectid",    "ogcfid",      "featureid",  "featureidn",
    "pk",          "index",         "idx",         "number",      "num",        "no",
    "nr",          "count",         "order",       "rank",        "type",       "code",
    "class",       "length",        "len",         "shapelength", "shapeleng",  "shapelen",
    "area",        "shapearea",     "perimeter",   "year"};

std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == ' ' || c == '_' || c == '-') continue;
    text += lower_case(c);
  }
  return text;
}

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// With the unit behind it, too: "elev_m", "contour_ft".
bool means_elevation(std::string_view name) {
  if (has(kElevations, name)) return true;
  for (const std::string_view unit : {"feet", "meters", "metres", "ft", "m"}) {
    if (name.ends_with(unit) && has(kElevations, name.substr(0, name.size() - unit.size()))) {
      return true;
    }
  }
  return false;
}

// "…_id" numbers things, too.
bool is_decoy(const std::string& name) {
  const std::string text = plain(name);
  if (has(kDecoys, text)) return true;
  const std::size_t n = name.size();
  if (n < 3) return false;
  const std::string end = plain(name.substr(n - 2));
  return end == "id" && (name[n - 3] == '_' || name[n - 3] == '-' || name.substr(n - 2) == "Id" ||
                         name.substr(n - 2) == "ID");
}

using Values = std::vector<std::optional<double>>;

// Holders within others stand before them: what is inside says more.
template <class Take>
void for_each_value(const GeoContents& contents, std::uint32_t name, Take&& take) {
  for (std::size_t h = contents.holders.size(); h-- > 0;) {
    const GeoHolder& holder = contents.holders[h];
    for (std::size_t p = holder.first_property; p < holder.end_property; ++p) {
      if (contents.properties[p].name == name) take(holder, contents.properties[p]);
    }
  }
}

struct Column {
  Values low;
  Values high;
  bool ranges = false;
};

Column column_of(const GeoContents& contents, std::uint32_t name) {
  Column column;
  column.low.resize(contents.lines.size());
  column.high.resize(contents.lines.size());
  for_each_value(contents, name, [&](const GeoHolder& holder, const GeoProperty& property) {
    column.ranges = column.ranges || property.range;
    for (std::size_t i = holder.first_line; i < holder.end_line; ++i) {
      column.low[i] = property.low;
      column.high[i] = property.high;
    }
  });
  return column;
}

// What all properties of a name have in common.
struct Spread {
  std::size_t count = 0;
  double least = 0;
  double largest = 0;
  [[nodiscard]] bool varies() const { return least < largest; }
};

std::vector<Spread> spreads_of(const GeoContents& contents) {
  std::vector<Spread> spreads(contents.names.size());
  for (const GeoProperty& property : contents.properties) {
    Spread& spread = spreads[property.name];
    if (spread.count++ == 0) spread.least = spread.largest = property.low;
    spread.least = std::min(spread.least, property.low);
    spread.largest = std::max(spread.largest, property.low);
  }
  return spreads;
}

class HeightFinder {
 public:
  explicit HeightFinder(const GeoContents& contents)
      : contents_(contents), spreads_(spreads_of(contents)) {}

  Result<GeoHeights> find(const std::string& asked) {
    if (!asked.empty()) return named(asked);
    if (auto band = elevation_band()) return *std::move(band);
    for (const bool elevation : {true, false}) {
      std::vector<std::uint32_t> known;
      for (std::uint32_t n = 0; n < contents_.names.size(); ++n) {
        const std::string name = plain(contents_.names[n]);
        if (elevation ? means_elevation(name) : has(kLevels, name)) known.push_back(n);
      }
      if (known.empty()) continue;
      if (agree(known)) return by_name(known.front());
      return ambiguous(known);
    }
    if (coordinates_tell(true)) return by_coordinates();
    std::vector<std::uint32_t> others = candidates(true);
    if (others.empty()) others = candidates(false);
    if (others.size() == 1) return by_name(others.front());
    if (others.size() > 1 && !agree(others)) return ambiguous(others);
    if (!others.empty()) return by_name(others.front());
    if (coordinates_tell(false)) return by_coordinates();
    return nothing();
  }

 private:
  std::vector<std::uint32_t> candidates(bool varying) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = 0; n < contents_.names.size(); ++n) {
      if (is_decoy(contents_.names[n])) continue;
      if (varying && !spreads_[n].varies()) continue;
      found.push_back(n);
    }
    return found;
  }

  Result<GeoHeights> named(const std::string& asked) {
    std::vector<std::uint32_t> fit;
    for (std::uint32_t n = 0; n < contents_.names.size(); ++n) {
      if (contents_.names[n] == asked) return by_name(n);
      if (plain(contents_.names[n]) == plain(asked)) fit.push_back(n);
    }
    if (fit.size() == 1) return by_name(fit.front());
    const std::vector<std::string_view> names(contents_.names.begin(), contents_.names.end());
    return Error{ErrorCode::usage,
                 "no property " + in_quotes(asked) + " holds numbers" + did_you_mean(asked, names) +
                     "; " + listed(),
                 {}};
  }

  // "elev_min" and "elev_max", "min" and "max", …: the elevation's first.
  std::optional<GeoHeights> elevation_band() {
    std::map<std::string, std::uint32_t> by_plain;
    for (std::uint32_t n = 0; n < contents_.names.size(); ++n) {
      by_plain.emplace(plain(contents_.names[n]), n);
    }
    std::size_t tried = 0;
    for (const bool elevation : {true, false}) {
      for (std::uint32_t n = 0; n < contents_.names.size(); ++n) {
        const std::string name = plain(contents_.names[n]);
        for (const auto& [low, high] : kBounds) {
          if (!name.ends_with(low)) continue;
          const std::string stem = name.substr(0, name.size() - low.size());
          if ((means_elevation(stem) || has(kLevels, stem) || stem == "a") != elevation) continue;
          const auto other = by_plain.find(stem + std::string(high));
          if (other == by_plain.end() || ++tried > kMostCompared) continue;
          if (auto band = band_of(n, other->second)) return band;
        }
      }
    }
    return std::nullopt;
  }

  std::optional<GeoHeights> band_of(std::uint32_t low, std::uint32_t high) {
    GeoHeights heights;
    heights.of = column_of(contents_, low).low;
    const Values upper = column_of(contents_, high).low;
    for (std::size_t i = 0; i < upper.size(); ++i) {
      if (heights.of[i].has_value() != upper[i].has_value()) return std::nullopt;
      if (upper[i] && !(*heights.of[i] <= *upper[i])) return std::nullopt;
    }
    heights.bands = true;
    heights.source = "the properties " + in_quotes(contents_.names[low]) + " and " +
                     in_quotes(contents_.names[high]);
    return heights;
  }

  // All the same on every line. A few names at most: those that mean something, or the
  // candidates of which a message names some.
  bool agree(const std::vector<std::uint32_t>& names) const {
    if (names.size() > kMostCompared) return false;
    const Column first = column_of(contents_, names.front());
    return std::all_of(names.begin() + 1, names.end(), [&](std::uint32_t n) {
      const Column other = column_of(contents_, n);
      return other.low == first.low && other.high == first.high;
    });
  }

  Result<GeoHeights> by_name(std::uint32_t name) {
    Column column = column_of(contents_, name);
    const std::string text = plain(contents_.names[name]);
    GeoHeights heights{"the property " + in_quotes(contents_.names[name]), column.ranges,
                       std::move(column.low)};
    // Of a band that is named by its lower bound alone.
    for (const auto& bounds : kBounds) {
      const std::string_view low = bounds[0];
      if (low != "low" && text.size() > low.size() && text.ends_with(low)) heights.bands = true;
    }
    return heights;
  }

  // Whether third coordinates are there, constant along each line (and different between them).
  bool coordinates_tell(bool different) const {
    if (contents_.lines.empty()) return false;
    bool varies = false;
    for (std::size_t i = 0; i < contents_.lines.size(); ++i) {
      if (contents_.height[i] != GeoHeight::constant) return false;
      varies = varies || contents_.lines[i].points[0].z != contents_.lines[0].points[0].z;
    }
    return varies || !different;
  }

  Result<GeoHeights> by_coordinates() const {
    GeoHeights heights;
    heights.source = "the third coordinates";
    for (const DrawnLine& line : contents_.lines) heights.of.emplace_back(line.points.front().z);
    return heights;
  }

  Error ambiguous(const std::vector<std::uint32_t>& names) const {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < names.size() && i < kMostCompared; ++i) {
      texts.push_back(in_quotes(contents_.names[names[i]]));
    }
    return {ErrorCode::usage,
            "several properties may be the height of the lines: " +
                list_of({texts.begin(), texts.end()}) +
                (names.size() > kMostCompared ? " and more" : "") +
                "; say which with --property NAME",
            {}};
  }

  Error nothing() const {
    const bool varying = std::any_of(contents_.height.begin(), contents_.height.end(),
                                     [](GeoHeight height) { return height == GeoHeight::varying; });
    return {ErrorCode::invalid_input,
            "nothing tells the heights of the lines: no property that means one, " +
                std::string(varying ? "and third coordinates vary along lines"
                                    : "and no third coordinates") +
                "; " + listed() + "; if one of them is the height, say so with --property NAME",
            {}};
  }

  std::string listed() const {
    std::vector<std::string> texts;
    for (std::size_t n = 0; n < contents_.names.size() && n < kMostCompared; ++n) {
      texts.push_back(in_quotes(contents_.names[n]));
    }
    if (texts.empty()) return "the file has no properties that hold numbers";
    return "properties that hold numbers: " + list_of({texts.begin(), texts.end()}) +
           (contents_.names.size() > kMostCompared ? " and more" : "");
  }

  static constexpr std::size_t kMostCompared = 20;

  const GeoContents& contents_;
  std::vector<Spread> spreads_;
};

}  // namespace

Result<GeoHeights> find_heights(const GeoContents& contents, const std::string& asked) {
  return HeightFinder(contents).find(asked);
}

}  // namespace tetloft::internal::io
