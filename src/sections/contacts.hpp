// Contacts within one section: whether there is one, and which is the first.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

inline constexpr std::size_t kWholeContour = static_cast<std::size_t>(-1);

/// A defect of one section; a defect of a whole contour comes before those of its vertices.
struct Defect {
  std::size_t contour;
  std::size_t vertex;  ///< or kWholeContour
  std::string reason;

  [[nodiscard]] bool before(std::size_t c, std::size_t v) const {
    return contour != c ? contour < c : vertex + 1 < v + 1;  // kWholeContour + 1 is 0
  }
};

/// The nesting of contours that neither cross nor touch nor overlap anywhere, themselves or each
/// other; nothing where some do. Requires contours of three finite vertices or more, consecutive
/// ones different. O(n log n), whatever the input.
[[nodiscard]] std::optional<Nesting> nest_without_contact(const Section& section);

/// The first contact among the usable contours, before `limit` if that is given.
[[nodiscard]] std::optional<Defect> first_contact(const Section& section,
                                                  const std::vector<bool>& usable,
                                                  const std::optional<Defect>& limit);

}  // namespace tetloft::internal::sections
