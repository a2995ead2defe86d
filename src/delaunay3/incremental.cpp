// See incremental.hpp.
#include "delaunay3/incremental.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/prefetch.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Points of uniform distribution have 6.77 tets each (Dwyer, DCG 6, 1991); hull and
// recycled slots come on top.
constexpr std::size_t kExpectedTetsPerPoint = 7;

// The place of v in `tet`; 0 if it is not there.
std::size_t index_of(const TetVertices& tet, VertexId v) {
  return (tet[1] == v ? 1U : 0U) + (tet[2] == v ? 2U : 0U) + (tet[3] == v ? 3U : 0U);
}

// Faces that contain vertex 0 list it first: the ghost, vertex 0 of its tets, becomes
// vertex 0 of the tets built on their facets.
static_assert(kFaceVertex[1][0] == 0 && kFaceVertex[2][0] == 0 && kFaceVertex[3][0] == 0);

TriangleVertices facet_of(const TetVertices& tet, int face) {
  const auto& local = kFaceVertex[static_cast<std::size_t>(face)];
  return {tet[static_cast<std::size_t>(local[0])], tet[static_cast<std::size_t>(local[1])],
          tet[static_cast<std::size_t>(local[2])]};
}

}  // namespace

Delaunay3Builder::Delaunay3Builder(IdVector<VertexId, Point3> points)
    : filter_(points.raw()), edge_table_(kTableSide * kTableSide) {
  vertices_.reserve(points.size());
  for (const Point3& p : points) vertices_.push_back({p});
  points = {};
  const std::size_t expected = kExpectedTetsPerPoint * vertices_.size();
  slots_.reserve(expected);
  marks_.reserve(expected);
  make_first_tets();
}

bool Delaunay3Builder::insert_all(WatchedWork& work, std::size_t most_tets) {
  most_tets_ = most_tets;
  bool complete = true;
  for (VertexId v{4U}; complete && v.index() < vertices_.size(); v = VertexId(v.value() + 1)) {
    complete = insert(v);
    if ((v.index() + 1) % kPointsOfStep == 0) work.step_done_go_on();
  }
  for (const TetId t : free_) slots_[t.index()].vertices[0] = VertexId();
  vertices_ = {};
  marks_ = {};
  return complete;
}

void Delaunay3Builder::make_first_tets() {
  TetVertices first{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  const Sign sign = orient3d(point(first[0]), point(first[1]), point(first[2]), point(first[3]));
  TETLOFT_CHECK(sign != Sign::zero);
  if (sign == Sign::negative) std::swap(first[0], first[1]);
  slots_.resize(5);
  marks_.resize(5, Mark::unvisited);
  hint_ = TetId(0);
  slots_[0].vertices = first;
  std::array<TetId, 4> ghosts;
  for (std::size_t i = 0; i < 4; ++i) {
    // Seen from the ghost the facet turns counter-clockwise, so (a, b, c, ghost) is
    // positive and with it (ghost, a, c, b).
    const TriangleVertices facet = facet_of(first, static_cast<int>(i));
    ghosts[i] = TetId(i + 1);
    slots_[i + 1].vertices = {kGhost, facet[0], facet[2], facet[1]};
    glue(half_face(hint_, i), half_face(ghosts[i], 0));
  }
  // Ghosts i and j meet in the face that lacks vertex j of `first` in ghost i.
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      glue(half_face(ghosts[i], index_of(tet(ghosts[i]), first[j])),
           half_face(ghosts[j], index_of(tet(ghosts[j]), first[i])));
    }
  }
}

bool Delaunay3Builder::insert(VertexId v) {
  const Point3 p = point(v);
  collect_conflict_zone(p, locate(p, hint_));
  if (slots_.size() + horizon_.size() > most_tets_) return false;
  hint_ = star_cavity(v);
  return true;
}

// Remembering visibility walk (Devillers, Pion and Teillaud, "Walking in a triangulation",
// IJFCS 13, 2002). It ends in every Delaunay triangulation, the perturbed ones included:
// the power of p decreases with each tet. The first face tried is drawn at random for
// speed alone, by an own generator: the walk is the same in every run.
TetId Delaunay3Builder::locate(const Point3& p, TetId start) {
  TetId t = start;
  std::size_t entered = 4;
  for (std::size_t steps = 0;; ++steps) {
    TETLOFT_CHECK(steps <= slots_.size());
    walk_state_ = walk_state_ * 1664525U + 1013904223U;
    const TetSlot& slot = slots_[t.index()];
    HalfFaceId crossing;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = ((walk_state_ >> 30) + k) & 3U;
      if (i == entered) continue;
      if (!is_beyond(slot.vertices, i, p)) continue;
      crossing = slot.opposite[i];
      break;
    }
    if (!crossing.valid()) return t;
    t = TetMesh::tet_of(crossing);
    if (is_ghost(t)) return t;
    entered = static_cast<std::size_t>(TetMesh::face_of(crossing));
  }
}

void Delaunay3Builder::collect_conflict_zone(const Point3& p, TetId start) {
  // Whether a tet is in conflict is a coin toss for the processor: both outcomes are written
  // where the next of their kind goes, and the counts, not a branch, tell which one stays.
  conflict_.resize(kRoom);
  horizon_.resize(kRoom);
  std::size_t in_zone = 1;
  std::size_t on_horizon = 0;
  conflict_[0] = start;
  mark(start) = Mark::in_conflict;
  // The zone is its own queue: tets before `next` have all their neighbours decided.
  for (std::size_t next = 0; next < in_zone; ++next) {
    if (in_zone + 4 > conflict_.size()) conflict_.resize(2 * conflict_.size());
    if (on_horizon + 4 > horizon_.size()) horizon_.resize(2 * horizon_.size());
    const TetId t = conflict_[next];
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId across = slots_[t.index()].opposite[i];
      const TetId neighbour = TetMesh::tet_of(across);
      const Mark known = mark(neighbour);
      if (known == Mark::in_conflict) continue;
      horizon_[on_horizon] = {across, half_face(t, i), TetId()};
      if (known == Mark::outside) {
        ++on_horizon;
        continue;
      }
      const auto in = static_cast<std::size_t>(in_conflict(neighbour, p));
      mark(neighbour) = static_cast<Mark>(2 - in);
      conflict_[in_zone] = neighbour;
      fetch_neighbours(neighbour);
      in_zone += in;
      on_horizon += 1 - in;
    }
  }
  conflict_.resize(in_zone);
  horizon_.resize(on_horizon);
}

// Asks the processor for what the search will read when it comes to t.
void Delaunay3Builder::fetch_neighbours(TetId t) const {
  for (const HalfFaceId across : slots_[t.index()].opposite) {
    core::prefetch(&slots_[across.index() >> 2]);
    core::prefetch(&marks_[across.index() >> 2]);
  }
}

bool Delaunay3Builder::in_conflict(TetId t, const Point3& p) const {
  return is_ghost(t) ? in_ghost_conflict(t, p) : in_sphere(tet(t), p);
}

bool Delaunay3Builder::in_ghost_conflict(TetId t, const Point3& p) const {
  // The sphere of a ghost tet is the half-space beyond its hull facet …
  const TetVertices& ghost = tet(t);
  const Sign side = orientation(p, point(ghost[1]), point(ghost[2]), point(ghost[3]));
  if (side != Sign::zero) return side == Sign::positive;
  // … and on its rim, the plane of the facet, the perturbed circle of the facet decides.
  // That is where the sphere of the finite neighbour meets the plane: for a coplanar p
  // the neighbour's fourth vertex has no weight in the perturbed determinant.
  return in_sphere(tet(TetMesh::tet_of(opposite(half_face(t, 0)))), p);
}

bool Delaunay3Builder::in_sphere(const TetVertices& tet, const Point3& p) const {
  const Point3& a = point(tet[0]);
  const Point3& b = point(tet[1]);
  const Point3& c = point(tet[2]);
  const Point3& d = point(tet[3]);
  if (const int s = filter_.insphere(a, b, c, d, p); s != 0) return s > 0;
  if (filter_.is_exact()) {
    return predicates::perturbed_insphere_of_cospherical(a, b, c, d, p) == Sign::positive;
  }
  // The bound of the whole set can be far above that of five near points.
  if (const int s = predicates::insphere_filter(a, b, c, d, p); s != 0) return s > 0;
  return insphere_perturbed(a, b, c, d, p) == Sign::positive;
}

Sign Delaunay3Builder::orientation(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) const {
  const int s = filter_.orient3d(a, b, c, d);
  if (s != 0 || filter_.is_exact()) return static_cast<Sign>(s);
  return orient3d(a, b, c, d);
}

bool Delaunay3Builder::is_beyond(const TetVertices& tet, std::size_t i, const Point3& p) const {
  const TriangleVertices facet = facet_of(tet, static_cast<int>(i));
  return orientation(point(facet[0]), point(facet[1]), point(facet[2]), p) == Sign::positive;
}

TetId Delaunay3Builder::star_cavity(VertexId v) {
  create_fillers(v);
  glue_fillers();
  for (const TetId t : conflict_) mark(t) = Mark::unvisited;
  free_.insert(free_.end(), conflict_.begin(), conflict_.end());
  // A finite one exists: the star of v holds more than its ghost tets.
  std::size_t k = 0;
  while (is_ghost(horizon_[k].filler)) ++k;
  return horizon_[k].filler;
}

void Delaunay3Builder::create_fillers(VertexId v) {
  take_slots();
  horizon_vertex_count_ = 0;
  table_is_full_ = false;
  for (const HorizonFacet& facet : horizon_) {
    const TetId outer = TetMesh::tet_of(facet.outer);
    mark(outer) = Mark::unvisited;
    // Listed with the normal out of the outer tet, hence towards v: (base, v) is positive.
    const TriangleVertices base = facet_of(tet(outer), TetMesh::face_of(facet.outer));
    slots_[facet.filler.index()].vertices = {base[0], base[1], base[2], v};
    // From now on the outer tet leads to the filler; the inner one still to the outer.
    glue(half_face(facet.filler, 3), facet.outer);
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

std::size_t Delaunay3Builder::number_on_horizon(VertexId v) {
  // The ghost has no record to keep a number in; its place is the last of the table.
  if (v == kGhost) return kTableSide - 1;
  std::uint32_t& number = vertices_[v.index()].on_horizon;
  if (number < horizon_vertex_count_ && horizon_vertices_[number] == v) return number;
  if (horizon_vertex_count_ == kTableSide - 1) {
    table_is_full_ = true;
    return 0;
  }
  number = static_cast<std::uint32_t>(horizon_vertex_count_++);
  horizon_vertices_[number] = v;
  return number;
}

void Delaunay3Builder::glue_fillers() {
  if (table_is_full_) {
    glue_fillers_by_turning();
  } else {
    glue_fillers_by_table();
  }
}

void Delaunay3Builder::glue_fillers_by_table() {
  for (const HorizonFacet& facet : horizon_) {
    TetSlot& slot = slots_[facet.filler.index()];
    const std::size_t a = number_on_horizon(slot.vertices[0]);
    const std::size_t b = number_on_horizon(slot.vertices[1]);
    const std::size_t c = number_on_horizon(slot.vertices[2]);
    // The neighbour has the edge in the other direction.
    slot.opposite[0] = edge_table_[kTableSide * c + b];
    slot.opposite[1] = edge_table_[kTableSide * a + c];
    slot.opposite[2] = edge_table_[kTableSide * b + a];
  }
}

void Delaunay3Builder::glue_fillers_by_turning() {
  for (const HorizonFacet& facet : horizon_) {
    for (std::size_t i = 0; i < 3; ++i) {
      opposite(half_face(facet.filler, i)) = filler_across(facet, i);
    }
  }
}

// Turns around the edge that face i of the filler has on the horizon, through the tets of
// the conflict zone, until the horizon is met again. Every edge of the horizon has two of
// its facets, as the horizon becomes the link of the new vertex, a sphere.
HalfFaceId Delaunay3Builder::filler_across(const HorizonFacet& facet, std::size_t i) const {
  HalfFaceId entered = facet.inner;
  // The vertex of the entered face that is not on the edge: the face to leave by is
  // opposite to it.
  VertexId behind = tet(facet.filler)[i];
  for (std::size_t steps = 0;; ++steps) {
    TETLOFT_CHECK(steps < conflict_.size());
    const TetId t = TetMesh::tet_of(entered);
    const HalfFaceId across = opposite(half_face(t, index_of(tet(t), behind)));
    behind = tet(t)[static_cast<std::size_t>(TetMesh::face_of(entered))];
    if (mark(TetMesh::tet_of(across)) == Mark::in_conflict) {
      entered = across;
      continue;
    }
    const TetId filler = TetMesh::tet_of(opposite(across));
    return half_face(filler, index_of(tet(filler), behind));
  }
}

void Delaunay3Builder::take_slots() {
  std::size_t recycled = std::min(free_.size(), horizon_.size());
  std::uint32_t fresh = static_cast<std::uint32_t>(slots_.size());
  slots_.resize(slots_.size() + horizon_.size() - recycled);
  marks_.resize(slots_.size(), Mark::unvisited);
  for (HorizonFacet& facet : horizon_) {
    if (recycled == 0) {
      facet.filler = TetId(fresh++);
      continue;
    }
    --recycled;
    facet.filler = free_.back();
    free_.pop_back();
  }
}

}  // namespace tetloft::internal::delaunay3_detail
