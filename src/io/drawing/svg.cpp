// Layered SVG, as slicers and drawing programs write it: a group a section, its height in an
// attribute or its name; shapes in it are contours.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/cursor.hpp"
#include "io/drawing/ellipse.hpp"
#include "io/drawing/range_text.hpp"
#include "io/drawing/svg_shapes.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

namespace {

// Slic3r writes slic3r:z in units of a millionth: 2.25e-06 of a layer at 2.25 mm. No layer is a
// micrometre high, and no print a kilometre.
constexpr std::string_view kSlicerHeight = "slic3r:z";
constexpr double kScaledBelow = 1e-3;

// The decimal point six places to the right, so that 2.25e-06 is 2.25 and no neighbour of it.
std::optional<double> a_million_times(const std::string& text) {
  const std::size_t e = std::min(text.find('e'), text.find('E'));
  const auto exponent =
      e == std::string::npos ? std::optional<std::int64_t>(0) : parse_integer(text.substr(e + 1));
  if (!exponent || *exponent > 1000) return std::nullopt;
  const ParsedNumber number = parse_number(text.substr(0, e) + 'e' + std::to_string(*exponent + 6));
  return number.ok() ? std::optional<double>(number.value) : std::nullopt;
}

// "z=1.25", "layer 3 z 0.6", "Z: -2 mm"; of a layer's label also the number alone.
std::optional<double> height_in(std::string_view text, bool alone) {
  if (const auto number = parse_range(text); alone && number && !number->is_range) {
    return number->low;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != 'z' && text[i] != 'Z') continue;
    if (i > 0 && is_letter(text[i - 1])) continue;
    std::string_view rest = text.substr(i + 1);
    while (!rest.empty() && (is_white(rest.front()) || rest.front() == '=' || rest.front() == ':' ||
                             rest.front() == '_')) {
      rest.remove_prefix(1);
    }
    std::size_t length = 0;
    while (length < rest.size() &&
           (std::string_view("+-.0123456789").find(rest[length]) != std::string_view::npos)) {
      ++length;
    }
    if (const ParsedNumber number = parse_number(rest.substr(0, length)); number.ok()) {
      return number.value;
    }
  }
  return std::nullopt;
}

bool is_hidden(const XmlTag& tag) {
  const std::string* const display = tag.find("display");
  if (display != nullptr && *display == "none") return true;
  const std::string* const style = tag.find("style");
  if (style == nullptr) return false;
  std::string packed;
  for (const char c : *style) {
    if (!is_white(c)) packed += c;
  }
  return packed.find("display:none") != std::string::npos;
}

// The name without a prefix of its namespace.
std::string_view local(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// What stands here is drawn elsewhere, or not at all.
bool is_no_drawing(std::string_view name) {
  for (const std::string_view none : {"defs", "clipPath", "mask", "symbol", "marker", "pattern",
                                      "metadata", "text", "style", "script", "namedview"}) {
    if (name == none) return true;
  }
  return false;
}

bool is_svg(std::string_view bytes) {
  TextCursor cursor(bytes);
  cursor.skip_white();
  if (cursor.peek() != '<') return false;
  const std::string_view beginning = bytes.substr(0, 4096);
  return beginning.find("<svg") != std::string_view::npos ||
         beginning.find(":svg ") != std::string_view::npos;
}

class SvgReader {
 public:
  SvgReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes),
        scanner_(bytes, name),
        budget_(bytes.size() / 2 + 4096),
        most_lines_(bytes.size() / 10 + 1000) {}

  Result<Drawing> read() {
    for (;;) {
      const Result<XmlTag> tag = scanner_.next_tag();
      if (!tag) return tag.error();
      if (tag->kind == XmlTag::Kind::end_of_file) break;
      Result<void> taken;
      if (tag->kind == XmlTag::Kind::close) {
        taken = close(*tag);
      } else {
        taken = open(*tag);
      }
      if (!taken) return taken.error();
    }
    if (!open_.empty()) {
      return scanner_.complain(bytes_.size(),
                               "the file ends inside of " +
                                   in_quotes('<' + std::string(open_.back().name) + '>') +
                                   ": its end is missing");
    }
    if (Result<void> settled = settle_heights(); !settled) return settled.error();
    tell();
    drawing_.exact_heights = true;
    drawing_.may_touch = true;
    drawing_.structures.push_back({0, {}, std::move(lines_)});
    return std::move(drawing_);
  }

 private:
  struct OpenElement {
    std::string_view name;
    SvgTransform transform;
    std::size_t layer = 0;  // position in layers_, one-based; 0: outside of any
    bool drawn = true;
  };
  struct Layer {
    double height = 0;
    std::optional<double> scaled;  // what slic3r:z is in millionths
  };

  Result<void> close(const XmlTag& tag) {
    if (open_.empty() || open_.back().name != tag.name) {
      return scanner_.complain_of_close(tag);
    }
    open_.pop_back();
    return {};
  }

  Result<void> open(const XmlTag& tag) {
    if (open_.size() >= kDeepest) {
      return scanner_.complain(
          tag.position, "the tags are nested more than " + std::to_string(kDeepest) + " deep");
    }
    OpenElement element;
    if (!open_.empty()) element = open_.back();
    element.name = tag.name;
    const std::string_view name = local(tag.name);
    if (open_.empty() && name != "svg") return scanner_.complain(tag.position, "this is no SVG");
    element.drawn = element.drawn && !is_no_drawing(name);
    if (element.drawn && is_hidden(tag)) {
      element.drawn = false;
      ++hidden_;
    }
    if (element.drawn) {
      if (const std::string* text = tag.find("transform")) {
        const auto transform = svg_transform(*text);
        if (!transform) {
          return scanner_.complain(tag.position,
                                   "the transform " + in_quotes(*text) +
                                       " is not read (translate, scale, matrix, and rotate by "
                                       "quarter turns are)");
        }
        element.transform = element.transform.after(*transform);
      }
      if (name == "g") {
        if (Result<void> found = find_height(tag, element); !found) return found;
      }
      if (Result<void> taken = take_shape(tag, name, element); !taken) return taken;
    }
    if (tag.kind == XmlTag::Kind::open) open_.push_back(std::move(element));
    return {};
  }

  Result<void> find_height(const XmlTag& tag, OpenElement& element) {
    Layer layer;
    std::optional<double> height;
    for (const auto& [key, value] : tag.attributes) {
      const bool slicer = key == kSlicerHeight;
      if (!slicer && local(key) != "z" && key != "data-z") continue;
      const ParsedNumber number = parse_number(value);
      if (!number.ok()) {
        return scanner_.complain(tag.position,
                                 "the height of the layer: " + complaint(value, number.status));
      }
      height = number.value;
      if (slicer) layer.scaled = a_million_times(value);
      if (slicer) break;
    }
    for (const char* key : {"inkscape:label", "label", "id"}) {
      const std::string* const text = tag.find(key);
      if (!height && text != nullptr) height = height_in(*text, std::string_view(key) != "id");
    }
    if (!height) return {};
    layer.height = *height;
    layers_.push_back(layer);
    element.layer = layers_.size();
    return {};
  }

  Result<void> take_shape(const XmlTag& tag, std::string_view name, const OpenElement& element) {
    SvgLines shape;
    if (name == "polygon" || name == "polyline") {
      shape = points_of(tag, name == "polygon");
    } else if (name == "path") {
      const std::string* const data = tag.find("d");
      if (data != nullptr) shape = svg_path(*data, budget_);
    } else if (name == "rect" || name == "circle" || name == "ellipse" || name == "line") {
      shape = simple_shape(tag, name);
    } else {
      if (name == "use" || name == "image") ++left_out_[std::string(name)];
      return {};
    }
    if (!shape.problem.empty()) {
      return scanner_.complain(tag.position, shape.problem + " (in " + place_of(element) + ')');
    }
    curves_ += shape.curves;
    budget_ -= std::min(budget_, shape.curve_points);
    if (shape.lines.empty()) return {};
    if (element.layer == 0) return without_height(tag);
    const std::string* const type = tag.find("slic3r:type");
    if (lines_.size() + shape.lines.size() > most_lines_) {
      return scanner_.complain(tag.position, "the file has more lines than a few bytes each allow");
    }
    for (SvgLine& line : shape.lines) {
      add_line(std::move(line), tag, element, type != nullptr ? *type : std::string());
    }
    return {};
  }

  void add_line(SvgLine line, const XmlTag& tag, const OpenElement& element,
                const std::string& type) {
    DrawnLine drawn;
    for (; counted_ < tag.position; ++counted_) line_ += bytes_[counted_] == '\n' ? 1U : 0U;
    drawn.line = line_;
    drawn.type = type;
    const bool returns = line.points.size() > 2 && line.points.front() == line.points.back();
    drawn.kind = line.closed || returns ? LineKind::closed : LineKind::open;
    drawn.points.reserve(line.points.size());
    for (const Point2& p : line.points) {
      const Point2 q = element.transform.apply(p);
      drawn.points.push_back({q.x, q.y, 0});
    }
    lines_.push_back(std::move(drawn));
    layer_of_.push_back(element.layer - 1);
  }

  SvgLines points_of(const XmlTag& tag, bool closed) const {
    SvgLines shape;
    const std::string* const text = tag.find("points");
    if (text == nullptr) return shape;
    const auto numbers = svg_numbers(*text);
    if (!numbers || numbers->size() % 2 != 0) {
      shape.problem = numbers ? "an odd number of coordinates" : "points that are no numbers";
      return shape;
    }
    SvgLine line;
    line.closed = closed;
    for (std::size_t i = 0; i < numbers->size(); i += 2) {
      line.points.push_back({(*numbers)[i], (*numbers)[i + 1]});
    }
    if (!line.points.empty()) shape.lines.push_back(std::move(line));
    return shape;
  }

  SvgLines simple_shape(const XmlTag& tag, std::string_view name) const {
    SvgLines shape;
    const auto value = [&](std::string_view key) {
      const std::string* const text = tag.find(key);
      if (text == nullptr) return 0.0;
      const ParsedNumber number = parse_number(*text);
      if (!number.ok()) shape.problem = std::string(key) + ": " + complaint(*text, number.status);
      return number.value;
    };
    if (name == "line") {
      shape.lines.push_back({{{value("x1"), value("y1")}, {value("x2"), value("y2")}}, false});
      return shape;
    }
    if (name == "rect") {
      if (value("rx") > 0 || value("ry") > 0) shape.problem = "a rectangle with round corners";
      const double x = value("x"), y = value("y"), w = value("width"), h = value("height");
      if (w > 0 && h > 0) {
        shape.lines.push_back({{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true});
      }
      return shape;
    }
    const double rx = value(name == "circle" ? "r" : "rx");
    const double ry = value(name == "circle" ? "r" : "ry");
    if (rx > 0 && ry > 0) {
      shape.lines.push_back({ellipse_points({value("cx"), value("cy")}, rx, ry), true});
      shape.curves = 1;
      shape.curve_points = shape.lines.back().points.size();
      if (shape.curve_points > budget_) shape.problem = "more curves than can be turned into lines";
    }
    return shape;
  }

  std::string place_of(const OpenElement& element) const {
    if (element.layer == 0) return "no layer";
    std::string text = "the layer at z ";
    append_number(text, layers_[element.layer - 1].height);
    return text;
  }

  Result<void> without_height(const XmlTag& tag) {
    if (without_++ == 0) first_without_ = tag.position;
    return {};
  }

  // In millionths if all heights of Slic3r are so small.
  Result<void> settle_heights() {
    if (layers_.empty() && without_ > 0) {
      return scanner_.complain(
          first_without_,
          "no group tells the height of its shapes: looked for are the attributes slic3r:z, z and "
          "data-z of a <g>, and \"z=NUMBER\" in its inkscape:label or id");
    }
    bool scaled = false;
    double largest = 0;
    for (const Layer& layer : layers_) {
      scaled = scaled || layer.scaled;
      largest = std::max(largest, std::abs(layer.height));
    }
    scaled = scaled && largest < kScaledBelow;
    std::vector<double> heights;
    for (const Layer& layer : layers_) {
      heights.push_back(scaled && layer.scaled ? *layer.scaled : layer.height);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (Point3& p : lines_[i].points) {
        p.z = heights[layer_of_[i]];
        if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
        Error error = scanner_.complain(0, "a coordinate is too large");
        error.where.line = lines_[i].line;
        return error;
      }
    }
    slicer_ = std::any_of(layers_.begin(), layers_.end(),
                          [](const Layer& layer) { return layer.scaled.has_value(); });
    if (slicer_) drawing_.unit = "mm";
    return {};
  }

  void tell() {
    const auto warn = [&](const std::string& message) {
      drawing_.warnings.push_back({message, {}});
    };
    if (without_ > 0) {
      Warning warning{"left out: " + std::to_string(without_) +
                          (without_ == 1 ? " shape" : " shapes") + " outside of any layer",
                      {}};
      warning.where.line = scanner_.complain(first_without_, {}).where.line;
      drawing_.warnings.push_back(std::move(warning));
    }
    if (hidden_ > 0) warn("left out: " + std::to_string(hidden_) + " hidden elements");
    for (const auto& [name, count] : left_out_) {
      warn("left out: " + std::to_string(count) + " elements <" + name + '>');
    }
    if (curves_ > 0) {
      warn(std::to_string(curves_) + (curves_ == 1 ? " curve is" : " curves are") +
           " made of line segments, 16 or fewer for each (64 for ellipses): off by about 1/500 of "
           "its extent");
    }
    if (!slicer_ && !lines_.empty()) {
      warn(
          "y is taken as it stands, which SVG draws downwards: the solid is the mirror image of "
          "what is seen");
    }
  }

  std::string_view bytes_;
  XmlScanner scanner_;
  std::vector<OpenElement> open_;
  std::vector<Layer> layers_;
  std::vector<DrawnLine> lines_;
  std::vector<std::size_t> layer_of_;  // by line
  Drawing drawing_;
  std::map<std::string, std::size_t> left_out_;
  std::size_t without_ = 0;  // shapes in no layer
  std::size_t first_without_ = 0;
  std::size_t hidden_ = 0;
  std::size_t curves_ = 0;
  // What a file can hold is bounded by its size.
  static constexpr std::size_t kDeepest = 256;
  std::size_t budget_;  // points of curves
  std::size_t most_lines_;
  std::size_t counted_ = 0;
  std::size_t line_ = 1;  // of byte counted_
  bool slicer_ = false;
};

Result<Drawing> read_svg(const Source& source, const ReadOptions& /*options*/) {
  return SvgReader(source.bytes, source.name).read();
}

}  // namespace

extern constinit const Format svg_format{.name = "svg",
                                         .summary = "layered SVG of slicers",
                                         .extensions = {".svg"},
                                         .recognise = is_svg,
                                         .read_drawing = read_svg};

}  // namespace tetloft::internal::io
