// The boundary of a region whose pieces are known, as contours that do not touch each other.
//
// At a vertex of degree four or more the boundary would touch itself: pieces of the region are
// parted there, by cutting off corners.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/section_stack.hpp>

#include "sections/arrangement.hpp"
#include "sections/region_sides.hpp"

namespace tetloft::internal::sections {

class BoundaryTrace {
 public:
  BoundaryTrace(const Arrangement& arrangement, const RegionSides& sides);

  /// Of a piece of the boundary there.
  struct Touching {
    ContourId contour;
    Point2 at;
  };
  /// The vertices at which pieces of the region are parted.
  [[nodiscard]] std::vector<Touching> touching() const;

  /// The contours, each with that of the given ones in which it begins, in the order of those;
  /// corners are cut off so deep.
  [[nodiscard]] std::vector<std::pair<ContourId, Contour>> contours(double cut) const;

 private:
  struct Piece {
    NodeId a, b;
    ContourId contour;
    bool left;  // of a → b: region? The other side is none then
  };
  struct NodePieces {
    std::vector<std::size_t> pieces;   // all at the node, counter-clockwise
    std::vector<std::size_t> partner;  // partner[k]: place in `pieces` where the boundary goes on
    std::vector<bool> cut;             // cut[k]: the corner of pieces[k] and its partner
  };

  [[nodiscard]] const Point2& at(NodeId n) const { return arrangement_.at(n); }
  [[nodiscard]] NodeId other_end(std::size_t piece, NodeId n) const {
    return pieces_[piece].a == n ? pieces_[piece].b : pieces_[piece].a;
  }
  void part(NodeId n, NodePieces& here);
  [[nodiscard]] Point2 near_node(NodeId n, std::size_t piece, double cut) const;

  const Arrangement& arrangement_;
  std::vector<Piece> pieces_;
  IdVector<NodeId, NodePieces> at_node_;
  std::vector<NodeId> touching_;
};

}  // namespace tetloft::internal::sections
