// What a point is inside of, kept up to date on a walk across pieces of contours, and whether the
// region has it by a fill rule.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/repair.hpp>

namespace tetloft::internal::sections {

class FillState {
 public:
  /// group[c] says with which others contour c is united; it counts for FillRule::unite alone.
  FillState(FillRule rule, const IdVector<ContourId, std::uint32_t>& group)
      : rule_(rule), group_(group), winding_(group.size(), 0), inside_of_(group.size(), 0) {}

  /// The contour winds around the point so many times more than before.
  void add(ContourId contour, int times) {
    int& winding = winding_[contour];
    const bool was_inside = winding != 0;
    winding += times;
    total_ += times;
    const bool is_inside = winding != 0;
    if (was_inside == is_inside) return;
    std::uint32_t& contours = inside_of_[group_[contour]];
    if (is_inside) {
      around_.insert(contour);
      if (contours++ == 0) ++groups_;
    } else {
      around_.erase(contour);
      if (--contours == 0) --groups_;
    }
  }

  [[nodiscard]] bool in_region() const {
    switch (rule_) {
      case FillRule::odd: return total_ % 2 != 0;
      case FillRule::unite: return groups_ % 2 != 0;
      case FillRule::winding: return total_ != 0;
    }
    return false;
  }
  [[nodiscard]] bool inside(ContourId contour) const { return winding_[contour] != 0; }
  /// The contours that the point is inside of.
  [[nodiscard]] const std::set<ContourId>& around() const { return around_; }

 private:
  FillRule rule_;
  const IdVector<ContourId, std::uint32_t>& group_;
  IdVector<ContourId, int> winding_;
  std::vector<std::uint32_t> inside_of_;  // by group: how many of its contours
  std::set<ContourId> around_;
  int total_ = 0;
  int groups_ = 0;
};

}  // namespace tetloft::internal::sections
