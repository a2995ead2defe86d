// Coarse contours divided: which sections can be, and what is said of those that cannot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

/// Are coarse contours divided by these options? Reverse tetrahedra are those of the contours as
/// they are.
[[nodiscard]] bool divides_coarse(const ReconstructOptions& options);

/// How a section is divided, or why it is not.
struct SectionDivision {
  std::vector<EdgeDivision> edges;  ///< none where nothing is to be divided
  std::optional<std::string> refused;
};

/// Of a section of a stack whose edges are long above `least_long` (sections/coarse_edges.hpp),
/// between these neighbours. Refused where too many vertices would be inserted, or rounding makes
/// contours invalid.
[[nodiscard]] SectionDivision divide_section(const Section& section,
                                             std::span<const Section* const> neighbours,
                                             double least_long);

/// That contours of the section were taken as they are.
[[nodiscard]] Warning not_divided(SectionId s, const std::string& reason);

}  // namespace tetloft::internal
