// Separation of classes by truncation.
//
// For one class, a corner of a child has weight 1 if all of the parent's corners it is the
// mean of are attached own corners, 1/2 for a midpoint with one such end or one that is
// trimmed (trimming.hpp), else 0. The piece
// of the class in the child is what is left when every edge from a corner of weight 1 to a
// lighter one is cut at a weight in (1/2, 1): a tet or a prism. Weights of all classes add
// up to at most 1, and the piece lies in the hull of its vertices: pieces of two classes
// are disjoint. Cuts are shared by all children around their edge, so pieces conform.
//
// A cut lies at most κ gaps sideways of the corner that is kept, and half as far from one
// that hangs over itself: without that limit ends of components grow into long thin spikes
// towards the next foreign contour.
#pragma once

#include <array>
#include <vector>

#include "subdivision/subdivision.hpp"

namespace tetloft::internal {

/// Cuts are at weight 1/2 + ε where nothing asks for more. Two classes that share an edge
/// end 2 ε of its length apart. Any ε in (0, 1/2) keeps the proof. 1/16 is a choice: solids
/// nearly fill their share of the edge, and what parts them, 1/8 of it, is far above rounding.
/// What twice or half as much changes: README.md, "Constants".
inline constexpr double kSeparation = 0x1p-4;
/// κ: the most a cut may lie sideways of the corner kept, in gaps. A choice: an end leans by less
/// than 45° where its cut is half the gap up. More allows longer spikes, less makes cuts nearly
/// coincide with their corner, which costs lift (README.md, "Constants").
inline constexpr double kLargestLean = 0.5;

/// The cut of one directed edge of the subdivided slab.
struct Cut {
  NodeId kept;
  NodeId away;
  bool towards_half = false;  ///< `away` has weight 1/2, not 0
  bool from_lifted = false;   ///< `kept` is a lifted vertex
  double scale = 1;           ///< halved where rounding or contact asks for it
};

/// A tet of the solid.
struct Piece {
  std::array<NodeId, 4> node;
  SlabRegionId region;  ///< some region of its class
  TetKind kind = TetKind::cc;
};

struct Truncation {
  Nodes nodes;                ///< slab vertices, lifted ones and cuts
  IdVector<CutId, Cut> cuts;  ///< sorted by (kept, away)
  /// Of tets that are not whole (subdivision.hpp), by parent.
  std::vector<Piece> pieces;
  std::vector<TetId> parent;  ///< of each piece
};

[[nodiscard]] Truncation truncate(const Slab& slab, const SlabClasses& classes,
                                  const Complex& complex, const Subdivision& subdivision,
                                  const IdVector<LiftedId, std::uint8_t>& trimmed);

/// Where a cut lies, from its two ends as placed.
[[nodiscard]] Point3 place_cut(const Cut& cut, const Point3& kept, const Point3& away, double gap);

/// Splits the prism with triangles (a, b, c) and (d, e, f), edges a–d, b–e, c–f, into three
/// tets by diagonals from lowest ids. Tets are positive if (a, b, c, d) and the prism are.
[[nodiscard]] std::array<std::array<NodeId, 4>, 3> split_prism(const std::array<NodeId, 6>& prism);

}  // namespace tetloft::internal
