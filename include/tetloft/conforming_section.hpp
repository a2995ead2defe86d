// One section, triangulated so that its contours are unions of edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

enum class EdgeKind : std::uint8_t {
  internal,  ///< I: in the interior of the region
  external,  ///< E: outside it
  contour,   ///< C: on a contour
};

/// One section, triangulated: the conforming Delaunay triangulation of its contours, with
/// every edge classified (Nonato et al. 2000, section 3.1). The triangulation is that which
/// the 3D Delaunay triangulation of either slab induces in the plane.
struct TETLOFT_API ConformingSection {
  struct Edge {
    PlaneVertexId a, b;  ///< a < b
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

  IdVector<PlaneVertexId, ContourId> contour;  ///< the contour a vertex lies on; invalid inside
  IdVector<PlaneVertexId, RegionId> region;  ///< the region that this contour bounds, or around it
  IdVector<PlaneVertexId, PlaneVertexId> next;  ///< along the contour, region on the left
  IdVector<PlaneVertexId, PlaneVertexId> previous;
  /// Index of the vertex in its input contour; kNotInput for split vertices.
  IdVector<PlaneVertexId, std::size_t> input_vertex;
  /// For split vertices the input edge it lies on: from vertex edge_of to its successor in
  /// the input contour. For input vertices the vertex itself.
  IdVector<PlaneVertexId, std::size_t> edge_of;
  Nesting nesting;
  /// The contours whose edges were refined until they were Gabriel; empty: none.
  IdVector<ContourId, bool> gabriel;

  [[nodiscard]] std::size_t vertex_count() const { return contour.size(); }
  [[nodiscard]] const Point2& point(PlaneVertexId v) const { return triangulation.points[v]; }
  [[nodiscard]] Point3 point3(PlaneVertexId v) const {
    return {triangulation.points[v].x, triangulation.points[v].y, z};
  }
  /// The edge between two vertices in either order, or invalid.
  [[nodiscard]] EdgeId find_edge(PlaneVertexId u, PlaneVertexId v) const;
  /// The triangle of three vertices in any order, or invalid.
  [[nodiscard]] TriangleId find_triangle(PlaneVertexId u, PlaneVertexId v, PlaneVertexId w) const;
};

/// A contour edge that is divided into equal parts: from vertex `edge` to its successor.
struct EdgeDivision {
  ContourId contour;
  std::size_t edge = 0;
  std::uint32_t parts = 1;
  friend bool operator==(const EdgeDivision&, const EdgeDivision&) = default;
};

struct ConformOptions {
  /// Contours whose edges are refined until they are Gabriel: none, or one flag for each.
  IdVector<ContourId, bool> gabriel = {};
  /// Further vertices, strictly inside the region, distinct from each other and from contour
  /// vertices; they lie on no contour.
  std::vector<Point2> interior = {};
  /// Points off the region and its contours: contour edges are split until none of these lies in
  /// the circumcircle of a triangle inside the region. They become no vertices.
  std::vector<Point2> apart = {};
  /// Edges that are divided before anything else, by contour and edge, each once. What lies between
  /// parts are split vertices, computed from the edge's canonical lower end and rounded, none where
  /// parts are below the spacing of doubles. Together with them the contours must be valid.
  std::vector<EdgeDivision> divided = {};
  /// At most so many vertices are inserted, those that divide edges not counted; 0: as
  /// ConformingOptions has it.
  std::size_t most_inserted = 0;
  Execution execution = {};
};

/// Conforms one valid section; `id` is for messages. Split vertices bend the contour by rounding;
/// what changed is validated again. Fails (unrepresentable, naming contour and vertex) where
/// rounding leaves no valid conforming section, (invalid_input) where an interior vertex is not
/// inside or a contour has fewer than three finite vertices, (usage) where there are not as many
/// Gabriel flags as contours, or divisions are out of order or of edges that there are not, and
/// (work_limit, naming contour and vertex) where more than `most_inserted` vertices would be
/// inserted.
[[nodiscard]] TETLOFT_API Result<ConformingSection> conform(const Section& section, SectionId id,
                                                            const ConformOptions& options = {});

}  // namespace tetloft
