// A model cut by planes of constant z: areas, and outlines by component. In plain doubles.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

#include "report/subject.hpp"

namespace tetloft::internal::report {

/// A cut just below z, or just above it: in a plane with vertices these may differ.
struct CutHeight {
  double z = 0;
  bool above = false;
  /// Whether the cut counts as under `height`.
  [[nodiscard]] bool is_under(double height) const { return above ? height > z : height >= z; }
};

/// Areas of the solid, in the unit of the stack squared. Heights ascend.
[[nodiscard]] std::vector<double> cut_areas(const Subject& subject,
                                            const std::vector<CutHeight>& heights);

struct CutLoop {
  std::uint32_t component = 0;
  std::vector<Point2> points;  ///< closed
};
/// Inside by the even-odd rule of all loops of a component. What does not close, of a surface that
/// is none, is closed by a straight line.
[[nodiscard]] std::vector<CutLoop> cut_loops(const Subject& subject, const CutHeight& height);

}  // namespace tetloft::internal::report
