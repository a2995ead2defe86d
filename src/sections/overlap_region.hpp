// A region made ready to be laid over many others: what its overlaps need of it alone.
#pragma once

#include <array>
#include <vector>

#include <tetloft/overlap.hpp>

#include "arithmetic/interval.hpp"
#include "sections/trapezoids.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

/// An edge with its slope, rounded three times and infinite where it is too steep for doubles, and
/// how far it rises or falls, rounded.
struct SlopedEdge : Trapezoid {
  double slope;
  double rise;
};

class OverlapRegion {
 public:
  /// Requires an outline of finite coordinates, which must outlive this: throws
  /// std::invalid_argument as require_outline() does.
  explicit OverlapRegion(const RegionOutline& outline);

  [[nodiscard]] const RegionOutline& outline() const { return *outline_; }
  [[nodiscard]] const Box2& box() const { return box_; }
  /// Its edges that have a common range of x with `box`, as visit_pairs() needs them.
  [[nodiscard]] std::vector<SlopedEdge> edges_near(const Box2& box) const;
  /// Twice its area.
  [[nodiscard]] const Interval& twice_area() const { return twice_area_; }
  /// Can intervals compute with its coordinates, far from over- and underflow?
  [[nodiscard]] bool is_moderate() const;
  /// The same in coordinates times 2^scale, below 1 in magnitude; is_usable() tells whether that
  /// was exact.
  [[nodiscard]] OverlapRegion scaled(int scale) const;
  [[nodiscard]] bool is_usable() const { return usable_; }

 private:
  OverlapRegion(const RegionOutline& outline, Trapezoids shape, bool usable);

  const RegionOutline* outline_;
  Box2 box_;
  Interval twice_area_;
  bool usable_;
  std::vector<SlopedEdge> edges_;  // sorted
};

/// As those of tetloft/overlap.hpp.
[[nodiscard]] std::array<Sign, 2> compare_overlap(const OverlapRegion& a, const OverlapRegion& b,
                                                  const std::array<double, 2>& taus);
[[nodiscard]] double overlap_ratio(const OverlapRegion& a, const OverlapRegion& b);
/// The exact ratio differs from overlap_ratio() by less than this part of it.
inline constexpr double kRatioError = 0x1p-20;

}  // namespace tetloft::internal::sections
