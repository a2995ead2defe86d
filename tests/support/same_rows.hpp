// Equality of the rows of a model's tables, bit by bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>

namespace tetloft::test {

[[nodiscard]] inline bool same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

[[nodiscard]] inline bool same_row(const RegionLink& a, const RegionLink& b) {
  return a.slab == b.slab && a.lower == b.lower && a.upper == b.upper && a.evidence == b.evidence &&
         a.fate == b.fate && same_number(a.ratio, b.ratio) && same_number(a.moved, b.moved) &&
         same_number(a.distance, b.distance) && same_number(a.margin, b.margin) &&
         a.lead.has_value() == b.lead.has_value() &&
         same_number(a.lead.value_or(0), b.lead.value_or(0));
}

[[nodiscard]] inline bool same_row(const VoidLink& a, const VoidLink& b) {
  return same_row(static_cast<const RegionLink&>(a), static_cast<const RegionLink&>(b)) &&
         a.planes == b.planes;
}

[[nodiscard]] inline bool same_row(const RegionMotion& a, const RegionMotion& b) {
  return a.slab == b.slab && a.upper == b.upper && a.contour == b.contour &&
         same_number(a.by.x, b.by.x) && same_number(a.by.y, b.by.y);
}

[[nodiscard]] inline bool same_row(const Deviation& a, const Deviation& b) {
  return a.slab == b.slab && a.upper == b.upper && a.contour == b.contour && a.least == b.least &&
         a.most == b.most && a.got == b.got;
}

template <class Row>
[[nodiscard]] bool same_rows(const std::vector<Row>& a, const std::vector<Row>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Row& p, const Row& q) { return same_row(p, q); });
}

}  // namespace tetloft::test
