// The viewer's page.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/render.hpp>

#include "core/guard.hpp"
#include "core/text.hpp"
#include "core/watched_work.hpp"
#include "io/base64.hpp"
#include "io/bytes/deflate.hpp"
#include "io/numbers.hpp"
#include "render/subject.hpp"
#include "render/vector.hpp"
#include "render/viewer_parts.hpp"

namespace tetloft {

using namespace internal;

namespace {

using render::Rgb;
using render::Subject;

// Inside a script element no "<" may be taken for a tag: "\u003c" is the same string.
std::string json_string(std::string_view text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || c == '<' || c == '"' || c == '\\') {
      out += "\\u00";
      out += kDigits[byte >> 4];
      out += kDigits[byte & 15U];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

// One comma-separated member of a JSON object at a time.
class Members {
 public:
  void text(const char* name, std::string_view value) { raw(name, json_string(value)); }
  void number(const char* name, double value) {
    std::string text;
    io::append_number(text, value);
    raw(name, text);
  }
  void flag(const char* name, bool value) { raw(name, value ? "true" : "false"); }
  void raw(const char* name, const std::string& value) {
    if (!out_.empty()) out_ += ',';
    out_ += json_string(name) + ':' + value;
  }
  /// item(k): the JSON of entry k.
  template <class Item>
  void list(const char* name, std::size_t n, Item&& item) {
    std::string all = "[";
    for (std::size_t k = 0; k < n; ++k) {
      if (k != 0) all += ',';
      all += item(k);
    }
    raw(name, all + ']');
  }
  [[nodiscard]] std::string object() const { return '{' + out_ + '}'; }

 private:
  std::string out_;
};

std::string json(const Rgb& colour) {
  return '[' + std::to_string(colour.r) + ',' + std::to_string(colour.g) + ',' +
         std::to_string(colour.b) + ']';
}

// An array as the viewer unpacks it: byte planes, which compress better, as a zlib stream in
// base64.
template <class T>
void append_array(std::string& page, const char* id, const std::vector<T>& values) {
  std::string planes(values.size() * sizeof(T), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(values[i]);
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      const std::size_t from = std::endian::native == std::endian::little ? k : sizeof(T) - 1 - k;
      planes[k * values.size() + i] = bytes[from];
    }
  }
  page += "<script type=\"application/octet-stream\" id=\"array-";
  page += id;
  page += "\">" + io::encode_base64(io::zlib_compressed(planes)) + "</script>\n";
}

class Page {
 public:
  static constexpr std::size_t kSteps = 12;  // the header, and the arrays

  /// Tells `work` of kSteps steps.
  Page(const Subject& subject, const RenderOptions& options, WatchedWork& work)
      : subject_(subject), options_(options), work_(work) {
    using namespace render;
    centre_ = 0.5 * (subject.low + subject.high);
    const Point3 diagonal = subject.high - subject.low;
    scale_ = std::sqrt(dot(diagonal, diagonal)) / 2;
    if (!(scale_ > 0)) scale_ = 1;
  }

  std::string text() const {
    std::string page =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>" +
        html_text(valid_utf8(options_.title)) + "</title>\n<style>\n" + render::kViewerCss +
        "</style>\n</head>\n<body>\n" + render::kViewerHtml;
    page += "<script type=\"application/json\" id=\"model\">" + header() + "</script>\n";
    work_.step_done_go_on();
    append_arrays(page);
    for (const char* script : render::kViewerScripts) {
      page += "<script>\n";
      page += script;
      page += "</script>\n";
    }
    return page + "</body>\n</html>\n";
  }

 private:
  // Heights are stretched in the subject, and not for the reader.
  [[nodiscard]] float height(double stretched) const {
    return static_cast<float>((stretched - centre_.z) / scale_);
  }

  [[nodiscard]] std::string header() const {
    const Subject& s = subject_;
    Members members;
    members.text("title", valid_utf8(options_.title));
    members.number("componentCount", static_cast<double>(s.component_count));
    members.number("centre", std::ldexp(centre_.z / options_.stretch, s.exponent));
    members.number("scale", std::ldexp(scale_ / options_.stretch, s.exponent));
    members.number("gap", s.mean_gap / scale_);
    members.text("colour", name_of(options_.colour));
    members.number("azimuth", options_.azimuth);
    members.number("elevation", options_.elevation);
    members.number("explode", options_.explode);
    members.flag("edges", options_.edges);
    members.flag("drawContours", options_.contours);
    if (options_.cut) {
      members.number(
          "cut", static_cast<double>(
                     height(options_.stretch * std::ldexp(options_.cut->position, -s.exponent))));
    } else {
      members.raw("cut", "null");
    }
    std::vector<ColourBy> colourings{ColourBy::component, ColourBy::slab};
    if (!s.kind.empty()) colourings.push_back(ColourBy::kind);
    colourings.push_back(ColourBy::dihedral);
    if (!s.evidence.empty()) colourings.push_back(ColourBy::evidence);
    members.list("colourings", colourings.size(),
                 [&](std::size_t k) { return json_string(name_of(colourings[k])); });
    members.list("slabFirst", s.slab_count + 1, [&](std::size_t k) {
      const auto first =
          std::lower_bound(s.slab.begin(), s.slab.end(), static_cast<std::uint32_t>(k));
      return std::to_string(first - s.slab.begin());
    });
    members.list("sections", s.sections.size(), [&](std::size_t k) {
      Members section;
      section.number("at", static_cast<double>(height(s.sections[k])));
      return section.object();
    });
    // Of the first components; the viewer begins again after these.
    members.list("componentColours", std::min<std::size_t>(s.component_count, 48),
                 [](std::size_t k) { return json(render::component_colour(k)); });
    members.list("slabColours", s.slab_count, [&](std::size_t k) {
      return json(
          s.colour(static_cast<std::size_t>(std::lower_bound(s.slab.begin(), s.slab.end(),
                                                             static_cast<std::uint32_t>(k)) -
                                            s.slab.begin()),
                   ColourBy::slab));
    });
    members.list("dihedralColours", 256, [](std::size_t k) {
      return json(render::dihedral_colour(static_cast<double>(k) / 255));
    });
    members.list("kindColours", kTetKinds,
                 [](std::size_t k) { return json(render::kind_colour(static_cast<TetKind>(k))); });
    members.list("kindNames", kTetKinds,
                 [](std::size_t k) { return json_string(name_of(static_cast<TetKind>(k))); });
    if (!s.evidence.empty()) {
      members.list("evidenceColours", kEvidences + 1,
                   [](std::size_t k) { return json(render::evidence_colour(k)); });
      members.list("evidenceNames", kEvidences,
                   [](std::size_t k) { return json_string(name_of(static_cast<Evidence>(k))); });
      members.list("links", kEvidences, [&](std::size_t k) { return std::to_string(s.links[k]); });
    }
    return members.object();
  }

  template <class T>
  void add_array(std::string& page, const char* id, const std::vector<T>& values) const {
    append_array(page, id, values);
    work_.step_done_go_on();
  }

  void append_arrays(std::string& page) const {
    const Subject& s = subject_;
    std::vector<float> floats;
    const auto append_point = [&](const Point3& p) {
      floats.push_back(static_cast<float>((p.x - centre_.x) / scale_));
      floats.push_back(static_cast<float>((p.y - centre_.y) / scale_));
      floats.push_back(height(p.z));
    };
    for (const Point3& p : s.points) append_point(p);
    add_array(page, "points", floats);

    std::vector<std::uint32_t> words;
    for (const TetVertices& tet : s.tets) {
      for (const VertexId v : tet) words.push_back(v.value());
    }
    add_array(page, "tets", words);
    const auto append_half_faces = [&](const char* id, const std::vector<HalfFaceId>& all) {
      words.clear();
      for (const HalfFaceId h : all) words.push_back(h.value());
      add_array(page, id, words);
    };
    append_half_faces("boundary", s.boundary);
    append_half_faces("walls", s.walls);

    std::vector<std::int8_t> normals;
    for (const auto& corners : s.normals) {
      for (const Point3& n : corners) {
        for (int axis = 0; axis < 3; ++axis) {
          normals.push_back(
              static_cast<std::int8_t>(std::lround(127 * render::coordinate(n, axis))));
        }
      }
    }
    add_array(page, "normals", normals);
    add_array(page, "component", s.component);

    std::vector<std::uint8_t> bytes;
    for (const TetKind kind : s.kind) bytes.push_back(static_cast<std::uint8_t>(kind));
    add_array(page, "kind", bytes);
    bytes.clear();
    for (const float degrees : s.dihedral) {
      bytes.push_back(static_cast<std::uint8_t>(
          std::lround(255 * std::min(1.0, static_cast<double>(degrees) / render::kBestDihedral))));
    }
    add_array(page, "dihedral", bytes);
    add_array(page, "evidence", s.evidence);

    floats.clear();
    words.clear();
    for (const render::ContourPiece& piece : s.contours) {
      append_point(piece.a);
      append_point(piece.b);
      words.push_back(piece.slab_below);
      words.push_back(piece.slab_above);
    }
    add_array(page, "contours", floats);
    add_array(page, "contour_slabs", words);
  }

  const Subject& subject_;
  const RenderOptions& options_;
  WatchedWork& work_;
  Point3 centre_;
  double scale_ = 1;
};

}  // namespace

Result<std::string> render_html(const Model& model, const SectionStack* contours,
                                const RenderOptions& options) {
  return guard_internal([&]() -> Result<std::string> {
    if (options.cut && options.cut->axis != 2) {
      return Error{ErrorCode::usage, "the viewer cuts by z only", {}};
    }
    WatchedWork work(options.execution, Page::kSteps + 1);
    work.go_on();
    const Result<Subject> subject = render::subject_of(model, contours, options);
    if (!subject) return subject.error();
    work.step_done_go_on();
    return Page(*subject, options, work).text();
  });
}

}  // namespace tetloft
