// Contours for tests of sections, and what tests compute about them by other means.
#pragma once

#include <initializer_list>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::testing {

using namespace internal;

[[nodiscard]] Contour contour(std::initializer_list<Point2> vertices);
/// The axis-parallel rectangle [x0, x1] × [y0, y1], counter-clockwise.
[[nodiscard]] Contour rectangle(double x0, double y0, double x1, double y1);
[[nodiscard]] Section section(double z, std::vector<Contour> contours);
[[nodiscard]] SectionStack stack(std::vector<Section> sections);
/// One section at z = 0.
[[nodiscard]] SectionStack one(std::vector<Contour> contours);

/// A simple polygon, star-shaped about (x, y), of lattice points at most `radius` away from
/// it along each axis; at most one point in each direction. Valid by construction.
[[nodiscard]] Contour random_star(Prng& prng, int x, int y, int radius, int points);

[[nodiscard]] Contour reversed(const Contour& contour);
[[nodiscard]] Contour rotated(const Contour& contour, std::size_t by);
/// Every vertex p becomes p · factor + offset.
[[nodiscard]] Contour moved(const Contour& contour, double factor, Point2 offset);

/// Is p in the interior by the even-odd rule? For p on no edge; exact.
[[nodiscard]] bool is_inside(const Contour& contour, const oracle::Rational& x,
                             const oracle::Rational& y);
[[nodiscard]] bool is_inside(const Contour& contour, const Point2& p);

/// Area of the intersection of outer contours less holes, each region as its contours, the
/// outer one first: triangle fans clipped by each other.
[[nodiscard]] oracle::Rational overlap_by_clipping(const std::vector<Contour>& a,
                                                   const std::vector<Contour>& b);
[[nodiscard]] oracle::Rational exact_area(const std::vector<Contour>& region);

[[nodiscard]] RegionOutline outline_of(const std::vector<Contour>& region);

}  // namespace tetloft::testing
