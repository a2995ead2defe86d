// How far regions of neighbouring sections overlap, exactly.
#pragma once

#include <array>
#include <vector>

#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// A region as a set of polygons with even-odd rule: its outer contour and its holes, as of a valid
/// section.
struct RegionOutline {
  std::vector<const Contour*> contours;
};
[[nodiscard]] TETLOFT_API RegionOutline outline(const Section& section, const Nesting& nesting,
                                                RegionId region);
/// The same of all regions, in time linear in the contours.
[[nodiscard]] TETLOFT_API IdVector<RegionId, RegionOutline> outlines(const Section& section,
                                                                     const Nesting& nesting);

/// An exact comparison of areas: the sign of area(a ∩ b) / min(area a, area b) − tau, for
/// tau as the double it is. Interval arithmetic first, rationals where it cannot decide.
[[nodiscard]] TETLOFT_API Sign compare_overlap(const RegionOutline& a, const RegionOutline& b,
                                               double tau);
/// The same for two thresholds, for little more than the cost of one.
[[nodiscard]] TETLOFT_API std::array<Sign, 2> compare_overlap(const RegionOutline& a,
                                                              const RegionOutline& b,
                                                              const std::array<double, 2>& taus);
/// The same ratio, for reports and for ordering by evidence: rounded to 32 significant
/// bits, halves up, so that equal ratios are equal doubles however they arise; exactly 0
/// iff the intersection has no area.
[[nodiscard]] TETLOFT_API double overlap_ratio(const RegionOutline& a, const RegionOutline& b);
[[nodiscard]] TETLOFT_API double area(const RegionOutline& region);

}  // namespace tetloft
