// See insertion.hpp.
#include "delaunay3/insertion.hpp"

#include <algorithm>
#include <array>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/prefetch.hpp"
#include "delaunay3/walk.hpp"

namespace tetloft::internal::delaunay3_detail {

// Faces that contain vertex 0 list it first: the ghost, vertex 0 of its tets, becomes
// vertex 0 of the tets built on their facets.
static_assert(kFaceVertex[1][0] == 0 && kFaceVertex[2][0] == 0 && kFaceVertex[3][0] == 0);

void Inserter::start_with(const TetVertices& vertices) {
  TetVertices first = vertices;
  const Sign sign = orient3d(point(first[0]), point(first[1]), point(first[2]), point(first[3]));
  TETLOFT_CHECK(sign != Sign::zero);
  if (sign == Sign::negative) std::swap(first[0], first[1]);
  hint_ = TetId(tets_->take(5));
  tets_->slot(hint_).vertices = first;
  std::array<TetId, 4> ghosts;
  for (std::size_t i = 0; i < 4; ++i) {
    // Seen from the ghost the facet turns counter-clockwise, so (a, b, c, ghost) is
    // positive and with it (ghost, a, c, b).
    const TriangleVertices facet = facet_of(first, i);
    ghosts[i] = TetId(hint_.index() + i + 1);
    tets_->slot(ghosts[i]).vertices = {kGhost, facet[0], facet[2], facet[1]};
    tets_->glue(half_face(hint_, i), half_face(ghosts[i], 0));
  }
  // Ghosts i and j meet in the face that lacks vertex j of `first` in ghost i.
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      tets_->glue(half_face(ghosts[i], index_of(tet(ghosts[i]), first[j])),
                  half_face(ghosts[j], index_of(tet(ghosts[j]), first[i])));
    }
  }
}

void Inserter::start_again(std::vector<TetId> free) {
  hint_ = TetId();
  walk_state_ = 1;
  free_ = std::move(free);
  fresh_ = fresh_end_ = 0;
}

TetId Inserter::take_slot() {
  if (free_.empty()) return TetId(tets_->take(1));
  const TetId t = free_.back();
  free_.pop_back();
  return t;
}

bool Inserter::insert(VertexId v, std::size_t most_tets) {
  return insert_at(v, walk(point(v), Alone{}), most_tets);
}

bool Inserter::insert_at(VertexId v, TetId in_conflict, std::size_t most_tets) {
  collect_conflict_zone(v, in_conflict, Alone{});
  if (tets_->taken() + horizon_.size() > most_tets) {
    unmark_zone();
    return false;
  }
  reserve_free(conflict_.size());
  const std::size_t recycled = std::min(free_.size(), horizon_.size());
  take_slots(tets_->take(horizon_.size() - recycled));
  hint_ = star_cavity(v);
  return true;
}

Inserter::Outcome Inserter::insert_within(VertexId v, Part part) {
  const Point3 p = point(v);
  const WithinPart use{part};
  const TetId start = walk(p, use);
  if (!start.valid() || !collect_conflict_zone(v, start, use)) return Outcome::given_up;
  if (!provide_slots()) {
    unmark_zone();
    return Outcome::no_room;
  }
  const std::size_t fresh = fresh_;
  fresh_ += new_slots();
  take_slots(fresh);
  hint_ = star_cavity(v);
  return Outcome::inserted;
}

void Inserter::find_zone(VertexId v, TetId in_conflict) {
  collect_conflict_zone(v, in_conflict, Alone{});
}

TetId Inserter::locate(const Point3& p) { return walk(p, Alone{}); }

template <class Use>
TetId Inserter::walk(const Point3& p, const Use& use) {
  return delaunay3_detail::walk(
      *tets_, hint_, walk_state_, use,
      [&](const TetVertices& tet, std::size_t i) { return is_beyond(tet, i, p); });
}

// In waves: all tets that joined the zone in the last one show their neighbours, then those that
// were not seen before are decided, two at a time. Whether a tet was seen, or is in conflict, is a
// coin toss for the processor: each is written where the next of its kind goes, and the counts, not
// a branch, tell which ones stay.
template <class Use>
bool Inserter::collect_conflict_zone(VertexId v, TetId start, const Use& use) {
  conflict_.resize(kRoom);
  horizon_.resize(kRoom);
  seen_.resize(kRoom);
  conflict_[0] = start;
  mark(start) = Mark::in_conflict;
  Counts count;
  count.in_zone = 1;
  bool usable = true;
  for (std::size_t next = 0; usable && next < count.in_zone;) {
    count.seen = 0;
    for (; usable && next < count.in_zone; ++next) {
      usable = use.owns(*tets_, conflict_[next]);
      if (usable) show_neighbours(conflict_[next], count);
    }
    if (usable) decide_seen(v, count);
  }
  conflict_.resize(count.in_zone);
  horizon_.resize(count.facets);
  if (usable) {
    drop_inner_facets();
  } else {
    unmark_zone();
  }
  return usable;
}

void Inserter::show_neighbours(TetId t, Counts& count) {
  if (count.facets + 4 > horizon_.size()) horizon_.resize(2 * horizon_.size());
  if (count.seen + 4 > seen_.size()) seen_.resize(2 * seen_.size());
  for (std::size_t i = 0; i < 4; ++i) {
    const HalfFaceId across = tets_->slot(t).opposite[i];
    const TetId neighbour = TetMesh::tet_of(across);
    Mark& known = mark(neighbour);
    const std::size_t inside{known == Mark::in_conflict};
    const std::size_t unvisited{known == Mark::unvisited};
    known = static_cast<Mark>(2 - inside);
    horizon_[count.facets] = {across, half_face(t, i), TetId()};
    seen_[count.seen] = neighbour;
    count.facets += 1 - inside;
    count.seen += unvisited;
  }
}

void Inserter::decide_seen(VertexId v, Counts& count) {
  const std::size_t most = count.in_zone + count.seen;
  if (most > conflict_.size()) conflict_.resize(2 * most);
  const auto decide = [&](TetId t, bool in) {
    const std::size_t more{in};
    mark(t) = static_cast<Mark>(2 - more);
    conflict_[count.in_zone] = t;
    fetch_neighbours(t);
    count.in_zone += more;
  };
  for (std::size_t k = 0; k + 1 < count.seen; k += 2) {
    const std::array<bool, 2> in = are_in_conflict(seen_[k], seen_[k + 1], v);
    decide(seen_[k], in[0]);
    decide(seen_[k + 1], in[1]);
  }
  if (count.seen % 2 != 0) {
    const TetId last = seen_[count.seen - 1];
    decide(last, is_in_conflict(last, v));
  }
}

// Those whose outer tet joined the zone after the inner one.
void Inserter::drop_inner_facets() {
  std::size_t kept = 0;
  for (const HorizonFacet& facet : horizon_) {
    horizon_[kept] = facet;
    kept += std::size_t{mark(TetMesh::tet_of(facet.outer)) == Mark::outside};
  }
  horizon_.resize(kept);
}

void Inserter::unmark_zone() {
  for (const TetId t : conflict_) mark(t) = Mark::unvisited;
  for (const HorizonFacet& facet : horizon_) mark(TetMesh::tet_of(facet.outer)) = Mark::unvisited;
}

// Asks the processor for what the search will read when it comes to t.
void Inserter::fetch_neighbours(TetId t) const {
  for (const HalfFaceId across : tets_->slot(t).opposite) {
    core::prefetch(&tets_->slot(TetMesh::tet_of(across)));
    core::prefetch(&tets_->mark(TetMesh::tet_of(across)));
  }
}

bool Inserter::is_in_conflict(TetId t, VertexId v) const {
  return is_ghost(t) ? in_ghost_conflict(t, v) : in_sphere(tet(t), v);
}

std::array<bool, 2> Inserter::are_in_conflict(TetId s, TetId t, VertexId v) const {
  if (is_ghost(s) || is_ghost(t)) return {is_in_conflict(s, v), is_in_conflict(t, v)};
  const auto corners = [&](const TetVertices& tet) {
    return std::array{&point(tet[0]), &point(tet[1]), &point(tet[2]), &point(tet[3])};
  };
  const std::array<int, 2> sign =
      tets_->filter().insphere(corners(tet(s)), corners(tet(t)), point(v));
  if (sign[0] != 0 && sign[1] != 0) return {sign[0] > 0, sign[1] > 0};
  return {sign[0] != 0 ? sign[0] > 0 : in_doubtful_sphere(tet(s), v),
          sign[1] != 0 ? sign[1] > 0 : in_doubtful_sphere(tet(t), v)};
}

bool Inserter::in_ghost_conflict(TetId t, VertexId v) const {
  // The sphere of a ghost tet is the half-space beyond its hull facet …
  const TetVertices& ghost = tet(t);
  const Sign side = orientation(point(v), point(ghost[1]), point(ghost[2]), point(ghost[3]));
  if (side != Sign::zero) return side == Sign::positive;
  // … and on its rim, the plane of the facet, the perturbed circle of the facet decides.
  // That is where the sphere of the finite neighbour meets the plane: for a coplanar v
  // the neighbour's fourth vertex has no weight in the perturbed determinant.
  return in_sphere(tet(TetMesh::tet_of(tets_->opposite(half_face(t, 0)))), v);
}

bool Inserter::in_sphere(const TetVertices& tet, VertexId v) const {
  const int s = tets_->filter().insphere(point(tet[0]), point(tet[1]), point(tet[2]), point(tet[3]),
                                         point(v));
  return s != 0 ? s > 0 : in_doubtful_sphere(tet, v);
}

bool Inserter::in_doubtful_sphere(const TetVertices& tet, VertexId v) const {
  const auto record = [&](VertexId u) -> const GrowingTets::Vertex& { return tets_->vertex(u); };
  const GrowingTets::Vertex &a = record(tet[0]), &b = record(tet[1]), &c = record(tet[2]),
                            &d = record(tet[3]), &e = record(v);
  if (tets_->filter().is_exact()) {
    const Sign sign = tets_->is_ranked()
                          ? predicates::perturbed_insphere_of_cospherical(
                                tets_->filter(), {&a.point, &b.point, &c.point, &d.point, &e.point},
                                {a.rank, b.rank, c.rank, d.rank, e.rank})
                          : predicates::perturbed_insphere_of_cospherical(a.point, b.point, c.point,
                                                                          d.point, e.point);
    return sign == Sign::positive;
  }
  // The bound of the whole set can be far above that of five near points.
  if (const int s = predicates::insphere_filter(a.point, b.point, c.point, d.point, e.point);
      s != 0) {
    return s > 0;
  }
  return predicates::perturbed_insphere_beyond_filter(a.point, b.point, c.point, d.point,
                                                      e.point) == Sign::positive;
}

TetId Inserter::star_cavity(VertexId v) {
  create_fillers(v);
  glue_fillers();
  for (const TetId t : conflict_) mark(t) = Mark::unvisited;
  free_.insert(free_.end(), conflict_.begin(), conflict_.end());
  // A finite one exists: the star of v holds more than its ghost tets.
  std::size_t k = 0;
  while (is_ghost(horizon_[k].filler)) ++k;
  return horizon_[k].filler;
}

void Inserter::create_fillers(VertexId v) {
  horizon_vertex_count_ = 0;
  table_is_full_ = false;
  for (const HorizonFacet& facet : horizon_) {
    const TetId outer = TetMesh::tet_of(facet.outer);
    mark(outer) = Mark::unvisited;
    // Listed with the normal out of the outer tet, hence towards v: (base, v) is positive.
    const TriangleVertices base = facet_of(tet(outer), facet.outer.index() & 3);
    tets_->slot(facet.filler).vertices = {base[0], base[1], base[2], v};
    // From now on the outer tet leads to the filler; the inner one still to the outer.
    tets_->glue(half_face(facet.filler, 3), facet.outer);
    if (table_is_full_) continue;
    const std::size_t a = number_on_horizon(base[0]);
    const std::size_t b = number_on_horizon(base[1]);
    const std::size_t c = number_on_horizon(base[2]);
    if (table_is_full_) continue;
    edge_table_[kTableSide * b + c] = half_face(facet.filler, 0);
    edge_table_[kTableSide * c + a] = half_face(facet.filler, 1);
    edge_table_[kTableSide * a + b] = half_face(facet.filler, 2);
  }
}

std::size_t Inserter::number_on_horizon(VertexId v) {
  if (v == kGhost) return known_number(v);
  std::uint8_t& number = tets_->vertex(v).on_horizon;
  if (number < horizon_vertex_count_ && horizon_vertices_[number] == v) return number;
  if (horizon_vertex_count_ == kTableSide - 1) {
    table_is_full_ = true;
    return 0;
  }
  number = static_cast<std::uint8_t>(horizon_vertex_count_++);
  horizon_vertices_[number] = v;
  return number;
}

void Inserter::glue_fillers() {
  if (table_is_full_) {
    glue_fillers_by_turning();
  } else {
    glue_fillers_by_table();
  }
}

void Inserter::glue_fillers_by_table() {
  for (const HorizonFacet& facet : horizon_) {
    TetSlot& slot = tets_->slot(facet.filler);
    const std::size_t a = known_number(slot.vertices[0]);
    const std::size_t b = known_number(slot.vertices[1]);
    const std::size_t c = known_number(slot.vertices[2]);
    // The neighbour has the edge in the other direction.
    slot.opposite[0] = edge_table_[kTableSide * c + b];
    slot.opposite[1] = edge_table_[kTableSide * a + c];
    slot.opposite[2] = edge_table_[kTableSide * b + a];
  }
}

void Inserter::glue_fillers_by_turning() {
  for (const HorizonFacet& facet : horizon_) {
    for (std::size_t i = 0; i < 3; ++i) {
      tets_->opposite(half_face(facet.filler, i)) = filler_across(facet, i);
    }
  }
}

// Turns around the edge that face i of the filler has on the horizon, through the tets of
// the conflict zone, until the horizon is met again. Every edge of the horizon has two of
// its facets, as the horizon becomes the link of the new vertex, a sphere.
HalfFaceId Inserter::filler_across(const HorizonFacet& facet, std::size_t i) const {
  HalfFaceId entered = facet.inner;
  // The vertex of the entered face that is not on the edge: the face to leave by is
  // opposite to it.
  VertexId behind = tet(facet.filler)[i];
  for (std::size_t steps = 0;; ++steps) {
    TETLOFT_CHECK(steps < conflict_.size());
    const TetId t = TetMesh::tet_of(entered);
    const HalfFaceId across = tets_->opposite(half_face(t, index_of(tet(t), behind)));
    behind = tet(t)[static_cast<std::size_t>(TetMesh::face_of(entered))];
    if (mark(TetMesh::tet_of(across)) == Mark::in_conflict) {
      entered = across;
      continue;
    }
    const TetId filler = TetMesh::tet_of(tets_->opposite(across));
    return half_face(filler, index_of(tet(filler), behind));
  }
}

bool Inserter::provide_slots() {
  const std::size_t wanted = new_slots();
  if (fresh_end_ - fresh_ >= wanted) return true;
  // What is left of the last ones would not be in a row with the next.
  for (; fresh_ < fresh_end_; ++fresh_) free_.emplace_back(fresh_);
  const std::size_t count = std::max(kSlotsAtATime, new_slots());
  if (!tets_->take_of_room(count, fresh_)) {
    fresh_ = fresh_end_;
    return new_slots() == 0;
  }
  fresh_end_ = fresh_ + count;
  return true;
}

void Inserter::take_slots(std::size_t fresh) {
  std::size_t recycled = std::min(free_.size(), horizon_.size());
  for (HorizonFacet& facet : horizon_) {
    if (recycled == 0) {
      facet.filler = TetId(static_cast<std::uint32_t>(fresh++));
      continue;
    }
    --recycled;
    facet.filler = free_.back();
    free_.pop_back();
  }
}

void Inserter::mark_dead_slots() {
  for (const TetId t : free_) tets_->slot(t).vertices[0] = VertexId();
  for (; fresh_ < fresh_end_; ++fresh_) tets_->slot(TetId(fresh_)).vertices[0] = VertexId();
}

}  // namespace tetloft::internal::delaunay3_detail
