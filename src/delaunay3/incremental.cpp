// See incremental.hpp.
#include "delaunay3/incremental.hpp"

#include <array>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/check.hpp"

namespace tetloft::delaunay3_detail {

namespace {

// Half-faces are 4 t + i in 32 bits.
constexpr std::size_t kMaxTets = std::size_t{1} << 30;

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

HalfFaceId half_face(TetId t, std::size_t i) {
  return HalfFaceId(4 * t.value() + static_cast<std::uint32_t>(i));
}

}  // namespace

Delaunay3Builder::Delaunay3Builder(IdVector<VertexId, Point3> points)
    : points_(std::move(points)), filter_(points_.raw()) {
  const std::size_t expected = kExpectedTetsPerPoint * points_.size();
  tets_.reserve(expected);
  opposite_.reserve(4 * expected);
  mark_.reserve(expected);
  make_first_tets();
}

bool Delaunay3Builder::insert_all() {
  bool complete = true;
  for (VertexId v{4U}; complete && v < points_.end_id(); v = VertexId(v.value() + 1)) {
    complete = insert(v);
  }
  for (const TetId t : free_) tets_[t][0] = VertexId();
  points_ = {};
  mark_ = {};
  return complete;
}

void Delaunay3Builder::make_first_tets() {
  TetVertices first{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  const Sign sign =
      orient3d(points_[first[0]], points_[first[1]], points_[first[2]], points_[first[3]]);
  TETLOFT_CHECK(sign != Sign::zero);
  if (sign == Sign::negative) std::swap(first[0], first[1]);
  hint_ = new_tet(first);
  std::array<TetId, 4> ghosts;
  for (int i = 0; i < 4; ++i) {
    // Seen from the ghost the facet turns counter-clockwise, so (a, b, c, ghost) is
    // positive and with it (ghost, a, c, b).
    const TriangleVertices facet = facet_of(first, i);
    const TetId ghost = new_tet({kGhost, facet[0], facet[2], facet[1]});
    glue(half_face(hint_, static_cast<std::size_t>(i)), half_face(ghost, 0));
    ghosts[static_cast<std::size_t>(i)] = ghost;
  }
  // Ghosts i and j meet in the face that lacks vertex j of `first` in ghost i.
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      glue(half_face(ghosts[i], index_of(tets_[ghosts[i]], first[j])),
           half_face(ghosts[j], index_of(tets_[ghosts[j]], first[i])));
    }
  }
}

bool Delaunay3Builder::insert(VertexId v) {
  const Point3 p = points_[v];
  collect_conflict_zone(p, locate(p, hint_));
  if (tets_.size() + horizon_.size() >= kMaxTets) return false;
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
    TETLOFT_CHECK(steps <= tets_.size());
    walk_state_ = walk_state_ * 1664525U + 1013904223U;
    const TetVertices& tet = tets_[t];
    HalfFaceId crossing;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = ((walk_state_ >> 30) + k) & 3U;
      if (i == entered) continue;
      if (!is_beyond(tet, i, p)) continue;
      crossing = opposite_[half_face(t, i)];
      break;
    }
    if (!crossing.valid()) return t;
    t = TetMesh::tet_of(crossing);
    if (is_ghost(t)) return t;
    entered = static_cast<std::size_t>(TetMesh::face_of(crossing));
  }
}

void Delaunay3Builder::collect_conflict_zone(const Point3& p, TetId start) {
  ++epoch_;
  conflict_.clear();
  horizon_.clear();
  conflict_.push_back(start);
  mark_[start] = mark_in();
  // The zone is its own queue: tets before `next` have all their neighbours decided.
  for (std::size_t next = 0; next < conflict_.size(); ++next) {
    const TetId t = conflict_[next];
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId across = opposite_[half_face(t, i)];
      const TetId neighbour = TetMesh::tet_of(across);
      std::uint32_t& mark = mark_[neighbour];
      if (mark == mark_in()) continue;
      if (mark != mark_out()) {
        if (in_conflict(neighbour, p)) {
          mark = mark_in();
          conflict_.push_back(neighbour);
          continue;
        }
        mark = mark_out();
      }
      horizon_.push_back({across, half_face(t, i), TetId()});
    }
  }
}

bool Delaunay3Builder::in_conflict(TetId t, const Point3& p) const {
  return is_ghost(t) ? in_ghost_conflict(t, p) : in_sphere(tets_[t], p);
}

bool Delaunay3Builder::in_ghost_conflict(TetId t, const Point3& p) const {
  // The sphere of a ghost tet is the half-space beyond its hull facet …
  const TetVertices& tet = tets_[t];
  const Sign side = orient3d(p, points_[tet[1]], points_[tet[2]], points_[tet[3]]);
  if (side != Sign::zero) return side == Sign::positive;
  // … and on its rim, the plane of the facet, the perturbed circle of the facet decides.
  // That is where the sphere of the finite neighbour meets the plane: for a coplanar p
  // the neighbour's fourth vertex has no weight in the perturbed determinant.
  const TetId inside = TetMesh::tet_of(opposite_[half_face(t, 0)]);
  return in_sphere(tets_[inside], p);
}

bool Delaunay3Builder::in_sphere(const TetVertices& tet, const Point3& p) const {
  const Point3& a = points_[tet[0]];
  const Point3& b = points_[tet[1]];
  const Point3& c = points_[tet[2]];
  const Point3& d = points_[tet[3]];
  if (const int s = filter_.insphere(a, b, c, d, p); s != 0) return s > 0;
  const Sign sign = filter_.is_exact()
                        ? predicates::perturbed_insphere_of_cospherical(a, b, c, d, p)
                        : insphere_perturbed(a, b, c, d, p);
  return sign == Sign::positive;
}

bool Delaunay3Builder::is_beyond(const TetVertices& tet, std::size_t i, const Point3& p) const {
  const TriangleVertices facet = facet_of(tet, static_cast<int>(i));
  const Point3& a = points_[facet[0]];
  const Point3& b = points_[facet[1]];
  const Point3& c = points_[facet[2]];
  if (const int s = filter_.orient3d(a, b, c, p); s != 0) return s > 0;
  return !filter_.is_exact() && orient3d(a, b, c, p) == Sign::positive;
}

TetId Delaunay3Builder::star_cavity(VertexId v) {
  create_fillers(v);
  glue_fillers();
  free_.insert(free_.end(), conflict_.begin(), conflict_.end());
  // A finite one exists: the star of v holds more than its ghost tets.
  std::size_t k = 0;
  while (is_ghost(horizon_[k].filler)) ++k;
  return horizon_[k].filler;
}

void Delaunay3Builder::create_fillers(VertexId v) {
  for (HorizonFacet& facet : horizon_) {
    // Listed with the normal out of the outer tet, hence towards v: (base, v) is positive.
    const TriangleVertices base =
        facet_of(tets_[TetMesh::tet_of(facet.outer)], TetMesh::face_of(facet.outer));
    facet.filler = new_tet({base[0], base[1], base[2], v});
    // From now on the outer tet leads to the filler; the inner one still to the outer.
    glue(half_face(facet.filler, 3), facet.outer);
  }
}

void Delaunay3Builder::glue_fillers() {
  for (const HorizonFacet& facet : horizon_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfFaceId own = half_face(facet.filler, i);
      if (!opposite_[own].valid()) glue(own, filler_across(facet, i));
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
  VertexId behind = tets_[facet.filler][i];
  for (std::size_t steps = 0;; ++steps) {
    TETLOFT_CHECK(steps < conflict_.size());
    const TetId t = TetMesh::tet_of(entered);
    const HalfFaceId across = opposite_[half_face(t, index_of(tets_[t], behind))];
    behind = tets_[t][static_cast<std::size_t>(TetMesh::face_of(entered))];
    if (mark_[TetMesh::tet_of(across)] == mark_in()) {
      entered = across;
      continue;
    }
    const TetId filler = TetMesh::tet_of(opposite_[across]);
    return half_face(filler, index_of(tets_[filler], behind));
  }
}

TetId Delaunay3Builder::new_tet(const TetVertices& vertices) {
  TetId t;
  if (free_.empty()) {
    t = tets_.push_back(vertices);
    opposite_.resize(4 * tets_.size());
    mark_.push_back(0);
    return t;
  }
  t = free_.back();
  free_.pop_back();
  tets_[t] = vertices;
  for (std::size_t i = 0; i < 4; ++i) opposite_[half_face(t, i)] = HalfFaceId();
  return t;
}

}  // namespace tetloft::delaunay3_detail
