// Shapes of SVG as lines: path data, lists of points, transforms.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::io {

/// x' = a x + c y + e, y' = b x + d y + f, as SVG writes matrix(a b c d e f).
struct SvgTransform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  [[nodiscard]] Point2 apply(const Point2& p) const {
    return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
  }
  /// First `inner`, then this.
  [[nodiscard]] SvgTransform after(const SvgTransform& inner) const;
};

struct SvgLine {
  std::vector<Point2> points;
  bool closed = false;
};

/// What a shape is made of, or why it is not read.
struct SvgLines {
  std::vector<SvgLine> lines;
  std::size_t curves = 0;        ///< that became line segments
  std::size_t curve_points = 0;  ///< of these
  std::string problem;           ///< empty: none
};

/// Numbers separated by blanks and commas, or by their signs and points alone; nothing where there
/// is anything else, or a number is not finite.
[[nodiscard]] std::optional<std::vector<double>> svg_numbers(std::string_view text);

/// translate, scale, matrix, and rotate by quarter turns, from left to right; nothing for others.
[[nodiscard]] std::optional<SvgTransform> svg_transform(std::string_view text);

/// "d" of a path. Béziers become at most 16 segments each, which deviate by at most 1/512 of the
/// extent of their control points where 16 suffice for that. Problems: elliptic arcs, and more than
/// `most` points of Béziers.
[[nodiscard]] SvgLines svg_path(std::string_view data, std::size_t most);

}  // namespace tetloft::internal::io
