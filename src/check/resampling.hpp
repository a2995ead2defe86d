#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/findings.hpp"
#include "check/view.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::checking {

/// Contours of all sections of a stack in one sequence.
class ContourNumbers {
 public:
  explicit ContourNumbers(const SectionStack& stack);
  /// Contour c of section s; of the section behind the last, and 0, their number.
  [[nodiscard]] std::uint32_t of(std::size_t s, std::size_t c) const {
    return static_cast<std::uint32_t>(first_[s] + c);
  }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  [[nodiscard]] std::size_t section_count() const { return first_.size() - 1; }
  /// Where it is, in words.
  [[nodiscard]] std::string text(std::size_t contour) const;

 private:
  std::vector<std::size_t> first_;
};

/// What guarantee 2 learned of how the model's vertices lie on the contours of some sections.
struct OnContours {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// contour[v]: the contour that vertex v lies on, or kNone.
  std::vector<std::uint32_t> contour;
  /// Of each contour of these sections, in order: the model vertices along it, region on the left,
  /// from its first input vertex; empty where the model does not follow the contour.
  std::vector<std::vector<VertexId>> chain;
  double largest_split_ulps = 0;
  std::size_t off_contours = 0;  ///< corners of in-plane faces that lie on no contour

  /// Calls visit(k, c) for each corner of a tet or triangle k of these that lies on a contour, c.
  template <class Cells, class Visit>
  void for_each_corner(const Cells& cells, Visit&& visit) const {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (const VertexId v : cells[k]) {
        if (contour[v.index()] != kNone) visit(k, contour[v.index()]);
      }
    }
  }
  /// Which of the things that contours bound (`bounded`, by contour) each group of these tets or
  /// triangles meets: pairs of them, sorted. Those of group kNone are passed over.
  template <class Cells>
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::size_t>> bounds_met(
      const Cells& cells, std::span<const std::uint32_t> group,
      std::span<const std::size_t> bounded) const {
    std::vector<std::pair<std::uint32_t, std::size_t>> met;
    for_each_corner(cells, [&](std::size_t k, std::uint32_t c) {
      const std::pair<std::uint32_t, std::size_t> pair(group[k], bounded[c]);
      if (group[k] != kNone && (met.empty() || met.back() != pair)) met.push_back(pair);
    });
    sort_distinct(met);
    return met;
  }
};

struct Resampling {
  Findings findings;
  OnContours on_contours;
};

/// Guarantee 2, conditions 2.1 to 2.14 of README.md: the model meets the planes of these sections
/// in exactly their regions. In `refined`, which is the stack, they get the model's inserted
/// vertices; contours that the model does not follow, and sections that it bends so that they are
/// not valid, stay as they are in the input. 2.1 is asked of all planes. Requires a valid stack.
[[nodiscard]] Resampling check_resampling(const ModelView& view, const SectionStack& stack,
                                          const ContourNumbers& numbers,
                                          const SectionRange& sections, const CheckOptions& options,
                                          SectionStack& refined);

}  // namespace tetloft::internal::checking
