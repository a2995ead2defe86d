// Regions of a stack and what the rule of correspondence measures between them, in rationals and by
// definition: for oracles.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "support/rational_geometry.hpp"

namespace tetloft::oracle {

/// A connected region, where it lies or moved.
struct Region {
  std::size_t section = 0;
  std::vector<std::vector<Point2>> shape;  ///< the outer contour first
  std::vector<Polygon> outline;            ///< the same, exactly
  Rational area;                           ///< twice
  std::vector<std::size_t> contours;       ///< of all sections in one sequence, the outer one first
};

/// By (section, lowest vertex of the outer contour by x, then y).
[[nodiscard]] std::vector<Region> regions_of(const SectionStack& stack);

/// Moved by d, coordinates rounded; none where contours cross, collapse or lie in each other in
/// another way.
[[nodiscard]] std::optional<Region> moved_by(const Region& region, const Point2& d);

struct Bounds {
  Point2 low, high;
};
/// Of the outer contour.
[[nodiscard]] Bounds bounds(const Region& region);

/// Common area over the lesser area.
[[nodiscard]] Rational exact_ratio(const Region& a, const Region& b);
/// Squared distance of the nearest points of two regions.
[[nodiscard]] Rational squared_distance(const Region& a, const Region& b);

/// To 32 significant bits, halves up; of x, and of the root of x.
[[nodiscard]] double rounded(const Rational& x);
[[nodiscard]] double rounded_root(const Rational& x);

}  // namespace tetloft::oracle
