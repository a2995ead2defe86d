#include "completion/chi_groups.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal {

ChiGroups::ChiGroups(const Slab& slab, const SlabClasses& classes,
                     const IdVector<ClassId, std::uint8_t>& active, std::vector<ChiRange> ranges)
    : slab_(slab),
      classes_(classes),
      active_(active),
      ranges_(std::move(ranges)),
      group_of_(classes.class_count(), kNone) {
  for (std::size_t g = 0; g < ranges_.size(); ++g) {
    for (const ClassId c : ranges_[g].classes) group_of_[c] = g;
  }
}

ChiGroups::Sums ChiGroups::sums(const Complex& complex) const {
  const IdVector<ClassId, std::int32_t> chi = attached_chi(slab_, classes_, active_, complex);
  Sums sums;
  for (const ChiRange& range : ranges_) {
    std::int32_t sum = 0;
    for (const ClassId c : range.classes) sum += chi[c];
    sums.push_back(sum);
  }
  return sums;
}

std::int32_t ChiGroups::deviation(const Sums& sums) const {
  std::int32_t total = 0;
  for (std::size_t g = 0; g < ranges_.size(); ++g) {
    total += std::max({0, ranges_[g].least - sums[g], sums[g] - ranges_[g].most});
  }
  return total;
}

bool ChiGroups::is_low(ClassId c, const Sums& sums) const {
  const std::size_t g = group_of_[c];
  return g != kNone && sums[g] < ranges_[g].least;
}

bool ChiGroups::is_high(ClassId c, const Sums& sums) const {
  const std::size_t g = group_of_[c];
  return g != kNone && sums[g] > ranges_[g].most;
}

bool ChiGroups::any_low(const Sums& sums) const {
  for (const ClassId c : group_of_.ids()) {
    if (is_low(c, sums)) return true;
  }
  return false;
}

bool ChiGroups::any_high(const Sums& sums) const {
  for (const ClassId c : group_of_.ids()) {
    if (is_high(c, sums)) return true;
  }
  return false;
}

}  // namespace tetloft::internal
