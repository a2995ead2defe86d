// Boundary surfaces as binary .stl, or ASCII with a solid for each component. It holds float32
// only (float32.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/little_endian.hpp"
#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/float32.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/stl_read.hpp"

namespace tetloft::internal::io {

namespace {

// Unit normal by the right-hand rule, or zero for a flat triangle: readers compute their own.
FloatPoint normal_of(const Point3& a, const Point3& b, const Point3& c) {
  // Scaled by the longest side first, so that products of huge or tiny coordinates stay
  // within range.
  std::array<double, 6> d{b.x - a.x, b.y - a.y, b.z - a.z, c.x - a.x, c.y - a.y, c.z - a.z};
  double largest = 0;
  for (const double side : d) largest = std::max(largest, std::fabs(side));
  if (largest == 0) return {};
  for (double& side : d) side /= largest;
  const std::array<double, 3> n{d[1] * d[5] - d[2] * d[4], d[2] * d[3] - d[0] * d[5],
                                d[0] * d[4] - d[1] * d[3]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (length == 0) return {};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

void append_triple(std::string& text, const FloatPoint& p) {
  for (const float c : p) {
    text += ' ';
    append_number(text, c);
  }
  text += '\n';
}

void append_binary_stl(Sink& sink, const SurfaceMesh& mesh, const std::string& title,
                       const std::vector<SurfacePart>& parts) {
  Pieces pieces(sink);
  std::string& piece = pieces.text();
  // 80 bytes that must not begin with "solid", else readers take the file for ASCII.
  piece = beginning("binary STL by tetloft" + title, kStlHeadBytes - 4);
  piece.resize(kStlHeadBytes - 4, ' ');
  append_little(piece, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::uint32_t triangle : by_part(parts)) {
    const auto& t = mesh.triangles[triangle];
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    for (const FloatPoint& p :
         {normal_of(a, b, c), float_point(a), float_point(b), float_point(c)}) {
      for (const float value : p) append_little(piece, value);
    }
    append_little(piece, std::uint16_t{0});
    pieces.next();
  }
  pieces.finish();
}

void append_solid(Pieces& pieces, const SurfaceMesh& mesh, const std::string& name,
                  std::span<const std::uint32_t> triangles) {
  std::string& piece = pieces.text();
  piece += "solid " + name + '\n';
  for (const std::uint32_t triangle : triangles) {
    const auto& t = mesh.triangles[triangle];
    const std::array<const Point3*, 3> corners{&mesh.points[t[0]], &mesh.points[t[1]],
                                               &mesh.points[t[2]]};
    piece += "facet normal";
    append_triple(piece, normal_of(*corners[0], *corners[1], *corners[2]));
    piece += "outer loop\n";
    for (const Point3* p : corners) {
      piece += "vertex";
      append_triple(piece, float_point(*p));
    }
    piece += "endloop\nendfacet\n";
    pieces.next();
  }
  piece += "endsolid " + name + '\n';
}

void append_ascii_stl(Sink& sink, const SurfaceMesh& mesh, bool nameless,
                      const std::vector<SurfacePart>& parts) {
  Pieces pieces(sink);
  for (const SurfacePart& part : parts) {
    append_solid(pieces, mesh, nameless ? "tetloft" : printable(part.name), part.triangles);
  }
  if (parts.empty()) append_solid(pieces, mesh, "tetloft", {});
  pieces.finish();
}

// What the head of a binary file has room for.
std::string binary_title(const Description& about) {
  std::string title;
  if (!about.name.empty()) title += ": " + printable(about.name);
  if (!about.unit.empty()) title += ", in " + printable(about.unit);
  return title;
}

Written write_stl(Sink& sink, const SurfaceMesh& mesh, const Model& model, const Target& target) {
  if (const auto error = beyond_float32(mesh.points, "STL")) return *error;
  std::vector<FloatPoint> points(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), points.begin(), float_point);
  Float32Loss loss("STL");
  loss.add(mesh.points, mesh.triangles, points);
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  if (target.options.encoding == Encoding::ascii) {
    append_ascii_stl(sink, mesh, is_nameless(model, parts), parts);
  } else {
    append_binary_stl(sink, mesh, binary_title(model.about), parts);
  }
  return loss.warnings();
}

bool is_stl(std::string_view bytes) {
  const bool text = bytes.substr(0, 5) == "solid" && bytes.size() > 5 && is_white(bytes[5]);
  return text || is_binary_stl(bytes);
}

}  // namespace

extern constinit const Format stl_format{.name = "stl",
                                         .summary = "stereolithography, float32",
                                         .extensions = {".stl"},
                                         .recognise = is_stl,
                                         .read_triangles = read_stl,
                                         .write_surface = write_stl};

}  // namespace tetloft::internal::io
