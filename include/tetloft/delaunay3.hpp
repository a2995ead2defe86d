// Delaunay triangulations of points in space.
//
// The unique triangulation of the symbolically perturbed predicates (predicates.hpp): it
// depends on the set of points only, never on input order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tetloft/delaunay2.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft {

/// How a 3D triangulation is computed; the result is the same.
enum class DelaunayEngine : std::uint8_t {
  automatic,    ///< slab where all points lie on two planes of constant z, else incremental
  incremental,  ///< insertion of point after point, for any points
  slab,         ///< overlay of two plane Voronoi diagrams, for points on two planes only
};
[[nodiscard]] TETLOFT_API const char* name_of(DelaunayEngine engine);

struct Delaunay3Options {
  DelaunayEngine engine = DelaunayEngine::automatic;
  /// Refused (work_limit) while it works, as soon as it would take more tets at a time; 0: no
  /// limit. Of n points some sets have n² / 2 tets: on two skew curves, for instance.
  std::size_t most_tets = 0;
  /// The incremental engine shares parts of space and the numbering between all threads, the slab
  /// engine the two planes. With most_tets points are inserted on one thread, as how many
  /// tets there are at a time depends on their order.
  Execution execution = {};
};

/// The 3D Delaunay triangulation of a point set.
struct Delaunay3 {
  /// Vertices are the input points by index. Tets are positive, numbered canonically: each
  /// tet's vertices are an even permutation of increasing canonical rank (the last two
  /// swapped where the orientation asks for it), tets sorted by their ranks. Without tets
  /// if dimension < 3. Its boundary is the convex hull.
  TetMesh mesh;
  /// Dimension of the affine hull: −1 without points, 0 one point, 1 collinear, 2
  /// coplanar, 3 otherwise.
  int dimension = -1;
  /// representative[v] is v, or for a duplicate the lowest index with the same point; a
  /// duplicate is in no tet.
  IdVector<VertexId, VertexId> representative;
  std::size_t duplicates = 0;
  /// The engine that ran.
  DelaunayEngine engine = DelaunayEngine::incremental;
};

/// Incremental insertion (Bowyer 1981; Watson 1981) in spatially sorted order with a
/// ghost vertex, or slab_delaunay3(). Refused (invalid_input) where a coordinate is not finite,
/// naming the vertex, (usage) for an engine that there is none of, and where the slab engine is
/// asked for but the points do not lie on two planes of constant z, three at least on each and not
/// in a row.
[[nodiscard]] TETLOFT_API Result<Delaunay3> delaunay3(std::span<const Point3> points,
                                                      const Delaunay3Options& options = {});

/// The 3D Delaunay triangulation of two planes of constant z, given the triangulation of each:
/// the overlay of their Voronoi diagrams (Boissonnat 1988). It does not depend on the distance
/// of the planes. Tets and their numbering are those of delaunay3 for the points of `lower`,
/// then of `upper`, in some plane above. Linear in vertices and tets.
/// Requires of both: Delaunay triangulations as by delaunay2, with triangles, their points
/// distinct and in canonical order; together fewer than 2^29. Refused (invalid_input) where
/// that does not hold, as far as it shows from sizes, order, ids and neighbours, and at 2^30 tets
/// or more; and (work_limit) while it works, as soon as there are more than `most_tets`; 0: no
/// limit.
[[nodiscard]] TETLOFT_API Result<TetMesh> slab_delaunay3(const Triangulation2& lower,
                                                         const Triangulation2& upper,
                                                         std::size_t most_tets = 0,
                                                         const Execution& execution = {});

}  // namespace tetloft
