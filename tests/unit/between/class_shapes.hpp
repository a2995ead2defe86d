// Classes of a slab as values, and contours to make them of.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "between/class_shape.hpp"

namespace tetloft::testing {

/// A polygon of 4 n vertices on a circle, from numbers that every machine has alike.
[[nodiscard]] Contour circle(const Point2& centre, double radius, int n = 16);
[[nodiscard]] Contour box(const Point2& low, const Point2& high);

/// A class as a value; sections without a height are none.
struct OwnedClass {
  std::array<std::vector<Contour>, 4> contours;
  std::array<std::optional<double>, 4> z;

  [[nodiscard]] internal::between::ClassOutlines outlines() const;
  [[nodiscard]] internal::between::ClassShape at(const std::vector<double>& shares,
                                                 double step = 1) const;
  [[nodiscard]] OwnedClass upside_down() const;
  [[nodiscard]] OwnedClass scaled(double by) const;
};

/// A disc in each of four sections, 6 apart; none of radius 0.
[[nodiscard]] OwnedClass discs(const std::array<Point2, 4>& centre,
                               const std::array<double, 4>& radius);
/// An oblique body with a hole that branches, in sections at uneven heights.
[[nodiscard]] OwnedClass branching();

}  // namespace tetloft::testing
