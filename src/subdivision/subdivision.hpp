// Subdivision (the paper's TSP): attached tets are split at the midpoints of their external
// edges, so that nothing of the solid but the region itself stays in a section plane.
//
// An external edge gets its midpoint iff some class keeps a tet of its ring with an attached
// end. Type-1 tets fall into 1 to 4 children, type-2 tets into 1, 2 or 4 (Nonato et al.
// 2000, figures 7 and 8). Children of neighbouring tets conform, since only edges are split;
// the diagonal of a quadrilateral left on an external triangle lies on the underside, which
// no neighbour sees. A type-1 tet over a triangular hole (three contour edges) has no edge
// to split and gets a vertex inside its triangle.
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
  std::vector<Child> children;  ///< positive once lifted, of all attached tets by id
};

[[nodiscard]] Subdivision subdivide(const Slab& slab, const Complex& complex, RuleCounts& rules);

}  // namespace tetloft::internal
