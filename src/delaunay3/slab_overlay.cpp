// See slab_overlay.hpp.
#include "delaunay3/slab_overlay.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "core/guard.hpp"
#include "core/prefetch.hpp"
#include "delaunay3/nearer.hpp"
#include "delaunay3/plane_diagram.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// chain() asks for the slots of this many tets before it comes to them.
constexpr std::size_t kFetchedAhead = 16;

// Type-2 tets are {behind, ahead, left, right}: the lower vertices of the cells that the upper
// Voronoi edge leaves and enters, and the upper vertices to its left and right. So are their
// faces: each leads to the tet without that vertex.
constexpr std::uint32_t kAhead = 0;   // opposite the vertex behind
constexpr std::uint32_t kBehind = 1;  // opposite the vertex ahead
constexpr std::uint32_t kRight = 2;   // opposite the vertex to the left
constexpr std::uint32_t kLeft = 3;

// So many upper triangles are traced between two looks at the stop token.
constexpr std::size_t kTrianglesOfLook = 1024;

class SlabOverlay {
 public:
  SlabOverlay(const Triangulation2& lower, const Triangulation2& upper, const WatchedWork& work,
              std::size_t most_tets)
      : work_(work),
        most_tets_(most_tets),
        lower_(lower, std::max(reach_of(lower.points), reach_of(upper.points))),
        upper_(upper, std::max(reach_of(lower.points), reach_of(upper.points))),
        first_upper_(VertexId(lower_.vertex_count()).value()),
        lower_centres_{&lower_, &upper_, true},
        upper_centres_{&upper_, &lower_, false} {}

  // False at too many tets.
  [[nodiscard]] bool run() {
    if (first_type2() > most_tets_) return false;
    start_type1();
    if (!trace_upper_edges()) return false;
    chain_lower_edges();
    settle_lower_triangles();
    return true;
  }
  [[nodiscard]] std::vector<TetSlot> take_slots() { return std::move(slots_); }
  [[nodiscard]] std::vector<TetBase> bases() const;

 private:
  [[nodiscard]] TetId tet_below(TriangleId t) const { return TetId(t.value()); }
  [[nodiscard]] TetId tet_above(TriangleId t) const {
    return TetId(lower_.finite_count() + t.index());
  }
  [[nodiscard]] std::size_t first_type2() const {
    return lower_.finite_count() + upper_.finite_count();
  }
  // The type-2 tets on a lower edge, given by its representative, once they are sorted.
  [[nodiscard]] std::span<const TetId> tets_on(HalfEdgeId edge) const {
    const std::uint32_t begin = edge.index() == 0 ? 0 : end_on_edge_[HalfEdgeId(edge.index() - 1)];
    return std::span(on_edge_).subspan(begin, end_on_edge_[edge] - begin);
  }
  // The vertices of the mesh: the lower plane's, then the upper's.
  [[nodiscard]] static VertexId lower_vertex(PlaneVertexId v) { return VertexId(v.value()); }
  [[nodiscard]] VertexId upper_vertex(PlaneVertexId v) const {
    return VertexId(first_upper_ + v.value());
  }
  [[nodiscard]] PlaneVertexId in_upper_plane(VertexId v) const {
    return PlaneVertexId(v.value() - first_upper_);
  }
  void glue(HalfFaceId a, HalfFaceId b) {
    opposite(a) = b;
    opposite(b) = a;
  }
  [[nodiscard]] HalfFaceId& opposite(HalfFaceId h) {
    return slots_[h.index() >> 2].opposite[h.index() & 3];
  }
  [[nodiscard]] TetVertices& tet(TetId t) { return slots_[t.index()].vertices; }
  // The face of a type-1 tet over half-edge h of its triangle.
  [[nodiscard]] HalfFaceId face_below(HalfEdgeId h) const {
    return half_face(tet_below(PlaneDiagram::triangle(h)), h.value() & 3U);
  }
  [[nodiscard]] HalfFaceId face_above(HalfEdgeId h) const {
    return half_face(tet_above(PlaneDiagram::triangle(h)), (h.value() & 3U) + 1);
  }
  // The half-edge whose face_above() this is.
  [[nodiscard]] HalfEdgeId side_above(HalfFaceId face) const {
    return HalfEdgeId(face.value() - 4 * TetId(lower_.finite_count()).value() - 1);
  }
  // One of the two half-edges stands for the edge.
  [[nodiscard]] HalfEdgeId representative(HalfEdgeId h) const {
    return std::min(h, lower_.opposite(h));
  }

  void start_type1();
  [[nodiscard]] bool trace_upper_edges();
  [[nodiscard]] bool trace(HalfEdgeId upper);
  [[nodiscard]] HalfEdgeId cell_from(HalfEdgeId start, TriangleId t) const;
  void enter(TriangleId t, HalfEdgeId cell);
  [[nodiscard]] HalfEdgeId exit_from(HalfEdgeId lower, const Bisector& line) const;
  [[nodiscard]] HalfEdgeId first_exit(HalfEdgeId lower, const Bisector& line) const;
  void sort_by_lower_edge();
  void chain_lower_edges();
  void fetch(std::size_t place) const;
  void chain(HalfEdgeId edge);
  void settle_lower_triangles();
  void settle(HalfEdgeId side, HalfFaceId face, PlaneVertexId nearest_above);

  const WatchedWork& work_;
  std::size_t most_tets_;
  PlaneDiagram lower_;
  PlaneDiagram upper_;
  std::uint32_t first_upper_;  // the mesh's vertex that is the upper plane's first
  CentresAndSites lower_centres_;
  CentresAndSites upper_centres_;

  std::vector<TetSlot> slots_;
  std::vector<HalfEdgeId> edge_of_;  // by type-2 tet: the lower edge it cuts
  // By lower edge, its representative: how many type-2 tets cut it; once these are sorted, where
  // they end in on_edge_.
  IdVector<HalfEdgeId, std::uint32_t> end_on_edge_;
  std::vector<TetId> on_edge_;

  // By finite upper triangle: a half-edge from the lower vertex nearest to its circumcentre.
  IdVector<TriangleId, HalfEdgeId> cell_of_;
  std::vector<TriangleId> settled_;  // lower triangles whose neighbours are still to be seen

  // Scratch of chain(), by upper vertex: the tet on lower edge `edge` to whose left it is.
  struct Cell {
    HalfEdgeId edge;
    TetId tet;
  };
  IdVector<PlaneVertexId, Cell> cells_;
};

// Type-1 tets in their places, apexes still invalid: below {s0, s1, s2, apex}, above
// {apex, t0, t1, t2}; both are positive.
void SlabOverlay::start_type1() {
  const std::size_t vertices = lower_.vertex_count() + upper_.vertex_count();
  // 6.9 on 110 real stacks, up to 20 between large curves that wind around each other. Of a large
  // array the part that is not used costs no memory, but growing would copy the rest.
  constexpr std::size_t kManyVertices = 20000;
  const std::size_t expected = (vertices < kManyVertices ? 7 : 20) * vertices;
  slots_.reserve(expected);
  edge_of_.reserve(expected - first_type2());
  slots_.resize(first_type2());
  for (std::size_t k = 0; k < lower_.finite_count(); ++k) {
    const TriangleId t(k);
    for (std::uint32_t i = 0; i < 3; ++i) {
      tet(tet_below(t))[i] = lower_vertex(lower_.apex(PlaneDiagram::half_edge(t, i)));
    }
  }
  for (std::size_t k = 0; k < upper_.finite_count(); ++k) {
    const TriangleId t(k);
    for (std::uint32_t i = 0; i < 3; ++i) {
      tet(tet_above(t))[i + 1] = upper_vertex(upper_.apex(PlaneDiagram::half_edge(t, i)));
    }
  }
  end_on_edge_.resize(lower_.half_edge_slots());
  cell_of_.resize(upper_.finite_count());
}

// Every upper Voronoi edge once, from a circumcentre whose cell is known; its other end is then
// known as well. In order of triangles, which are near each other: where no trace came by, the
// cell is a few steps from the last one. False at too many tets.
bool SlabOverlay::trace_upper_edges() {
  HalfEdgeId near = PlaneDiagram::half_edge(TriangleId(0), 0);
  for (std::size_t k = 0; k < upper_.finite_count(); ++k) {
    if (k % kTrianglesOfLook == 0) work_.go_on();
    const TriangleId t(k);
    if (!cell_of_[t].valid()) enter(t, cell_from(near, t));
    near = cell_of_[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId h = PlaneDiagram::half_edge(t, i);
      if (!opposite(face_above(h)).valid() && !trace(h)) return false;
    }
  }
  return true;
}

// Goes from cell to cell, always nearer to the circumcentre of upper triangle t, until no
// neighbour is nearer. Power diagrams have no other local minima.
HalfEdgeId SlabOverlay::cell_from(HalfEdgeId start, TriangleId t) const {
  HalfEdgeId h = start;
  for (HalfEdgeId at = h;;) {
    const PlaneVertexId to = lower_.destination(at);
    if (to != PlaneDiagram::kGhostVertex &&
        Bisector(upper_centres_, to, lower_.origin(at)).nearer_to_first(t)) {
      h = at = lower_.opposite(at);
      continue;
    }
    at = lower_.turn_left(at);
    if (at == h) return h;
  }
}

void SlabOverlay::enter(TriangleId t, HalfEdgeId cell) {
  cell_of_[t] = cell;
  tet(tet_above(t))[0] = lower_vertex(lower_.origin(cell));
}

// The edge by which an upper Voronoi edge, on the line between the site to its left and that to
// its right, leaves the cell of the origin of `lower`, having entered it across `lower`. The
// cell's boundary, counter-clockwise, passes from the right of a line to its left where the line
// leaves.
HalfEdgeId SlabOverlay::exit_from(HalfEdgeId lower, const Bisector& line) const {
  HalfEdgeId h = lower;
  do {
    h = lower_.turn_left(h);
    TETLOFT_CHECK(h != lower);
  } while (!line.nearer_to_first(lower_.left(h)));
  return h;
}

// The same where the line starts inside the cell, or in front of it.
HalfEdgeId SlabOverlay::first_exit(HalfEdgeId lower, const Bisector& line) const {
  HalfEdgeId h = lower;
  if (!line.nearer_to_first(lower_.left(h))) return exit_from(h, line);
  while (line.nearer_to_first(lower_.right(h))) {
    h = lower_.turn_right(h);
    TETLOFT_CHECK(h != lower);
  }
  return h;
}

// Follows the Voronoi edge dual to `upper` from its triangle's circumcentre to that of the
// triangle across, or to infinity. False at too many tets.
bool SlabOverlay::trace(HalfEdgeId upper) {
  const PlaneVertexId left = upper_.destination(upper);
  const PlaneVertexId right = upper_.origin(upper);
  const TriangleId target = upper_.right(upper);
  const bool is_ray = upper_.is_ghost(target);
  const Bisector line(lower_centres_, left, right);
  HalfFaceId last = face_above(upper);
  HalfEdgeId exit = first_exit(cell_of_[upper_.left(upper)], line);
  for (;;) {
    const PlaneVertexId behind = lower_.origin(exit);
    const PlaneVertexId ahead = lower_.destination(exit);
    const bool leaves = ahead != PlaneDiagram::kGhostVertex &&
                        (is_ray || Bisector(upper_centres_, ahead, behind).nearer_to_first(target));
    if (!leaves) break;
    if (slots_.size() == most_tets_) return false;
    const TetId t(slots_.size());
    slots_.push_back(
        {{lower_vertex(behind), lower_vertex(ahead), upper_vertex(left), upper_vertex(right)}, {}});
    glue(last, half_face(t, kBehind));
    last = half_face(t, kAhead);
    edge_of_.push_back(representative(exit));
    ++end_on_edge_[edge_of_.back()];
    exit = exit_from(lower_.opposite(exit), line);
  }
  if (is_ray) return true;
  glue(last, face_above(upper_.opposite(upper)));
  if (cell_of_[target].valid()) {
    TETLOFT_CHECK(lower_.origin(cell_of_[target]) == lower_.origin(exit));
    return true;
  }
  enter(target, exit);
  return true;
}

void SlabOverlay::sort_by_lower_edge() {
  std::uint32_t sum = 0;
  for (std::uint32_t& end : end_on_edge_) {
    const std::uint32_t begin = sum;
    sum += end;
    end = begin;
  }
  on_edge_.resize(edge_of_.size());
  for (std::size_t k = 0; k < edge_of_.size(); ++k) {
    on_edge_[end_on_edge_[edge_of_[k]]++] = TetId(first_type2() + k);
  }
}

// Glues the type-2 tets of every lower edge along it, and with the type-1 tets at its ends.
void SlabOverlay::chain_lower_edges() {
  sort_by_lower_edge();
  cells_.resize(upper_.vertex_count());
  for (std::size_t k = 0; k < lower_.half_edge_slots(); ++k) {
    if (!tets_on(HalfEdgeId(k)).empty()) chain(HalfEdgeId(k));
  }
}

// Asks for the slot of the tet at a place of on_edge_: tets of one edge lie apart.
void SlabOverlay::fetch(std::size_t place) const {
  if (place < on_edge_.size()) core::prefetch(&slots_[on_edge_[place].index()]);
}

// The Voronoi edge passes each upper cell in one piece: of two tets in a row the first has to
// its right what the second has to its left.
void SlabOverlay::chain(HalfEdgeId edge) {
  const std::span<const TetId> tets = tets_on(edge);
  // Seen along `edge`, which a tet's upper edge may cross either way.
  const VertexId origin = lower_vertex(lower_.origin(edge));
  const auto left_face = [&](TetId t) { return tet(t)[0] == origin ? kLeft : kRight; };
  const auto upper_of_face = [&](TetId t, std::uint32_t face) {
    // Opposite the vertex to one side, the face holds that to the other.
    const VertexId v = tet(t)[face == kLeft ? 2 : 3];
    return in_upper_plane(v);
  };
  const auto begin = static_cast<std::size_t>(tets.data() - on_edge_.data());
  for (std::size_t i = 0; i < tets.size(); ++i) {
    fetch(begin + i + kFetchedAhead);
    cells_[upper_of_face(tets[i], left_face(tets[i]))] = {edge, tets[i]};
  }
  for (const TetId t : tets) {
    const std::uint32_t face = left_face(t) == kLeft ? kRight : kLeft;
    const PlaneVertexId cell = upper_of_face(t, face);
    if (cells_[cell].edge == edge) {
      const TetId following = cells_[cell].tet;
      glue(half_face(t, face), half_face(following, left_face(following)));
    } else {
      settle(lower_.opposite(edge), half_face(t, face), cell);
    }
  }
  for (const TetId t : tets) {
    const std::uint32_t face = left_face(t);
    if (opposite(half_face(t, face)).valid()) continue;
    settle(edge, half_face(t, face), upper_of_face(t, face));
    break;
  }
}

// Glues `face` to the type-1 tet of the triangle to the left of `side`, whose circumcentre then
// lies in the cell of `nearest_above`.
void SlabOverlay::settle(HalfEdgeId side, HalfFaceId face, PlaneVertexId nearest_above) {
  const TriangleId t = lower_.left(side);
  if (lower_.is_ghost(t)) return;
  glue(face, face_below(side));
  VertexId& apex = tet(tet_below(t))[3];
  const VertexId v = upper_vertex(nearest_above);
  TETLOFT_CHECK(!apex.valid() || apex == v);
  if (apex.valid()) return;
  apex = v;
  settled_.push_back(t);
}

// Lower Voronoi edges without crossings join circumcentres of one cell. All are reached: type-1
// tets below have no type-1 neighbours above, so each group has a crossing at its rim.
void SlabOverlay::settle_lower_triangles() {
  while (!settled_.empty()) {
    const TriangleId t = settled_.back();
    settled_.pop_back();
    const PlaneVertexId nearest_above = in_upper_plane(tet(tet_below(t))[3]);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId h = PlaneDiagram::half_edge(t, i);
      if (!tets_on(representative(h)).empty()) continue;
      settle(lower_.opposite(h), face_below(h), nearest_above);
    }
  }
}

// The tets of an upper edge follow each other: the first has a type-1 tet behind it, over the
// half-edge that was traced.
std::vector<TetBase> SlabOverlay::bases() const {
  const auto named = [](const PlaneDiagram& plane, HalfEdgeId h) {
    return side_of(plane.input_of(PlaneDiagram::triangle(h)), h.value() & 3U);
  };
  std::vector<TetBase> result;
  result.reserve(slots_.size());
  for (std::size_t k = 0; k < lower_.finite_count(); ++k) {
    result.push_back({side_of(lower_.input_of(TriangleId(k)), 0), {}});
  }
  for (std::size_t k = 0; k < upper_.finite_count(); ++k) {
    result.push_back({{}, side_of(upper_.input_of(TriangleId(k)), 0)});
  }
  TriangleSideId upper;
  for (std::size_t k = 0; k < edge_of_.size(); ++k) {
    const HalfFaceId behind = slots_[first_type2() + k].opposite[kBehind];
    if (TetMesh::tet_of(behind).index() < first_type2()) upper = named(upper_, side_above(behind));
    result.push_back({named(lower_, edge_of_[k]), upper});
  }
  return result;
}

}  // namespace

std::vector<TetSlot> slab_overlay(const Triangulation2& lower, const Triangulation2& upper,
                                  const WatchedWork& work, std::size_t most_tets) {
  SlabOverlay overlay(lower, upper, work, most_tets);
  if (!overlay.run()) return {};
  return overlay.take_slots();
}

SlabTets slab_overlay_with_bases(const Triangulation2& lower, const Triangulation2& upper,
                                 const WatchedWork& work, std::size_t most_tets) {
  SlabOverlay overlay(lower, upper, work, most_tets);
  if (!overlay.run()) return {};
  std::vector<TetBase> bases = overlay.bases();
  return {overlay.take_slots(), std::move(bases)};
}

}  // namespace tetloft::internal::delaunay3_detail
