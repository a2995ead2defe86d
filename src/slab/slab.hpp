// A slab: two neighbouring conforming sections, the 3D Delaunay triangulation D of their
// vertices, and the type of each of its tets (Nonato et al. 2000, section 3.1).
//
// Slab vertices are numbered canonically (numbering.hpp), and vertex k of D's mesh is slab vertex
// k. Everything below that says "lowest id" refers to this numbering and to the canonical
// numbering of D's tets; results thus depend on the points alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/model.hpp>
#include <tetloft/tet_mesh.hpp>

#include "slab/delaunay.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

/// Is corner i in a mask over a tet's corners?
[[nodiscard]] constexpr bool has_corner(unsigned mask, int i) { return ((mask >> i) & 1U) != 0; }

class Slab {
 public:
  /// Requires two non-empty sections and their D.
  Slab(const ConformingSection& lower, const ConformingSection& upper, SlabDelaunay d);

  [[nodiscard]] const ConformingSection& lower() const { return *lower_; }
  [[nodiscard]] const ConformingSection& upper() const { return *upper_; }
  [[nodiscard]] const ConformingSection& section(bool upper) const {
    return upper ? *upper_ : *lower_;
  }
  [[nodiscard]] double gap() const { return upper_->z - lower_->z; }

  [[nodiscard]] const SlabVertices& numbering() const { return numbering_; }
  [[nodiscard]] std::size_t vertex_count() const { return numbering_.size(); }
  [[nodiscard]] bool is_upper(SlabVertexId v) const { return numbering_.is_upper(v); }
  /// The section a slab vertex lies in, and its id there.
  [[nodiscard]] const ConformingSection& section_of(SlabVertexId v) const {
    return section(is_upper(v));
  }
  [[nodiscard]] PlaneVertexId in_section(SlabVertexId v) const { return numbering_.in_section(v); }
  [[nodiscard]] Point3 point(SlabVertexId v) const { return section_of(v).point3(in_section(v)); }

  /// D's adjacency; stars, rings and vertices of its tets in terms of the slab follow.
  [[nodiscard]] const TetMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t tet_count() const { return mesh_.tet_slots(); }
  [[nodiscard]] IdRange<TetId> tets() const { return IdRange<TetId>(tet_count()); }
  [[nodiscard]] IdRange<SlabVertexId> vertices() const {
    return IdRange<SlabVertexId>(vertex_count());
  }
  [[nodiscard]] SlabVertexId vertex(TetId t, int i) const {
    return SlabVertexId(mesh_.vertex(t, i).value());
  }
  [[nodiscard]] std::array<SlabVertexId, 4> vertices(TetId t) const {
    return {vertex(t, 0), vertex(t, 1), vertex(t, 2), vertex(t, 3)};
  }
  /// The corner of t at v, which is one of its vertices.
  [[nodiscard]] int index_in(TetId t, SlabVertexId v) const {
    const TetVertices& tet = mesh_.vertices(t);
    const VertexId u = mesh_vertex(v);
    return (tet[1] == u ? 1 : 0) + (tet[2] == u ? 2 : 0) + (tet[3] == u ? 3 : 0);
  }
  /// The corners of a vertex: its star, by tet id.
  [[nodiscard]] CornerRange corners(SlabVertexId v) const { return mesh_.corners(mesh_vertex(v)); }
  /// TetMesh::ring() around edge (p, q).
  bool ring(SlabVertexId p, SlabVertexId q, TetId start, std::vector<TetId>& ring) const {
    return mesh_.ring(mesh_vertex(p), mesh_vertex(q), start, ring);
  }

  [[nodiscard]] TetKind kind(TetId t) const { return kind_[t]; }
  /// Bit i: corner i lies in the upper plane.
  [[nodiscard]] std::uint8_t upper_corners(TetId t) const { return upper_corners_[t]; }
  /// Does a type-1 tet have its triangle in this plane?
  [[nodiscard]] bool has_triangle(TetId t, bool upper) const {
    // Three corners above: 7, 11, 13 or 14; one: 1, 2, 4 or 8.
    const unsigned mask = upper_corners_[t];
    return upper ? (mask & (mask - 1)) != 0 : (mask & (mask - 1)) == 0;
  }
  [[nodiscard]] bool same_plane(TetId t, int i, int j) const {
    return has_corner(upper_corners_[t], i) == has_corner(upper_corners_[t], j);
  }
  /// The triangle of a type-1 tet, in its section.
  [[nodiscard]] TriangleId triangle(TetId t) const {
    const TetBase& base = base_[t];
    return delaunay3_detail::triangle_of(base.lower.valid() ? base.lower : base.upper);
  }
  /// The edge of their section between corners i and j of t, which are in one plane.
  [[nodiscard]] EdgeId edge(TetId t, int i, int j) const;
  /// The edge of their section between two slab vertices of one plane, and its kind.
  [[nodiscard]] EdgeId edge(SlabVertexId u, SlabVertexId v) const {
    return section_of(u).find_edge(in_section(u), in_section(v));
  }
  [[nodiscard]] EdgeKind edge_kind(SlabVertexId u, SlabVertexId v) const;

  /// Some tet that contains the in-plane edge: the type-1 tet over its left triangle, or
  /// right where there is none.
  [[nodiscard]] TetId tet_at_edge(bool in_upper, EdgeId e) const;
  /// The type-1 tet on a triangle of a section.
  [[nodiscard]] TetId tet_on(bool upper, TriangleId t) const { return tet_on_[upper ? 1 : 0][t]; }

 private:
  [[nodiscard]] static VertexId mesh_vertex(SlabVertexId v) { return VertexId(v.value()); }
  void classify_tets();
  [[nodiscard]] TetKind classify_type1(TetId t, bool above);
  [[nodiscard]] TetKind classify_type2(TetId t) const;
  // The edge that a type-2 tet has in a plane.
  [[nodiscard]] EdgeId base_edge(bool upper, TetId t) const {
    const delaunay3_detail::TriangleSideId side = upper ? base_[t].upper : base_[t].lower;
    return edges_[upper ? 1 : 0][delaunay3_detail::triangle_of(side)]
                 [delaunay3_detail::side_number(side)];
  }

  const ConformingSection* lower_;
  const ConformingSection* upper_;
  SlabVertices numbering_;
  TetMesh mesh_;
  IdVector<TetId, TetBase> base_;
  std::array<EdgesOfSides, 2> edges_;  // of the triangles below, of those above
  IdVector<TetId, TetKind> kind_;
  IdVector<TetId, std::uint8_t> upper_corners_;
  // The type-1 tet on an in-plane triangle, below and above; every one has exactly one.
  std::array<IdVector<TriangleId, TetId>, 2> tet_on_;
};

}  // namespace tetloft::internal
