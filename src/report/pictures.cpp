#include "report/pictures.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "io/base64.hpp"
#include "render/stills.hpp"
#include "render/vector.hpp"
#include "report/markup.hpp"
#include "report/scale_bar.hpp"

namespace tetloft::internal::report {

namespace {

constexpr int kPictureWidth = 680;
constexpr int kPictureHeight = 510;
constexpr double kStrip = 36;

struct NamedSide {
  render::Side side;
  const char* caption;
  Point3 right, up;  // directions of the stack; 0 of an oblique side
};
const std::array<NamedSide, 4> kSides{{
    {{-60, 25}, "oblique", {}, {}},
    {{-90, 0}, "along y: x to the right, z up", {1, 0, 0}, {0, 0, 1}},
    {{0, 0}, "along x: y to the right, z up", {0, 1, 0}, {0, 0, 1}},
    {{-90, 90}, "from above: x to the right, y up", {1, 0, 0}, {0, 1, 0}},
}};

Point3 reversed(const Point3& direction) { return {-direction.x, -direction.y, -direction.z}; }

// L or R, A or P, S or I around the picture; empty where none is known.
std::string edge_letters(const Subject& subject, const NamedSide& named) {
  struct Edge {
    Point3 direction;
    double x, y;
  };
  const std::array<Edge, 4> edges{
      {{named.right, kPictureWidth + kStrip / 2, kPictureHeight / 2.0},
       {reversed(named.right), -kStrip / 2, kPictureHeight / 2.0},
       {named.up, kPictureWidth / 2.0, -kStrip / 4},
       {reversed(named.up), kPictureWidth / 2.0, kPictureHeight + kStrip * 3 / 4}}};
  std::string out;
  for (const Edge& edge : edges) {
    const char letter =
        orientation_letter(subject.model.frame, subject.about.orientation, edge.direction);
    if (letter == 0) continue;
    out += "<text class=\"letter\" text-anchor=\"middle\" x=\"";
    append_coordinate(out, edge.x);
    out += "\" y=\"";
    append_coordinate(out, edge.y);
    out += "\">" + std::string(1, letter) + "</text>";
  }
  return out;
}

std::string drawn(const render::Still& still) {
  if (still.is_svg) return still.bytes;
  return "<image width=\"" + std::to_string(kPictureWidth) + "\" height=\"" +
         std::to_string(kPictureHeight) + "\" href=\"data:image/png;base64," +
         io::encode_base64(still.bytes) + "\"/>";
}

std::string picture(const Subject& subject, const NamedSide& named, const render::Still& still,
                    const std::string& unit) {
  const std::string letters = edge_letters(subject, named);
  // A strip below for the bar, and all around for letters.
  const double around = subject.about.orientation.size() == 3 ? kStrip : 0;
  std::string out = "<figure class=\"picture\"><svg role=\"img\" viewBox=\"";
  for (const double number : {-around, -around, kPictureWidth + 2 * around}) {
    append_coordinate(out, number);
    out += ' ';
  }
  append_coordinate(out, kPictureHeight + around + kStrip);
  out += std::string("\"><title>") + named.caption + "</title>" + drawn(still) + letters;
  if (subject.is_rigid) {
    out +=
        scale_bar({20, kPictureHeight + kStrip - 12}, kPictureWidth / 4.0, still.pixels, unit, 1.5);
  }
  return out + "</svg>" + element("figcaption", named.caption) + "</figure>";
}

}  // namespace

char orientation_letter(const Frame& frame, const std::string& orientation,
                        const Point3& direction) {
  constexpr std::array<std::string_view, 3> kPairs{"LR", "AP", "SI"};
  // Within 25 degrees a letter says more than none.
  constexpr double kNear = 0.9;
  if (orientation.size() != 3) return 0;
  const auto& a = frame.axes;
  const auto placed = [&](double Point3::*axis) {
    return direction.x * a[0].*axis + direction.y * a[1].*axis + direction.z * a[2].*axis;
  };
  const std::array<double, 3> at{placed(&Point3::x), placed(&Point3::y), placed(&Point3::z)};
  const double length = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(at[i]) > kNear * length)) continue;
    for (const std::string_view pair : kPairs) {
      const std::size_t which = pair.find(orientation[i]);
      if (which == std::string_view::npos) continue;
      return pair[at[i] > 0 ? which : 1 - which];
    }
  }
  return 0;
}

std::string pictures(const Subject& subject, WatchedWork& work) {
  RenderOptions options;
  options.width = kPictureWidth;
  options.height = kPictureHeight;
  options.execution = untold(work.execution());
  std::vector<render::Side> sides;
  for (const NamedSide& named : kSides) sides.push_back(named.side);
  const auto stills = render::render_stills(subject.model, subject.stack, options, sides, work);
  if (!stills) {
    return element("p", "No pictures: " + escaped(stills.error().message) + '.', "class=\"note\"");
  }
  std::string out = "<div class=\"pictures\">";
  for (std::size_t k = 0; k < stills->size(); ++k) {
    out += picture(subject, kSides[k], (*stills)[k], subject.about.unit);
  }
  return out + "</div>";
}

}  // namespace tetloft::internal::report
