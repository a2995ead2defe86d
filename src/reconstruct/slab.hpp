// A slab: two neighbouring conforming sections, the 3D Delaunay triangulation D of their
// vertices, and the type of each of its tets (Nonato et al. 2000, section 3.1).
//
// Slab vertices are numbered canonically: the lower section's first, then the upper's,
// each by (x, y). Everything below that says "lowest id" refers to this numbering and to
// the canonical numbering of D's tets; results thus depend on the points alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/delaunay.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/sections.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft {

/// D of a slab: canonical tets over the points of both planes, lower first. Fails (work_limit)
/// naming the slab, where it has more tets than `work_limit` allows (ReconstructOptions).
[[nodiscard]] Result<TetMesh> slab_delaunay(SlabId id, const ConformingSection& lower,
                                            const ConformingSection& upper, DelaunayEngine engine,
                                            double work_limit);

/// Is corner i in a mask over a tet's corners?
[[nodiscard]] constexpr bool has_corner(unsigned mask, int i) { return ((mask >> i) & 1U) != 0; }

class Slab {
 public:
  /// A tet of a vertex's star, and which of its corners the vertex is.
  struct StarEntry {
    TetId tet;
    int corner = 0;
  };

  /// Requires two non-empty sections and their D.
  Slab(const ConformingSection& lower, const ConformingSection& upper, TetMesh mesh);

  [[nodiscard]] const ConformingSection& lower() const { return *lower_; }
  [[nodiscard]] const ConformingSection& upper() const { return *upper_; }
  [[nodiscard]] const TetMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t vertex_count() const { return lower_count_ + upper_->vertex_count(); }
  [[nodiscard]] double gap() const { return upper_->z - lower_->z; }

  [[nodiscard]] bool is_upper(VertexId v) const { return v.index() >= lower_count_; }
  /// The section a slab vertex lies in, and its id there.
  [[nodiscard]] const ConformingSection& section_of(VertexId v) const {
    return is_upper(v) ? *upper_ : *lower_;
  }
  [[nodiscard]] VertexId in_section(VertexId v) const {
    return is_upper(v) ? VertexId(v.index() - lower_count_) : v;
  }
  [[nodiscard]] Point3 point(VertexId v) const { return section_of(v).point3(in_section(v)); }

  [[nodiscard]] TetKind kind(TetId t) const { return kind_[t]; }
  /// Bit i: corner i lies in the upper plane.
  [[nodiscard]] std::uint8_t upper_corners(TetId t) const { return upper_corners_[t]; }
  [[nodiscard]] bool same_plane(TetId t, int i, int j) const {
    return has_corner(upper_corners_[t], i) == has_corner(upper_corners_[t], j);
  }
  /// Kind of the in-plane edge between two slab vertices of one plane.
  [[nodiscard]] EdgeKind edge_kind(VertexId u, VertexId v) const;

  /// The tets of a vertex, by id.
  [[nodiscard]] std::span<const StarEntry> star(VertexId v) const {
    return {star_.data() + first_star_[v.index()], star_.data() + first_star_[v.index() + 1]};
  }

  /// Some tet that contains the in-plane edge: the type-1 tet over its left triangle, or
  /// right where there is none.
  [[nodiscard]] TetId tet_at_edge(bool in_upper, EdgeId e) const;

  /// Walks around edge (p, q) from tet t. Returns true iff the ring is a cycle, which then
  /// starts at t; a path runs from hull facet to hull facet. `ring` is overwritten.
  bool ring(TetId t, VertexId p, VertexId q, std::vector<TetId>& ring) const;

 private:
  void classify_tets();
  void collect_stars();

  const ConformingSection* lower_;
  const ConformingSection* upper_;
  std::size_t lower_count_;
  TetMesh mesh_;
  IdVector<TetId, TetKind> kind_;
  IdVector<TetId, std::uint8_t> upper_corners_;
  // The type-1 tet on an in-plane triangle; every one has exactly one.
  IdVector<TriangleId, TetId> tet_on_lower_;
  IdVector<TriangleId, TetId> tet_on_upper_;
  // star_[first_star_[v] … first_star_[v + 1]]: the star of v.
  std::vector<std::uint32_t> first_star_;
  std::vector<StarEntry> star_;
};

}  // namespace tetloft
