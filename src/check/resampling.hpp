#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/findings.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// What guarantee 2 learned of how the model's vertices lie on the contours.
struct OnContours {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Contours of all sections are numbered in one sequence: here, contour c of section s.
  [[nodiscard]] std::uint32_t number(std::size_t s, std::size_t c) const {
    return static_cast<std::uint32_t>(first[s] + c);
  }
  std::vector<std::size_t> first;  ///< per section; the number of contours at the end

  /// contour[v]: the contour that vertex v lies on, or kNone.
  std::vector<std::uint32_t> contour;
  /// chain[c]: the model vertices along contour c, region on the left, from its first input
  /// vertex; empty where the model does not follow the contour.
  std::vector<std::vector<VertexId>> chain;
  double largest_split_ulps = 0;
  std::size_t off_contours = 0;  ///< corners of in-plane faces that lie on no contour
};

struct Resampling {
  Findings findings;
  OnContours on_contours;
  /// The stack with the model's inserted vertices; contours that the model does not follow,
  /// and sections that it bends so that they are not valid, as they are in the input.
  SectionStack refined;
};

/// Guarantee 2, conditions 2.1 to 2.14 of README.md: the model meets each section plane in
/// exactly the section's region. Requires a valid stack.
[[nodiscard]] Resampling check_resampling(const ModelView& view, const SectionStack& stack,
                                          const CheckOptions& options);

}  // namespace tetloft::internal::checking
