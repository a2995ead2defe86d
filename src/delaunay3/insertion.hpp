// Insertion of points into a 3D Delaunay triangulation: locate, collect the conflict zone, star the
// cavity (Bowyer, "Computing Dirichlet tessellations", and Watson, "Computing the
// n-dimensional Delaunay tessellation", The Computer Journal 24, 1981).
//
// Several threads insert at once, each in a part of its own (Marot, Pellerin and Remacle, "One
// machine, one minute, three billion tetrahedra", IJNME 117, 2019): every vertex belongs to one
// part, a tet to the part of all its vertices, if they have one; the ghost belongs to all. A thread
// walks through and removes tets of its part only, and gives a point up that needs others. Of other
// tets it sees the neighbours of its own. Such a tet has three vertices of the part or the ghost,
// hence no neighbour in another part: two of its faces share two vertices, not both of them the
// ghost. So it is written to by no other thread, and no other thread sees it. Where it is a ghost,
// the vertices of the tet below its hull facet are read, too: that one has two vertices of the
// part, hence is in no other, nor, with three vertices there, a neighbour of one that is. So there
// is nothing to lock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/growing_tets.hpp"

namespace tetloft::internal::delaunay3_detail {

/// The local vertices of face i, as vertices.
[[nodiscard]] inline TriangleVertices facet_of(const TetVertices& tet, std::size_t i) {
  const auto& local = kFaceVertex[i];
  return {tet[static_cast<std::size_t>(local[0])], tet[static_cast<std::size_t>(local[1])],
          tet[static_cast<std::size_t>(local[2])]};
}

/// The place of v in `tet`; 0 if it is not there.
[[nodiscard]] inline std::size_t index_of(const TetVertices& tet, VertexId v) {
  return (tet[1] == v ? 1U : 0U) + (tet[2] == v ? 2U : 0U) + (tet[3] == v ? 3U : 0U);
}

/// One thread's: where it is, the slots it may use, and its scratch.
class Inserter {
 public:
  /// Slots that a thread takes at a time while others are at work.
  static constexpr std::size_t kSlotsAtATime = 4096;

  /// A facet of the horizon, the boundary of the conflict zone: its half-face in the tet that stays
  /// and in the tet that goes, and the tet that joins it to the new vertex.
  struct HorizonFacet {
    HalfFaceId outer;
    HalfFaceId inner;
    TetId filler;
  };

  explicit Inserter(GrowingTets& tets) : tets_(&tets), edge_table_(kTableSide * kTableSide) {}
  /// At work on a copy of those that `other` is at work on.
  Inserter(GrowingTets& tets, const Inserter& other) : Inserter(other) { tets_ = &tets; }

  /// A live finite tet, where the next walk starts; of the part, where there is one.
  [[nodiscard]] TetId hint() const { return hint_; }
  void start_at(TetId hint) { hint_ = hint; }

  /// Makes the first tet, of four vertices not in a plane, and the ghost tets about it. Requires
  /// that there are no tets.
  void start_with(const TetVertices& first);
  /// Forgets all that it knows of tets: there are others now, whose slots these are free.
  void start_again(std::vector<TetId> free = {});

  /// Adds vertex v, with no other thread at work. False where more than `most_tets` slots would be
  /// taken, nothing changed.
  bool insert(VertexId v, std::size_t most_tets);
  /// The same with a tet known that is in conflict with v.
  bool insert_at(VertexId v, TetId in_conflict, std::size_t most_tets);
  /// The zone of the last insertion, whose slots are free now, and its horizon.
  [[nodiscard]] std::span<const TetId> zone() const { return conflict_; }
  [[nodiscard]] std::span<const HorizonFacet> horizon() const { return horizon_; }

  /// Finds the zone() of a vertex that is in no tet, given a tet of it, and marks it until
  /// leave_zone().
  void find_zone(VertexId v, TetId in_conflict);
  [[nodiscard]] bool is_in_zone(TetId t) const { return mark(t) == Mark::in_conflict; }
  void leave_zone() { unmark_zone(); }

  /// A slot for a tet, with no other thread at work; and back.
  [[nodiscard]] TetId take_slot();
  void free_slot(TetId t) { free_.push_back(t); }
  /// Makes room so that so many slots can be freed without memory.
  void reserve_free(std::size_t more) {
    if (free_.size() + more > free_.capacity()) free_.reserve(2 * (free_.size() + more));
  }

  enum class Outcome : std::uint8_t { inserted, given_up, no_room };
  /// Adds vertex v of part `part`. Nothing changed where the point was given up, as it needs tets
  /// of others, or where no room is left.
  Outcome insert_within(VertexId v, Part part);

  /// A tet whose closure contains p, or a ghost tet whose hull facet p lies strictly
  /// beyond: in either case one that is in conflict with p. With no other thread at work.
  TetId locate(const Point3& p);
  /// Is it finite and of the part?
  [[nodiscard]] bool is_inside(TetId t, Part part) const {
    return !tets_->is_ghost(t) && WithinPart{part}.owns(*tets_, t);
  }

  /// Makes the vertex 0 of the slots that hold no tet invalid.
  void mark_dead_slots();

 private:
  using Mark = GrowingTets::Mark;

  // Which tets may be used: all of them …
  struct Alone {
    [[nodiscard]] static bool owns(const GrowingTets& /*tets*/, TetId /*t*/) { return true; }
  };
  // … or those of a part.
  struct WithinPart {
    Part part;
    [[nodiscard]] bool owns(const GrowingTets& tets, TetId t) const {
      const TetVertices& tet = tets.tet(t);
      const auto has = [&](std::size_t i) { return tets.vertex(tet[i]).part == part; };
      return has(1) && has(2) && has(3) && (tet[0] == kGhost || has(0));
    }
  };

  // Cavities whose horizon has fewer vertices than this, the ghost apart, are glued by a table
  // of its edges; a uniform set has 15.5 on average.
  static constexpr std::size_t kTableSide = 64;
  // For so many tets of a zone, and facets of its horizon, there is room from the start.
  static constexpr std::size_t kRoom = 64;
  // As locate(); invalid where the walk comes to tets that are not to be used.
  template <class Use>
  TetId walk(const Point3& p, const Use& use);
  // Fills conflict_ and horizon_, and marks their tets. False, with nothing marked, where the zone
  // has tets that are not to be used.
  template <class Use>
  bool collect_conflict_zone(VertexId v, TetId start, const Use& use);
  // How far the scratch arrays are filled.
  struct Counts {
    std::size_t in_zone = 0;
    std::size_t facets = 0;
    std::size_t seen = 0;
  };
  // Lists the neighbours of t, of the zone, that were not seen before, and the facets across which
  // no tet of the zone is known.
  void show_neighbours(TetId t, Counts& count);
  // Which of them are in conflict.
  void decide_seen(VertexId v, Counts& count);
  void drop_inner_facets();
  void fetch_neighbours(TetId t) const;
  void unmark_zone();
  // Replaces the conflict zone by the tets that join the horizon to v, whose slots are taken.
  // Returns one of them, finite.
  TetId star_cavity(VertexId v);

  [[nodiscard]] bool is_in_conflict(TetId t, VertexId v) const;
  [[nodiscard]] std::array<bool, 2> are_in_conflict(TetId s, TetId t, VertexId v) const;
  [[nodiscard]] bool in_ghost_conflict(TetId t, VertexId v) const;
  [[nodiscard]] bool in_sphere(const TetVertices& tet, VertexId v) const;
  // Where the first filter does not tell.
  [[nodiscard]] bool in_doubtful_sphere(const TetVertices& tet, VertexId v) const;
  // As orient3d; for points of the set only.
  [[nodiscard]] Sign orientation(const Point3& a, const Point3& b, const Point3& c,
                                 const Point3& d) const {
    const int s = tets_->filter().orient3d(a, b, c, d);
    if (s != 0 || tets_->filter().is_exact()) return static_cast<Sign>(s);
    return orient3d(a, b, c, d);
  }
  // Does p lie strictly beyond face i of the tet?
  [[nodiscard]] bool is_beyond(const TetVertices& tet, std::size_t i, const Point3& p) const {
    const TriangleVertices facet = facet_of(tet, i);
    return orientation(point(facet[0]), point(facet[1]), point(facet[2]), p) == Sign::positive;
  }

  // Gives every facet of the horizon its filler, glued to the outer tet only.
  void create_fillers(VertexId v);
  // The number of vertex v of the horizon, a new one where it has none. Sets table_is_full_
  // where there is none left.
  std::size_t number_on_horizon(VertexId v);
  // Of one that has it. The ghost has no record to keep a number in; its place is the last of the
  // table.
  [[nodiscard]] std::size_t known_number(VertexId v) const {
    return v == kGhost ? kTableSide - 1 : tets_->vertex(v).on_horizon;
  }
  // Glues each two fillers that share an edge of the horizon: by looking edges up in the
  // table that create_fillers() filled, or, where the horizon has too many vertices for it,
  // by turning around the edges through the conflict zone.
  void glue_fillers();
  void glue_fillers_by_table();
  void glue_fillers_by_turning();
  // The face of the filler across face i of `facet`'s filler.
  [[nodiscard]] HalfFaceId filler_across(const HorizonFacet& facet, std::size_t i) const;
  // Takes a slot for every facet of the horizon: dead ones first, then new ones from `fresh` on.
  void take_slots(std::size_t fresh);
  // How many of them are new.
  [[nodiscard]] std::size_t new_slots() const {
    return horizon_.size() - std::min(free_.size(), horizon_.size());
  }
  // Of the slots that are this thread's, makes enough for the horizon. False where there is no
  // room.
  bool provide_slots();

  [[nodiscard]] bool is_ghost(TetId t) const { return tets_->is_ghost(t); }
  [[nodiscard]] const TetVertices& tet(TetId t) const { return tets_->tet(t); }
  [[nodiscard]] const Point3& point(VertexId v) const { return tets_->point(v); }
  [[nodiscard]] Mark& mark(TetId t) { return tets_->mark(t); }
  [[nodiscard]] Mark mark(TetId t) const { return std::as_const(*tets_).mark(t); }

  GrowingTets* tets_;
  TetId hint_;
  // State of the walk's linear congruential generator.
  std::uint32_t walk_state_ = 1;
  // Dead slots, last freed last.
  std::vector<TetId> free_;
  // Slots taken while others were at work that were never used.
  std::size_t fresh_ = 0;
  std::size_t fresh_end_ = 0;

  // Scratch of one insertion.
  std::vector<TetId> conflict_;
  std::vector<HorizonFacet> horizon_;
  std::vector<TetId> seen_;  // in one wave, and not decided yet
  // The vertices of the horizon by number, the ghost apart.
  std::array<VertexId, kTableSide> horizon_vertices_;
  std::size_t horizon_vertex_count_ = 0;
  bool table_is_full_ = false;
  // edge_table_[kTableSide * a + b]: the half-face of a filler on the horizon's edge from the
  // vertex of number a to that of number b. Old entries remain: every edge of the horizon is
  // written, in both directions, before one is read.
  std::vector<HalfFaceId> edge_table_;
};

}  // namespace tetloft::internal::delaunay3_detail
