// Stacks of planar cross sections: values, exact validation, nesting, conforming
// sections, Voronoi skeletons, overlap of regions.
//
// Section i is the plane z = z_i with disjoint simple closed contours; its region is the
// set of points of odd crossing number. A connected region is an outer contour with its
// immediate holes.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/delaunay.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// A closed polygon in either direction; the first vertex is not repeated at the end.
struct Contour {
  std::vector<Point2> vertices;
};

struct Section {
  double z = 0;
  IdVector<ContourId, Contour> contours;
};

/// Sections by increasing z.
struct SectionStack {
  IdVector<SectionId, Section> sections;
  [[nodiscard]] std::size_t contour_count() const;
  [[nodiscard]] std::size_t vertex_count() const;
};

/// Verifies, exactly: at least one section and one contour; z strictly increasing; all coordinates
/// finite and of magnitude below kLargestCoordinate; contours simple, with at least three vertices
/// and non-zero area, pairwise without contact. The error names section, contour, vertex,
/// coordinates and the reason; the first defect by (section, contour, vertex) is reported. O(n log
/// n) for contours without long-range contact. Sections are verified on up to `threads` threads (0:
/// all processors), with the same result.
[[nodiscard]] Result<void> validate(const SectionStack& stack, unsigned threads = 1);

/// Constructed points (midpoints, lifted and cut points) neither over- nor underflow as
/// long as input coordinates stay below this.
inline constexpr double kLargestCoordinate = 0x1p1000;

/// Removes what changes nothing: a first vertex repeated at the end, consecutive
/// duplicate vertices. Returns one warning for each contour changed. Contours left with
/// fewer than three vertices stay as they are, for validate() to name.
std::vector<Warning> mend(SectionStack& stack);

/// Gaps between planes that are a thousandth, or less, of the gaps around them: one warning for
/// each, naming the upper section. A slice written as two planes becomes a body of its own where
/// its contours are parted. Only gaps between sections with contours, alone or two in a row, are
/// told: more than that is a finer sampling.
[[nodiscard]] std::vector<Warning> suspicious_gaps(const SectionStack& stack);

struct RepairOptions {
  /// How far the boundary may move; without it 2^-20 of the section's largest coordinate.
  std::optional<double> distance;
};

struct Repaired {
  SectionStack stack;            ///< valid, unless all contours cancelled
  std::vector<Warning> changes;  ///< all of them, with their places
  double moved = 0;              ///< how far the boundary moved at most
};

/// Repairs sections as they come from other tools: spikes, contours without area, crossings and
/// contacts of contours with themselves and each other. Sections keep their region, the points of
/// odd crossing number, up to `distance`: crossings become vertices, which moves edges by ulps;
/// edges that lie on each other cancel; where pieces of the region touch at a vertex they are
/// parted by cutting their corners off. Contours without contact stay as they are; the others
/// become new contours, numbered at the place of the one they begin with. What mend() removes is
/// removed too. A valid stack stays as it is. Refused (invalid_input, naming section and contour)
/// where that needs a larger distance. Takes O(n log n + k) for k pairs of edges whose extents in x
/// overlap.
[[nodiscard]] Result<Repaired> repair(const SectionStack& stack, const RepairOptions& options = {});

/// A vertex that snapping moved, and whereto.
struct MovedVertex {
  SectionId section;
  ContourId contour;
  std::size_t vertex = 0;
  Point2 from;
  Point2 to;
};

struct Snapped {
  SectionStack stack;
  std::vector<MovedVertex> moved;
  double lattice = 0;  ///< the power of two that x and y are multiples of now
  int bits = 0;        ///< log2 of (extent / lattice), ≥ what was asked for
};

/// Rounds x and y to the lattice of 2^-bits times the largest coordinate magnitude
/// (rounded up to a power of two); takes a finer lattice, bit by bit up to 50, while
/// snapping makes contours touch or degenerate; vertices that fall on their predecessor
/// are removed (and listed as moved there). Refused (usage) unless 1 ≤ bits ≤ 50, and
/// (invalid_input) where no lattice keeps the stack valid.
[[nodiscard]] Result<Snapped> snap(const SectionStack& stack, int bits);

struct Refined {
  SectionStack stack;
  std::size_t inserted = 0;  ///< vertices
};

/// Divides contour edges longer than `length` into equal parts no longer than it; points are
/// rounded once. Coarse contours, a rectangle of four vertices say, tell the Delaunay
/// triangulation little about what lies across: refined ones keep open what they close. Refused:
/// usage for a length that is not positive, or so small that 2^26 vertices do not suffice;
/// invalid_input for an invalid stack, or where rounding makes contours touch.
[[nodiscard]] Result<Refined> refine(const SectionStack& stack, double length);

/// The nesting of one valid section's contours.
struct Nesting {
  /// The innermost contour around it; invalid for outermost contours.
  IdVector<ContourId, ContourId> parent;
  /// Number of contours around it: even for outer contours, odd for holes.
  IdVector<ContourId, std::uint32_t> depth;
  /// The region that the contour bounds; regions are numbered by their outer contours in
  /// canonical order (lowest vertex).
  IdVector<ContourId, RegionId> region;
  IdVector<RegionId, ContourId> outer;  ///< the outer contour of a region
};

/// Requires a valid section: validate() tells.
[[nodiscard]] Nesting nest(const Section& section);

/// Twice the signed area of a closed polygon (positive iff counter-clockwise), rounded.
[[nodiscard]] double twice_area(const Contour& contour);
/// The exact sign of it.
[[nodiscard]] Sign area_sign(const Contour& contour);

enum class EdgeKind : std::uint8_t {
  internal,  ///< I: in the interior of the region
  external,  ///< E: outside it
  contour,   ///< C: on a contour
};

/// One section, triangulated: the conforming Delaunay triangulation of its contours, with
/// every edge classified (Nonato et al. 2000, section 3.1). The triangulation is that which
/// the 3D Delaunay triangulation of either slab induces in the plane.
struct ConformingSection {
  struct Edge {
    VertexId a, b;  ///< a < b
    EdgeKind kind = EdgeKind::external;
    /// The triangles to the left and right of a → b; invalid on the convex hull.
    TriangleId left, right;
  };
  static constexpr std::size_t kNotInput = static_cast<std::size_t>(-1);

  double z = 0;
  /// Vertices in canonical order (x, y).
  Triangulation2 triangulation;
  /// Per triangle: inside the region?
  IdVector<TriangleId, std::uint8_t> internal;
  /// All edges, sorted by (a, b).
  IdVector<EdgeId, Edge> edges;
  /// first_edge[v] … first_edge[v + 1]: the edges whose lower end is v.
  std::vector<std::uint32_t> first_edge;

  IdVector<VertexId, ContourId> contour;  ///< the contour a vertex lies on; invalid inside
  IdVector<VertexId, RegionId> region;    ///< the region that this contour bounds, or around it
  IdVector<VertexId, VertexId> next;      ///< along the contour, region on the left
  IdVector<VertexId, VertexId> previous;
  /// Index of the vertex in its input contour; kNotInput for split vertices.
  IdVector<VertexId, std::size_t> input_vertex;
  /// For split vertices the input edge it lies on: from vertex edge_of to its successor in
  /// the input contour. For input vertices the vertex itself.
  IdVector<VertexId, std::size_t> edge_of;
  Nesting nesting;
  /// The contours whose edges were refined until they were Gabriel; empty: none.
  IdVector<ContourId, bool> gabriel;

  [[nodiscard]] std::size_t vertex_count() const { return contour.size(); }
  [[nodiscard]] const Point2& point(VertexId v) const { return triangulation.points[v]; }
  [[nodiscard]] Point3 point3(VertexId v) const {
    return {triangulation.points[v].x, triangulation.points[v].y, z};
  }
  /// The edge between two vertices in either order, or invalid.
  [[nodiscard]] EdgeId find_edge(VertexId u, VertexId v) const;
  /// The triangle of three vertices in any order, or invalid.
  [[nodiscard]] TriangleId find_triangle(VertexId u, VertexId v, VertexId w) const;
};

/// Conforms one valid section. `gabriel`: per contour, refine its edges until they are
/// Gabriel (empty: none). `interior`: further vertices, strictly inside the region, distinct
/// from each other and from contour vertices; they lie on no contour. Split vertices bend the
/// contour by rounding; what changed is validated again. Fails (unrepresentable, naming contour
/// and vertex) where rounding leaves no valid conforming section, (invalid_input) where an
/// interior vertex is not inside, and (work_limit, naming contour and vertex) where more than
/// `most_inserted` vertices would be inserted; 0: as ConformingOptions has it.
[[nodiscard]] Result<ConformingSection> conform(const Section& section, SectionId id,
                                                const IdVector<ContourId, bool>& gabriel = {},
                                                std::span<const Point2> interior = {},
                                                std::size_t most_inserted = 0);

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
/// `section` is as conform() made it.
[[nodiscard]] std::vector<SkeletonEdge> voronoi_skeleton(const ConformingSection& section,
                                                         EdgeKind kind);
/// The part of it dual to edges with an end on `contour`.
[[nodiscard]] std::vector<SkeletonEdge> voronoi_skeleton(const ConformingSection& section,
                                                         EdgeKind kind, ContourId contour);

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
[[nodiscard]] std::vector<SkeletonCrossing> skeleton_crossings(const ConformingSection& below,
                                                               const ConformingSection& above);

/// Two contours of neighbouring sections that are geometrically well positioned: skeleton edges
/// of theirs cross as above (Nonato et al. 2000, Definition 1). An edge belongs to the contours
/// of both ends of its dual.
struct WellPositioned {
  ContourId below, above;
  bool proper = false;  ///< one crossing is proper; otherwise their skeletons only touch
  friend auto operator<=>(const WellPositioned&, const WellPositioned&) = default;
};

/// All such pairs, sorted.
[[nodiscard]] std::vector<WellPositioned> well_positioned(const ConformingSection& below,
                                                          const ConformingSection& above);

/// A region as a set of polygons with even-odd rule: its outer contour and its holes.
struct RegionOutline {
  std::vector<const Contour*> contours;
};
[[nodiscard]] RegionOutline outline(const Section& section, const Nesting& nesting,
                                    RegionId region);
/// The same of all regions, in time linear in the contours.
[[nodiscard]] IdVector<RegionId, RegionOutline> outlines(const Section& section,
                                                         const Nesting& nesting);

/// An exact comparison of areas: the sign of area(a ∩ b) / min(area a, area b) − tau, for
/// tau as the double it is. Interval arithmetic first, rationals where it cannot decide.
[[nodiscard]] Sign compare_overlap(const RegionOutline& a, const RegionOutline& b, double tau);
/// The same for two thresholds, for little more than the cost of one.
[[nodiscard]] std::array<Sign, 2> compare_overlap(const RegionOutline& a, const RegionOutline& b,
                                                  const std::array<double, 2>& taus);
/// The same ratio, for reports and for ordering by evidence: rounded to 32 significant
/// bits, halves up, so that equal ratios are equal doubles however they arise; exactly 0
/// iff the intersection has no area.
[[nodiscard]] double overlap_ratio(const RegionOutline& a, const RegionOutline& b);
[[nodiscard]] double area(const RegionOutline& region);

}  // namespace tetloft
