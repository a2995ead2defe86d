// How far regions of neighbouring sections overlap, and how far they are apart, exactly.
#pragma once

#include <array>
#include <optional>
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
/// The area of a region, its holes left out, rounded: near the exact one, for reports.
[[nodiscard]] TETLOFT_API double area(const RegionOutline& region);
/// The exact sign of area − side², for any side; negative if it is not finite.
[[nodiscard]] TETLOFT_API Sign compare_area(const RegionOutline& region, double side);

/// The distance of two regions laid over each other, as closed sets of the plane: 0 iff they share
/// a point, be it where contours touch; a region inside a hole is as far as the hole's contour.
/// The exact distance, rounded once to 32 significant bits, halves up, so that equal distances are
/// equal doubles however they arise, and comparing them compares nothing but values. At least the
/// least positive double where regions are apart; where there are no 32 bits, among denormals,
/// rounded once more. (1) It is symmetric. (2) It does not depend on the order of contours nor on
/// where and which way they run. (3) Scaling all by 2^k scales it. Infinite for outlines without
/// vertices. O(n log n) where few edges are nearly as near as the nearest; not so of circles about
/// one centre. Throws std::invalid_argument as overlap_ratio() does.
[[nodiscard]] TETLOFT_API double region_distance(const RegionOutline& a, const RegionOutline& b);
/// The same where it is at most `limit`, else nothing. Linear for boxes that are farther apart.
[[nodiscard]] TETLOFT_API std::optional<double> region_distance_within(const RegionOutline& a,
                                                                       const RegionOutline& b,
                                                                       double limit);

}  // namespace tetloft
