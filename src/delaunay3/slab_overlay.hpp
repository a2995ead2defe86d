// The 3D Delaunay triangulation of two parallel planes, from the 2D triangulations of each:
// the overlay of their Voronoi diagrams (Boissonnat, CVGIP 44, 1988; see src/
// delaunay3/README.md, "Two planes").
//
// A point c of the plane together with a height is the centre of an empty sphere through a
// site of each plane: the nearest below and the nearest above. Hence the tets are the vertices
// of the overlay:
// - type 1 below: a triangle of the lower plane with the upper site whose cell holds its
//   circumcentre; type 1 above likewise;
// - type 2: an edge of each plane whose Voronoi edges cross.
// Tets are neighbours along the pieces into which the overlay cuts Voronoi edges.
//
// All sites carry infinitesimal weights (predicates.hpp): no vertex of one diagram lies on
// the other and no Voronoi edges overlap, so the overlay has no special cases.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <tetloft/delaunay2.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/tet_mesh.hpp>

#include "core/watched_work.hpp"
#include "delaunay3/tet_slot.hpp"

namespace tetloft::internal::delaunay3_detail {

/// Side i of triangle t of a Triangulation2, 4 t + i: the edge opposite vertex i.
using TriangleSideId = Id<struct TriangleSideTag>;

[[nodiscard]] inline TriangleSideId side_of(TriangleId t, std::size_t i) {
  return TriangleSideId(4 * t.value() + static_cast<std::uint32_t>(i));
}
[[nodiscard]] inline TriangleId triangle_of(TriangleSideId side) {
  return TriangleId(side.value() / 4);
}
[[nodiscard]] inline std::size_t side_number(TriangleSideId side) { return side.value() & 3U; }

/// What a tet of a slab has in its planes: type 1 a triangle, named by its side 0, in one of them;
/// type 2 an edge in each, named by either of its sides.
struct TetBase {
  TriangleSideId lower;
  TriangleSideId upper;
};

/// By triangle of a plane: the edges opposite its vertices.
using EdgesOfSides = IdVector<TriangleId, std::array<EdgeId, 3>>;

/// The triangulation of two planes, and what its tets have in these.
struct SlabTets {
  TetMesh mesh;
  IdVector<TetId, TetBase> base;
  /// Of the lower plane, of the upper one. Edges are numbered by their lower ends, then by their
  /// higher ones.
  std::array<EdgesOfSides, 2> edges;
};

/// How vertices are named outside.
struct SlabVertexNames {
  /// By vertex, the lower plane's first; empty: their own numbers.
  std::span<const VertexId> input_of;
  std::size_t input_count = 0;
};

/// The unique perturbed triangulation of two planes, the upper one above, numbered canonically
/// (struct Delaunay3). Linear in vertices and tets but for turning around vertices of high degree.
/// Requires two triangulations as by delaunay2, with triangles, vertices in canonical order,
/// together fewer than 2^29. Nothing where it would take more than `most_tets`, of which no more
/// are made; these are fewer than 2^30. Tells one step, when all crossings are known.
[[nodiscard]] std::optional<TetMesh> slab_overlay(const Triangulation2& lower,
                                                  const Triangulation2& upper,
                                                  const SlabVertexNames& names, WatchedWork& work,
                                                  std::size_t most_tets = kMostTetSlots);

/// The same with the bases of all tets; vertices are the lower plane's, then the upper's. Tells no
/// step.
[[nodiscard]] std::optional<SlabTets> slab_overlay_with_bases(
    const Triangulation2& lower, const Triangulation2& upper, const WatchedWork& work,
    std::size_t most_tets = kMostTetSlots);

}  // namespace tetloft::internal::delaunay3_detail
