// How far the Euler characteristics of classes are from what they should be.
#pragma once

#include <cstdint>
#include <vector>

#include "completion/attached_chi.hpp"

namespace tetloft::internal {

/// Classes whose Euler characteristics count as one, and between what their sum should be.
struct ChiRange {
  std::vector<ClassId> classes;
  std::int32_t least = 0, most = 0;
};

/// Which of these a slab's complex has.
class ChiGroups {
 public:
  /// Slab, classes and flags must outlive this.
  ChiGroups(const Slab& slab, const SlabClasses& classes,
            const IdVector<ClassId, std::uint8_t>& active, std::vector<ChiRange> ranges);

  /// Sums of the characteristics of what a complex attaches.
  using Sums = std::vector<std::int32_t>;
  [[nodiscard]] Sums sums(const Complex& complex) const;

  /// By how much all groups together miss their ranges.
  [[nodiscard]] std::int32_t deviation(const Sums& sums) const;
  /// Is the group of this class, if it is in one, below its range, or above?
  [[nodiscard]] bool is_low(ClassId c, const Sums& sums) const;
  [[nodiscard]] bool is_high(ClassId c, const Sums& sums) const;
  [[nodiscard]] bool any_low(const Sums& sums) const;
  [[nodiscard]] bool any_high(const Sums& sums) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  const Slab& slab_;
  const SlabClasses& classes_;
  const IdVector<ClassId, std::uint8_t>& active_;
  std::vector<ChiRange> ranges_;
  IdVector<ClassId, std::size_t> group_of_;
};

}  // namespace tetloft::internal
