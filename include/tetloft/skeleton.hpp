// Voronoi skeletons of sections, and where those of neighbours cross.
#pragma once

#include <compare>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft {

/// One edge of a Voronoi skeleton: the dual of a Delaunay edge.
struct SkeletonEdge {
  EdgeId dual;          ///< the I or E edge
  EdgeKind kind;        ///< internal or external
  ContourId contour_a;  ///< contours of the ends of the dual edge
  ContourId contour_b;
  TriangleId left, right;  ///< its ends are their circumcentres; right invalid: a ray
  Point2 from;             ///< circumcentre of left
  Point2 to;               ///< circumcentre of right, or the direction of the ray
  bool ray = false;
};

/// The internal or external Voronoi skeleton of a section (Nonato et al. 2000, section
/// 3.1): the duals of its I or E edges, by edge id; empty for any other kind. Here and below,
/// `section` is as conform() made it; std::invalid_argument where ids or sizes show that it is not.
[[nodiscard]] TETLOFT_API std::vector<SkeletonEdge> voronoi_skeleton(
    const ConformingSection& section, EdgeKind kind);
/// The part of it dual to edges with an end on `contour`.
[[nodiscard]] TETLOFT_API std::vector<SkeletonEdge> voronoi_skeleton(
    const ConformingSection& section, EdgeKind kind, ContourId contour);

/// Two edges of the skeletons of neighbouring sections that meet in projection on one plane.
struct SkeletonCrossing {
  EdgeId below, above;  ///< the edges they are dual to
  /// They cross at one point inside both; otherwise they only touch, at an end of one of them
  /// (or all along, where they lie on one line).
  bool proper = false;
  friend auto operator<=>(const SkeletonCrossing&, const SkeletonCrossing&) = default;
};

/// Where the internal skeleton of one section crosses the internal or external skeleton of the
/// other, sorted; exact, whatever z. (1) Where they cross properly, every Delaunay triangulation
/// of both sections' vertices has the tet of the two dual edges. (2) If one has it, they meet
/// (Nonato et al. 2000, Proposition 1). Skeletons that only touch decide nothing.
[[nodiscard]] TETLOFT_API std::vector<SkeletonCrossing> skeleton_crossings(
    const ConformingSection& below, const ConformingSection& above);

/// Two contours of neighbouring sections that are geometrically well positioned: skeleton edges
/// of theirs cross as above (Nonato et al. 2000, Definition 1). An edge belongs to the contours
/// of both ends of its dual.
struct WellPositioned {
  ContourId below, above;
  bool proper = false;  ///< one crossing is proper; otherwise their skeletons only touch
  friend auto operator<=>(const WellPositioned&, const WellPositioned&) = default;
};

/// All such pairs, sorted.
[[nodiscard]] TETLOFT_API std::vector<WellPositioned> well_positioned(
    const ConformingSection& below, const ConformingSection& above);

}  // namespace tetloft
