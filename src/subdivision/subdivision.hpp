// Subdivision (the paper's TSP): attached tets are split at the midpoints of their external
// edges, so that nothing of the solid but the region itself stays in a section plane.
//
// An external edge gets its midpoint iff some class keeps a tet of its ring with an attached
// end. Type-1 tets fall into 1 to 4 children, type-2 tets into 1, 2 or 4 (Nonato et al.
// 2000, figures 7 and 8). Children of neighbouring tets conform, since only edges are split;
// the diagonal of a quadrilateral left on an external triangle lies on the underside, which
// no neighbour sees. A type-1 tet over a triangular hole (three contour edges) has no edge
// to split and gets a vertex inside its triangle.
//
// Most tets are *whole*: without an external edge, attached at all four corners for one class.
// Nothing is split, lifted or cut off there, so they are pieces of the solid as they are, and
// none of the steps from here to the embedding sees them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "completion/complex.hpp"
#include "subdivision/nodes.hpp"

namespace tetloft::internal {

/// A vertex that will leave its section plane: the midpoint of an external edge, or the
/// interior vertex of a triangular hole.
struct LiftedVertex {
  std::array<SlabVertexId, 3> of;  ///< ends of the edge, or corners; of[2] invalid for edges
  bool upper = false;              ///< its plane
  Point3 base;                     ///< in the plane, rounded once
  Point3 target;                   ///< mean of the opposite-plane vertices of its edge's ring
};

/// A tet of the subdivided slab.
struct Child {
  std::array<NodeId, 4> node;
  /// The parent's corners that a node is the mean of, as masks: one bit for a vertex, two
  /// for a midpoint, three for the interior of a triangular hole.
  std::array<std::uint8_t, 4> mean_of{};
  TetId parent;
};

struct Subdivision {
  Nodes nodes;  ///< slab vertices and lifted ones
  IdVector<LiftedId, LiftedVertex> lifted;
  /// Of all attached tets that are not whole, by id; positive once lifted.
  std::vector<Child> children;
  IdVector<TetId, std::uint8_t> whole;  ///< whether a tet is
};

/// In which order pieces of a tet list what comes of its corners: of type 1 its triangle's first,
/// of type 2 the lower ones. An even permutation. `upper` is the mask of corners in the upper
/// plane.
[[nodiscard]] const std::array<int, 4>& corners_by_plane(std::uint8_t upper);

[[nodiscard]] Subdivision subdivide(const Slab& slab, const SlabClasses& classes,
                                    const Complex& complex, RuleCounts& rules);

}  // namespace tetloft::internal
