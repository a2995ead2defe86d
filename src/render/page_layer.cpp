#include "render/page_layer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/text.hpp"
#include "io/base64.hpp"
#include "io/bytes/deflate.hpp"
#include "render/page_json.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::render {

namespace {

// The least e for which the numbers are below 2^e in magnitude; of zeros, the least of all.
int binary_exponent(const Point3& p) {
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = -2000;
  if (largest > 0 && std::isfinite(largest)) std::frexp(largest, &exponent);
  return exponent;
}

Point3 times_power(const Point3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

Point3 turned(const Frame& frame, const Point3& p) {
  return p.x * frame.axes[0] + p.y * frame.axes[1] + p.z * frame.axes[2];
}

// From the coordinates of a subject to those of its layer.
class OwnSpace {
 public:
  OwnSpace(const PageLayer& layer, const PageSpace& space)
      : centre_(0.5 * (layer.subject.low + layer.subject.high)),
        factor_(std::ldexp(1 / space.scale, layer.subject.exponent - space.exponent)) {}
  [[nodiscard]] const Point3& centre() const { return centre_; }
  [[nodiscard]] double length(double subject) const { return subject * factor_; }
  [[nodiscard]] float coordinate(double subject, int axis) const {
    return static_cast<float>((subject - render::coordinate(centre_, axis)) * factor_);
  }

 private:
  Point3 centre_;
  double factor_;
};

// An array as the viewer unpacks it: byte planes, which compress better, as a zlib stream in
// base64.
template <class T>
std::string packed(const std::vector<T>& values) {
  std::string planes(values.size() * sizeof(T), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(values[i]);
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      const std::size_t from = std::endian::native == std::endian::little ? k : sizeof(T) - 1 - k;
      planes[k * values.size() + i] = bytes[from];
    }
  }
  return io::encode_base64(io::zlib_compressed(planes));
}

class Arrays {
 public:
  Arrays(std::string& page, std::size_t number, const PageLayer& layer, const PageSpace& space,
         WatchedWork& work)
      : page_(page), number_(number), s_(layer.subject), own_(layer, space), work_(work) {}

  void append() {
    std::vector<float> floats;
    for (const Point3& p : s_.points) append_point(floats, p);
    add("points", floats);
    std::vector<std::uint32_t> words;
    for (const TetVertices& tet : s_.tets) {
      for (const VertexId v : tet) words.push_back(v.value());
    }
    add("tets", words);
    add("boundary", numbers_of(s_.boundary));
    add("walls", numbers_of(s_.walls));
    add("normals", normals());
    add("component", s_.component);
    std::vector<std::uint8_t> kinds;
    for (const TetKind kind : s_.kind) kinds.push_back(static_cast<std::uint8_t>(kind));
    add("kind", kinds);
    add("dihedral", dihedrals());
    add("evidence", s_.evidence);
    floats.clear();
    words.clear();
    for (const ContourPiece& piece : s_.contours) {
      append_point(floats, piece.a);
      append_point(floats, piece.b);
      words.push_back(piece.slab_below);
      words.push_back(piece.slab_above);
    }
    add("contours", floats);
    add("contour_slabs", words);
  }

 private:
  template <class T>
  void add(const char* what, const std::vector<T>& values) {
    page_ += "<script type=\"application/octet-stream\" id=\"array-" + std::to_string(number_) +
             '-' + what + "\">" + packed(values) + "</script>\n";
    work_.step_done_go_on();
  }
  void append_point(std::vector<float>& floats, const Point3& p) const {
    for (int axis = 0; axis < 3; ++axis) {
      floats.push_back(own_.coordinate(render::coordinate(p, axis), axis));
    }
  }
  static std::vector<std::uint32_t> numbers_of(const std::vector<HalfFaceId>& all) {
    std::vector<std::uint32_t> words;
    words.reserve(all.size());
    for (const HalfFaceId h : all) words.push_back(h.value());
    return words;
  }
  [[nodiscard]] std::vector<std::int8_t> normals() const {
    std::vector<std::int8_t> bytes;
    bytes.reserve(9 * s_.normals.size());
    for (const auto& corners : s_.normals) {
      for (const Point3& n : corners) {
        for (int axis = 0; axis < 3; ++axis) {
          bytes.push_back(static_cast<std::int8_t>(std::lround(127 * render::coordinate(n, axis))));
        }
      }
    }
    return bytes;
  }
  [[nodiscard]] std::vector<std::uint8_t> dihedrals() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(s_.dihedral.size());
    for (const float degrees : s_.dihedral) {
      bytes.push_back(static_cast<std::uint8_t>(
          std::lround(255 * std::min(1.0, static_cast<double>(degrees) / kBestDihedral))));
    }
    return bytes;
  }

  std::string& page_;
  std::size_t number_;
  const Subject& s_;
  OwnSpace own_;
  WatchedWork& work_;
};

std::size_t first_tet(const Subject& s, std::size_t slab) {
  const auto at = std::lower_bound(s.slab.begin(), s.slab.end(), static_cast<std::uint32_t>(slab));
  return static_cast<std::size_t>(at - s.slab.begin());
}

// By component, in the file's unit.
std::vector<double> volumes_of(const Subject& s, const Frame& frame, double stretch) {
  std::vector<double> volumes(s.component_count, 0);
  for (std::size_t t = 0; t < s.tets.size(); ++t) {
    std::array<Point3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = s.points[s.tets[t][i].index()];
    volumes[s.component[t]] += std::abs(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]))) / 6;
  }
  const double factor = volume_factor(frame) / stretch;
  for (double& volume : volumes) volume = std::ldexp(volume * factor, 3 * s.exponent);
  return volumes;
}

// Four columns of three numbers: what the axes become, and the origin.
void add_map(io::JsonWriter& json, const char* name, const std::array<Point3, 4>& columns) {
  json_list(json, name, 12,
            [&](std::size_t k) { return coordinate(columns[k / 3], static_cast<int>(k % 3)); });
}

void add_maps(io::JsonWriter& json, const PageLayer& layer, const PageSpace& space,
              double stretch) {
  const Frame& frame = layer.model->frame;
  const OwnSpace own(layer, space);
  const Point3 at = (1 / space.scale) * (layer.placed(own.centre(), space.exponent) - space.centre);
  add_map(json, "place", {frame.axes[0], frame.axes[1], frame.axes[2], at});
  const double unit = std::ldexp(space.scale, space.exponent);
  Point3 centre = own.centre();
  centre.z /= stretch;
  add_map(json, "file",
          {unit * frame.axes[0], unit * frame.axes[1], (unit / stretch) * frame.axes[2],
           place(frame, times_power(centre, layer.subject.exponent))});
  // What the stack calls z: at own height 0, and for each unit of it.
  const std::array stack_z{std::ldexp(centre.z, layer.subject.exponent), unit / stretch};
  json_list(json, "stackZ", 2, [&](std::size_t k) { return stack_z[k]; });
}

}  // namespace

int PageLayer::placed_exponent() const {
  int axes = -2000;
  for (const Point3& axis : model->frame.axes) axes = std::max(axes, binary_exponent(axis));
  // Three terms and the origin add up to less than four times the largest.
  return 2 + std::max(subject.exponent + axes, binary_exponent(model->frame.origin));
}

Point3 PageLayer::placed(const Point3& p, int exponent) const {
  return times_power(turned(model->frame, p), subject.exponent - exponent) +
         times_power(model->frame.origin, -exponent);
}

void add_page_layer_header(io::JsonWriter& json, const PageLayer& layer, const PageSpace& space,
                           double stretch) {
  const Subject& s = layer.subject;
  const OwnSpace own(layer, space);
  json.begin_object();
  json_text(json, "name", layer.name);
  add_maps(json, layer, space, stretch);
  json.member("gap", own.length(s.mean_gap));
  std::vector<ColourBy> colourings{ColourBy::component, ColourBy::slab};
  if (!s.kind.empty()) colourings.push_back(ColourBy::kind);
  colourings.push_back(ColourBy::dihedral);
  if (!s.evidence.empty()) colourings.push_back(ColourBy::evidence);
  json_list(json, "colourings", colourings.size(),
            [&](std::size_t k) { return name_of(colourings[k]); });
  json_list(json, "components", s.component_count, [&](std::size_t k) {
    return valid_utf8(component_name(*layer.model, ComponentId(s.component_number[k])));
  });
  const std::vector<double> volumes = volumes_of(s, layer.model->frame, stretch);
  json_list(json, "volumes", s.component_count, [&](std::size_t k) { return volumes[k]; });
  json_list(json, "slabFirst", s.slab_count + 1, [&](std::size_t k) { return first_tet(s, k); });
  json_list(json, "slabNumbers", s.slab_count, [&](std::size_t k) { return s.slab_number[k]; });
  json_list(json, "sections", s.sections.size(),
            [&](std::size_t k) { return static_cast<double>(own.coordinate(s.sections[k], 2)); });
  json_colours(json, "slabColours", s.slab_count,
               [&](std::size_t k) { return s.colour(first_tet(s, k), ColourBy::slab); });
  if (!s.evidence.empty()) {
    json_list(json, "links", kEvidences, [&](std::size_t k) { return s.links[k]; });
  }
  json.end_object();
}

double page_layer_cut(const PageLayer& layer, const PageSpace& space, const PictureCut& cut,
                      double stretch) {
  const double position = std::ldexp(cut.position, -layer.subject.exponent);
  return static_cast<double>(
      OwnSpace(layer, space).coordinate(cut.axis == 2 ? stretch * position : position, cut.axis));
}

void append_page_layer(std::string& page, std::size_t number, const PageLayer& layer,
                       const PageSpace& space, WatchedWork& work) {
  Arrays(page, number, layer, space, work).append();
}

}  // namespace tetloft::internal::render
