// Pits: holes of one section that are sealed in the slab although the exterior of the other
// section lies across them.
//
// Where a hole with all of its rim is nearest to one vertex q of the other section, the rim's
// tets are an annulus in the link of q, and completion fills what it encloses (hole in the
// link): a bubble, once the next slab is glued on. The same happens at several vertices that
// share the hole, by runs around the edges between them. CUT cannot part the annulus, which is
// attached wherever it is kept.
//
// Such a hole is opened by *exterior vertices*: copies of its rim's vertices in the other
// plane, as far as they lie outside the region there, and outside all circles of internal
// triangles. These triangles are then those of D as before, and so is all that slabs share.
// Exterior vertices belong to no region; their class is empty and never active. The tets
// over the hole now go to them instead of q, and where the rim's do, truncation ends the
// class half way, as towards any foreign vertex. Pieces have weight above 1/2: no exterior
// vertex is one of the solid.
//
// A hole is *sealed* iff the tets on its external triangles are each attached at all three
// corners, to one class. Holes that are not sealed are left as they are. A hole with its rim
// inside the region across ends there, and stays closed: no copy of its vertices lies outside.
// Coarse contours across can leave no room: their triangles have large circles.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "completion/complex.hpp"
#include "sections/contour_edges.hpp"

namespace tetloft::internal {

/// The section with further vertices outside its region, which lie on no contour. Requires
/// points that are distinct, outside the region, and outside all circles of internal
/// triangles.
[[nodiscard]] ConformingSection with_exterior_vertices(const ConformingSection& section,
                                                       const std::vector<Point2>& exterior);

/// The holes of a slab and what opens them.
class Pits {
 public:
  /// Both sections must outlive this.
  Pits(const ConformingSection& lower, const ConformingSection& upper);

  /// The sections to build the slab from: with the exterior vertices so far.
  [[nodiscard]] const ConformingSection& lower() const { return side_[0].current(); }
  [[nodiscard]] const ConformingSection& upper() const { return side_[1].current(); }
  /// How many holes are opened.
  [[nodiscard]] std::size_t opened() const { return opened_; }

  /// Opens the holes that this complex, of lower() and upper(), seals, where that is possible
  /// and was not tried before. True iff that is one at least: the slab is to be built again.
  bool open_sealed(const Slab& slab, const SlabClasses& classes, const Complex& complex);
  /// Takes all exterior vertices back, and opens no more.
  void give_up();

  /// Can a vertex of both planes be put here, off both regions and the circles of their triangles?
  [[nodiscard]] bool has_room(const Point2& p);
  /// Puts one here in both planes: D has the edge between, and no class either end, so that what is
  /// around the edge stays void. Requires has_room(). False if there is one already.
  bool open_at(const Point2& p);
  /// Takes back those of open_at().
  void close_pairs();
  [[nodiscard]] std::size_t pairs() const { return pairs_.size(); }

  /// The vertex of the slab without exterior vertices; invalid for these.
  [[nodiscard]] IdVector<SlabVertexId, SlabVertexId> original_numbers() const;

 private:
  struct Side {
    const ConformingSection* section;
    std::optional<sections::ContourEdges> contours;  // of `section`, once they are asked for
    std::optional<ConformingSection> extended;
    std::vector<Point2> exterior;               // vertices of `extended`
    IdVector<ContourId, std::uint8_t> to_open;  // the holes that were not tried yet
    [[nodiscard]] const ConformingSection& current() const {
      return extended ? *extended : *section;
    }
  };

  [[nodiscard]] std::vector<ContourId> sealed_holes(const Slab& slab, const SlabClasses& classes,
                                                    const Complex& complex, bool upper) const;
  void open(ContourId hole, bool upper);
  void extend();

  std::array<Side, 2> side_;  // lower, upper
  std::size_t opened_ = 0;
  std::vector<Point2> pairs_;
  bool given_up_ = false;
};

}  // namespace tetloft::internal
