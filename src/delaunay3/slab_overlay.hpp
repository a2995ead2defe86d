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

#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/ids.hpp>

#include "core/watched_work.hpp"
#include "delaunay3/tet_slot.hpp"

namespace tetloft::internal::delaunay3_detail {

/// The unique perturbed triangulation of two planes: type 1 below, type 1 above, then type 2.
/// Vertices are the lower plane's, then the upper's; tets are positive if the upper plane is
/// above; opposite half-faces are invalid on the hull. Linear in vertices and tets but for turning
/// around vertices of high degree. Requires two triangulations with triangles, vertices in
/// canonical order, together fewer than 2^29 vertices. Empty where it would take more than
/// `most_tets`, of which no more are made; these are fewer than 2^30. Tells no step.
[[nodiscard]] std::vector<TetSlot> slab_overlay(const Triangulation2& lower,
                                                const Triangulation2& upper,
                                                const WatchedWork& work,
                                                std::size_t most_tets = (std::size_t{1} << 30) - 1);

}  // namespace tetloft::internal::delaunay3_detail
