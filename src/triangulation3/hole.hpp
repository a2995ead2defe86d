// A vertex taken out of a triangulation, and the hole filled.
//
// The tets that fill it are those that the vertex would remove if it were inserted again: the
// conflict zone of the vertex in the triangulation of the others. All their vertices are in the
// link. Let T be the link's vertices and perhaps others but v: then the zone of v in the
// triangulation of T is the same. For the tets of the zone are empty of all points, so of T; and
// the tets of v are empty likewise, so they are v's star in the triangulation of T and v, and
// removing v from that leaves the same hole. So a small triangulation of the link's vertices tells
// how it is filled, in every degenerate case, since the perturbed triangulation is unique. (Of the
// link's vertices CGAL makes a small triangulation as well, and sews tets by matching facets.)
//
// Where all of the link lies in a plane, T takes one more vertex, that of a tet across it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>

#include "delaunay3/growing_tets.hpp"
#include "delaunay3/insertion.hpp"

namespace tetloft::internal::triangulation3 {

class Hole {
 public:
  Hole() : inserter_(small_) {}
  Hole(const Hole&) : Hole() {}  // what it holds is scratch
  Hole& operator=(const Hole&) = delete;

  /// Finds the link of v, given a tet of it, ghosts included.
  void open(delaunay3_detail::GrowingTets& tets, VertexId v, TetId of_v);
  /// The tets of v, ghosts included.
  [[nodiscard]] const std::vector<TetId>& star() const { return star_; }
  /// Those that came in its place.
  [[nodiscard]] const std::vector<TetId>& filling() const { return filling_; }
  /// The vertices of the link, the ghost apart.
  [[nodiscard]] const std::vector<VertexId>& link() const { return link_; }
  /// Replaces the star by the tets that fill it, and puts one of them down for each of their
  /// vertices. Requires that the points span the same space without v.
  void fill(delaunay3_detail::GrowingTets& tets, delaunay3_detail::Inserter& inserter,
            IdVector<VertexId, TetId>& tet_of);

 private:
  /// By number in link_; kGhostNumber the ghost.
  using Number = std::uint32_t;
  static constexpr Number kGhostNumber = 0xFFFFFFFFU;
  /// A facet of the link as seen from its tet, which stays; turns so as to point out of the hole.
  struct Facet {
    HalfFaceId outer;
    std::array<Number, 3> corners{};
  };
  /// The facet that has an edge of the link, in its direction, to its left.
  struct EdgeFacet {
    std::uint64_t edge;
    HalfFaceId outer;
  };

  [[nodiscard]] Number number(VertexId v);
  void triangulate_link(const delaunay3_detail::GrowingTets& tets);
  [[nodiscard]] TetVertices first_tet(const delaunay3_detail::GrowingTets& tets);
  void find_zone(const delaunay3_detail::GrowingTets& tets);
  void list_edges();
  [[nodiscard]] HalfFaceId outer_of(Number from, Number to) const;
  [[nodiscard]] Number number_of_small(VertexId v) const {
    return v == delaunay3_detail::kGhost ? kGhostNumber : v.value();
  }
  void place_zone(delaunay3_detail::GrowingTets& tets, delaunay3_detail::Inserter& inserter,
                  IdVector<VertexId, TetId>& tet_of);

  VertexId removed_;
  std::vector<TetId> star_;
  std::vector<TetId> filling_;
  std::vector<VertexId> link_;
  std::vector<Facet> facets_;
  std::vector<EdgeFacet> edges_;
  // By vertex: its number, where link_ confirms it; anything else is left over.
  std::vector<Number> number_of_;

  delaunay3_detail::GrowingTets small_;
  delaunay3_detail::Inserter inserter_;
  // By tet of the small triangulation that fills the hole: its slot.
  std::vector<TetId> slot_of_;
};

}  // namespace tetloft::internal::triangulation3
