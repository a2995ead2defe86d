// The surroundings of a seam: the tets of the segments on its two sides that have a vertex in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>

#include "check/view.hpp"

namespace tetloft::internal::checking {

/// What the tets of a segment are parts of, by numbers of the whole.
struct SegmentNumbering {
  std::vector<std::uint32_t> component;       ///< by sound tet
  std::vector<std::uint32_t> part;            ///< likewise: of its slab
  std::vector<std::uint32_t> boundary_patch;  ///< by triangle of the boundary
};

/// One side. Vertices of the seam come first, in the order of the section, then others.
struct SeamSide {
  std::vector<Point3> points;
  std::vector<VertexId> number;  ///< of each, in the whole
  std::size_t seam_vertices = 0;
  std::vector<TetVertices> tets;
  // By tet.
  std::vector<TetId> id;
  std::vector<std::uint32_t> component;
  std::vector<std::uint32_t> part;
  /// The patch that face i of tet t is of; kNone: none.
  std::vector<std::array<std::uint32_t, 4>> patch;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
};

/// Of the seam of this number, of a segment's view.
[[nodiscard]] SeamSide side_of(const ModelView& segment, std::uint8_t seam,
                               const SegmentNumbering& numbering);

/// Both sides as one view. Their seams are the same.
struct Seam {
  Model model;
  ModelView view;
  std::size_t first_upper = 0;  ///< of the sound tets
  std::vector<std::uint32_t> component, part;
  /// By triangle of the boundary; of those in the seam kNone.
  std::vector<std::uint32_t> boundary_patch;
};
/// The view points into the model, which is not to be copied.
void join_sides(const SeamSide& lower, const SeamSide& upper, const SectionStack& stack,
                Seam& seam);

}  // namespace tetloft::internal::checking
