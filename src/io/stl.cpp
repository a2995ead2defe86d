// Boundary surfaces as binary and ASCII .stl. It holds float32 only: vertices that differ as
// doubles may coincide there, and triangles lose their area.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/little_endian.hpp"
#include "io/cursor.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/stl_read.hpp"

namespace tetloft::internal::io {

namespace {

using FloatPoint = std::array<float, 3>;

FloatPoint rounded(const Point3& p) {
  // Adding zero turns −0 into 0: STL readers merge vertices by their bits.
  return {static_cast<float>(p.x) + 0.0F, static_cast<float>(p.y) + 0.0F,
          static_cast<float>(p.z) + 0.0F};
}

bool fits(const Point3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::fabs(p.x) <= kLargest && std::fabs(p.y) <= kLargest && std::fabs(p.z) <= kLargest;
}

// Whether the sum of six doubles is zero, exactly: they are collected in a non-overlapping
// expansion (Shewchuk 1997, Grow-Expansion), which is zero iff its components are.
bool sums_to_zero(const std::array<double, 6>& terms) {
  std::array<double, 6> expansion{};
  std::size_t size = 0;
  for (const double term : terms) {
    double carry = term;
    for (std::size_t i = 0; i < size; ++i) {
      const double sum = carry + expansion[i];
      const double virtual_part = sum - carry;
      expansion[i] = (carry - (sum - virtual_part)) + (expansion[i] - virtual_part);
      carry = sum;
    }
    expansion[size++] = carry;
  }
  return std::all_of(expansion.begin(), expansion.end(), [](double e) { return e == 0; });
}

// Whether the projection of a, b, c to two axes is collinear. Products of two floats are
// exact as doubles: 48 bits, exponents between −298 and 256.
bool collinear_in(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c, std::size_t u,
                  std::size_t v) {
  const auto product = [](float x, float y) {
    return static_cast<double>(x) * static_cast<double>(y);
  };
  return sums_to_zero({product(a[u], b[v]), -product(a[v], b[u]), product(b[u], c[v]),
                       -product(b[v], c[u]), product(c[u], a[v]), -product(c[v], a[u])});
}

bool flat(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c) {
  return collinear_in(a, b, c, 0, 1) && collinear_in(a, b, c, 1, 2) && collinear_in(a, b, c, 2, 0);
}

Warning float32_warning(const Point3& p, const std::string& message) {
  Warning warning{message + "; .ply and .vtp keep double precision", {}};
  warning.where.point = p;
  return warning;
}

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

// What rounding to float32 breaks, decided exactly: one warning if distinct vertices merge and one
// if triangles become flat, each naming the first place. An error where a coordinate is beyond
// float32.
Written check_float32(const SurfaceMesh& mesh) {
  for (const Point3& p : mesh.points) {
    if (fits(p)) continue;
    Error error{ErrorCode::invalid_input,
                "a coordinate is beyond the float32 of STL; write .ply or .vtp",
                {}};
    error.where.point = p;
    return error;
  }
  std::vector<FloatPoint> points(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), points.begin(), rounded);

  std::vector<Warning> warnings;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points[i] != points[j] ? points[i] < points[j] : i < j;
  });
  std::size_t merged = 0;
  std::uint32_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i]] != points[order[i - 1]]) continue;
    first = merged == 0 ? order[i] : std::min(first, order[i]);
    ++merged;
  }
  if (merged != 0) {
    warnings.push_back(float32_warning(
        mesh.points[first], "rounding to the float32 of STL merges " + std::to_string(merged) +
                                (merged == 1 ? " vertex" : " vertices") +
                                " with others; the surface may touch itself"));
  }

  std::size_t flattened = 0;
  Point3 place;
  for (const auto& t : mesh.triangles) {
    if (!flat(points[t[0]], points[t[1]], points[t[2]])) continue;
    if (flattened++ == 0) place = mesh.points[t[0]];
  }
  if (flattened != 0) {
    warnings.push_back(float32_warning(place, "rounding to the float32 of STL flattens " +
                                                  std::to_string(flattened) +
                                                  (flattened == 1 ? " triangle" : " triangles") +
                                                  "; the surface may not be valid"));
  }
  return warnings;
}

void append_stl(Sink& sink, const SurfaceMesh& mesh, Encoding encoding) {
  Pieces pieces(sink);
  std::string& piece = pieces.text();
  if (encoding == Encoding::binary) {
    // 80 bytes that must not begin with "solid", else readers take the file for ASCII.
    piece = "binary STL by tetloft";
    piece.resize(kStlHeadBytes - 4, ' ');
    append_little(piece, static_cast<std::uint32_t>(mesh.triangles.size()));
  } else {
    piece = "solid tetloft\n";
  }
  for (const auto& t : mesh.triangles) {
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    const FloatPoint normal = normal_of(a, b, c);
    if (encoding == Encoding::binary) {
      for (const FloatPoint& p : {normal, rounded(a), rounded(b), rounded(c)}) {
        for (const float value : p) append_little(piece, value);
      }
      append_little(piece, std::uint16_t{0});
    } else {
      piece += "facet normal";
      append_triple(piece, normal);
      piece += "outer loop\n";
      for (const Point3* p : {&a, &b, &c}) {
        piece += "vertex";
        append_triple(piece, rounded(*p));
      }
      piece += "endloop\nendfacet\n";
    }
    pieces.next();
  }
  if (encoding == Encoding::ascii) piece += "endsolid tetloft\n";
  pieces.finish();
}

Written write_stl(Sink& sink, const SurfaceMesh& mesh, const Model& /*model*/,
                  const Target& target) {
  Written warnings = check_float32(mesh);
  if (warnings) append_stl(sink, mesh, target.options.encoding);
  return warnings;
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
