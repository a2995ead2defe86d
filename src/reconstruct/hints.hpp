// Remedies that are known, told as warnings where a stack shows signs of needing them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/model.hpp>

#include "correspondence/correspondence.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// Contours of so few vertices, linked ones, that between them hardly anything of either can be
/// followed: refine().
[[nodiscard]] std::optional<Warning> hint_of_coarse_contours(const PreparedStack& prepared,
                                                             const Correspondence& decided);

/// Most regions meet none of a neighbouring section, as they lie or as they are moved: the gaps
/// are too large for them, or z has another unit.
[[nodiscard]] std::optional<Warning> hint_of_missing_partners(const PreparedStack& prepared,
                                                              const StackCandidates& candidates);

// The same of windows (README.md, "Clusters"), which know the sections beside their own ones, and
// what is linked there; added from below they are those of the whole.

/// How much of a stack's contours is edges that the neighbouring sections do not continue.
struct Coarseness {
  double length = 0;
  double divided = 0;           ///< of the length
  std::vector<double> quarter;  ///< area over perimeter, of each contour with such edges
};
/// Adds the sections from `first` to before `end`. `links`: of the window's slabs.
void add_coarseness(const PreparedStack& window, const IdVector<SlabId, std::vector<Link>>& links,
                    SectionId first, SectionId end, Coarseness& sum);
/// Of a stack where half of the vertices lie on contours of few (sections/coarse_edges.hpp).
[[nodiscard]] std::optional<Warning> hint_of(const Coarseness& whole, int exponent);

struct PartnerCounts {
  std::size_t regions = 0;  ///< that have a neighbouring section that is not empty
  std::size_t without = 0;
};
void add_partners(const PreparedStack& window, const StackCandidates& candidates, SectionId first,
                  SectionId end, PartnerCounts& sum);
[[nodiscard]] bool misses_partners(const PartnerCounts& whole);
/// The side of a square of the same area, of each region, holes left out.
void append_sizes(const Section& section, const Nesting& nesting, std::vector<double>& sizes);
/// Told where partners are missed; gaps between sections and sizes of regions are of the whole.
[[nodiscard]] Warning hint_of(const PartnerCounts& whole, std::vector<double> gaps,
                              std::vector<double> sizes, int exponent);

/// A slab of far more tets than its vertices call for: round contours of many vertices about nearly
/// the same centre, whose Voronoi diagrams are all but equal there: snap().
[[nodiscard]] std::optional<Warning> hint_of_many_tets(const PreparedStack& prepared,
                                                       const Model& model);

}  // namespace tetloft::internal
