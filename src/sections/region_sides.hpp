// Which sides of the pieces of an arrangement, and of contours without contact, belong to the
// region by a fill rule.
//
// Faces of a connected part of the arrangement are told apart by walking across its pieces, from
// the face around it on: what that one is inside of is counted on a ray. No coordinate is computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/repair.hpp>
#include <tetloft/section_stack.hpp>

#include "sections/arrangement.hpp"
#include "sections/fill_state.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

/// The pieces of an arrangement that have the same ends, a before b.
struct SidedPiece {
  NodeId a;
  NodeId b;
  std::size_t first = 0;  ///< of them, among Arrangement::pieces()
  std::size_t last = 0;   ///< one behind
  bool left = false;      ///< of a → b: region?
  bool right = false;
};

/// What lies around a contour without contact, and within.
struct ContourSides {
  bool outside = false;
  bool inside = false;
};

class RegionSides {
 public:
  /// Of a section with these contours in the arrangement, which is settled, and the others apart
  /// from it.
  RegionSides(const Arrangement& arrangement, const Section& section,
              const std::vector<bool>& in_arrangement, FillRule rule);

  [[nodiscard]] const std::vector<SidedPiece>& pieces() const { return pieces_; }
  /// Of contours that are not in the arrangement.
  [[nodiscard]] const ContourSides& of_contour(ContourId contour) const {
    return contour_sides_[contour];
  }
  /// Contours of which the boundary of the first lies partly inside and partly outside the second.
  [[nodiscard]] const std::vector<std::pair<ContourId, ContourId>>& overlapping() const {
    return overlapping_;
  }
  /// The edges of pieces that leave a node, 2 i for piece i from its lower end and 2 i + 1 from the
  /// other, counter-clockwise from −x on.
  [[nodiscard]] const std::vector<std::size_t>& leaving(NodeId n) const { return leaving_[n]; }
  [[nodiscard]] NodeId start(std::size_t edge) const {
    return edge % 2 == 0 ? pieces_[edge / 2].a : pieces_[edge / 2].b;
  }
  [[nodiscard]] NodeId end(std::size_t edge) const { return start(edge ^ 1U); }

 private:
  // An edge of a contour without contact, or a piece.
  struct Crossed {
    Point2 a, b;
    ContourId contour;  // invalid: a piece
    std::size_t piece = 0;
  };

  void collect_pieces();
  void sort_leaving();
  void trace_cycles();
  void find_parts();
  void collect_crossed(const Section& section, const std::vector<bool>& in_arrangement);
  void group_overlapping(IdVector<ContourId, std::uint32_t>& group);
  void find_contour_sides(const Section& section, const std::vector<bool>& in_arrangement,
                          const IdVector<ContourId, std::uint32_t>& group);

  template <class Skip>
  void add_ray(FillState& state, const Point2& p, int sign, Skip skip) const;
  void cross(FillState& state, std::size_t edge) const;
  template <class Visit>
  void for_each_cycle(FillState& state, Visit visit) const;
  template <class Visit>
  void walk_part(FillState& state, std::size_t start, std::vector<bool>& visited,
                 Visit visit) const;

  const Arrangement& arrangement_;
  FillRule rule_;
  std::size_t contours_;
  std::vector<SidedPiece> pieces_;
  IdVector<NodeId, std::vector<std::size_t>> leaving_;
  std::vector<std::size_t> next_;            // by edge: the next with the same face on its left
  std::vector<std::size_t> cycle_;           // by edge: which turn around a face it is part of
  std::vector<std::size_t> first_of_cycle_;  // an edge of it
  IdVector<NodeId, std::uint32_t> part_;     // connected parts of the arrangement
  std::vector<std::size_t> start_of_part_;   // an edge with the face around the part on its left
  std::vector<Crossed> crossed_;
  BoxTree2 crossed_tree_;
  IdVector<ContourId, ContourSides> contour_sides_;
  std::vector<std::pair<ContourId, ContourId>> overlapping_;
};

}  // namespace tetloft::internal::sections
