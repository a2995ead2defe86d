// Contours of few vertices, whose edges are long for what lies around them: which of them are to be
// divided, so that what lies between two sections follows both.
//
// D between two planes overlays the Voronoi diagrams of their vertices. Where edges are short
// against the width of their section these diagrams are near the medial axes of the contours;
// else they are those of a few points, whatever the contours are.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

/// Edges of a stack's coarse contours are long above this: some times the usual edge of its
/// contours that are not coarse, 0 where all are.
[[nodiscard]] double least_long_edge(const SectionStack& stack);

/// How many of something are coarse, of how many.
struct CoarseShare {
  std::size_t coarse = 0;
  std::size_t all = 0;
  void add(const CoarseShare& more) {
    coarse += more.coarse;
    all += more.all;
  }
  [[nodiscard]] bool is_half() const { return 2 * coarse >= all; }
};

/// Of a section's vertices: those on contours of few.
[[nodiscard]] CoarseShare coarse_vertices(const Section& section);

/// least_long_edge() of sections that come one after the other.
class EdgeTally {
 public:
  /// Calls keep(length) for the edges that the usual one is found among.
  void add(const Section& section, const std::function<void(double)>& keep);

  /// Of all vertices.
  [[nodiscard]] const CoarseShare& vertices() const { return vertices_; }

  /// Calls visit with all lengths that were kept, in increasing order, until it returns false.
  using Increasing = std::function<void(const std::function<bool(double)>& visit)>;
  [[nodiscard]] double least_long(const Increasing& lengths) const;

 private:
  CoarseShare vertices_;
  CoarseShare sections_;  // that have any: of how many half of the vertices are on coarse contours
};

/// How a section between these neighbours, one or two, is to be divided, by contour and edge:
/// (1) of a coarse contour the edges longer than `least_long`, but for those that lie on contours
/// of each neighbour that has any; (2) into pieces of about a quarter of the width there, 16 at
/// most; (3) and their neighbours on the contour into pieces no longer than theirs, with the same
/// limit. A function of the sets of contours, neither of their order, starts nor directions.
[[nodiscard]] std::vector<EdgeDivision> divide_coarse_edges(
    const Section& section, std::span<const Section* const> neighbours, double least_long);

/// The section with its edges divided, as conform() divides them.
[[nodiscard]] Section divided(const Section& section, std::span<const EdgeDivision> divisions);

}  // namespace tetloft::internal::sections
