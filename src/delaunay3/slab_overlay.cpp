// See slab_overlay.hpp.
//
// Canonical order is that of the tets' sorted vertices. All of the lower plane come before all of
// the upper one, so it follows from the order of the planes' edges: at each lower vertex, by its
// edges to higher ones, the type-1 tets on triangles of which this is the lowest edge, by their
// third vertex, and the type-2 tets on it, by their upper edge; then the type-1 tets whose apex the
// vertex is, by their triangle. So every tet has its final place as soon as the crossings of each
// lower edge are counted, and is made there: there are no others to be sorted or renamed.
#include "delaunay3/slab_overlay.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "core/pages.hpp"
#include "delaunay3/tet_slot.hpp"
#include "delaunay3/upper_trace.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Type-2 tets are {a, b, left, right}: the lower edge, a < b, and what the upper edge has to the
// left and to the right of one who crosses from the cell of a to that of b. They are positive, and
// the first two in order. Their faces lead to the tet without that vertex.
constexpr std::uint32_t kIntoHigher = 0;  // opposite a: on into the cell of b
constexpr std::uint32_t kIntoLower = 1;   // opposite b
constexpr std::uint32_t kToRight = 2;     // opposite the vertex to the left
constexpr std::uint32_t kToLeft = 3;      // opposite the vertex to the right

// A type-1 tet below, {s0, s1, s2, apex} in the order of its triangle, which starts at its lowest
// vertex: sorted and with the last two exchanged, as an odd permutation asks for, where s2 < s1.
class TetBelow {
 public:
  TetBelow() = default;
  TetBelow(std::uint32_t tet, bool exchanged) : packed_(2 * tet + (exchanged ? 1U : 0U)) {}
  [[nodiscard]] TetId tet() const { return TetId(packed_ >> 1); }
  // The place of its k-th vertex, and of the face opposite.
  [[nodiscard]] std::uint32_t place(std::uint32_t k) const {
    constexpr std::array<std::array<std::uint8_t, 4>, 2> kPlaces{{{0, 1, 2, 3}, {0, 3, 1, 2}}};
    return kPlaces[packed_ & 1U][k];
  }
  [[nodiscard]] HalfFaceId face(std::uint32_t k) const { return half_face(tet(), place(k)); }

 private:
  std::uint32_t packed_ = 0;
};

class SlabOverlay {
 public:
  SlabOverlay(const SlabDiagrams& planes, UpperTrace trace, const SlabVertexNames& names)
      : planes_(planes),
        lower_(planes.lower),
        upper_(planes.upper),
        trace_(std::move(trace)),
        names_(names),
        tet_count_(planes.type1_count() + trace_.crossings.size()),
        tets_(pages_for<TetVertices>(tet_count_)),
        opposite_(pages_for<HalfFaceId>(4 * tet_count_)) {}

  // Before run(), where bases are asked for.
  void with_bases() { base_.resize(tet_count_); }
  void run() {
    number_tets();
    place_type2();
    chain_lower_edges();
  }
  [[nodiscard]] TetMesh take_mesh() {
    return TetMesh::from_adjacency(names_.input_count, std::move(tets_), std::move(opposite_));
  }
  [[nodiscard]] IdVector<TetId, TetBase> take_bases() { return std::move(base_); }

 private:
  template <class T>
  [[nodiscard]] static std::vector<T> pages_for(std::size_t count) {
    std::vector<T> items;
    items.reserve(count);
    core::make_pages(items.data(), count);
    items.resize(count);
    return items;
  }
  [[nodiscard]] VertexId named(VertexId v) const {
    return names_.input_of.empty() ? v : names_.input_of[v.index()];
  }
  // The vertices of the mesh: the lower plane's, then the upper's.
  [[nodiscard]] VertexId lower_vertex(PlaneVertexId v) const { return named(VertexId(v.value())); }
  [[nodiscard]] VertexId upper_vertex(PlaneVertexId v) const {
    return named(VertexId(lower_.vertex_count() + v.index()));
  }
  [[nodiscard]] TetVertices& tet(TetId t) { return tets_[t.index()]; }
  void glue(HalfFaceId a, HalfFaceId b) {
    opposite_[a.index()] = b;
    opposite_[b.index()] = a;
  }
  // The face of a type-1 tet over half-edge h of its triangle.
  [[nodiscard]] HalfFaceId face_below(HalfEdgeId h) const {
    return below_[PlaneDiagram::triangle(h)].face(h.value() & 3U);
  }
  [[nodiscard]] HalfFaceId face_above(HalfEdgeId h) const {
    return half_face(above_[PlaneDiagram::triangle(h)], (h.value() & 3U) + 1);
  }
  [[nodiscard]] static TriangleSideId side(const PlaneDiagram& plane, HalfEdgeId h) {
    const HalfEdgeId finite = plane.is_ghost(PlaneDiagram::triangle(h)) ? plane.opposite(h) : h;
    return side_of(plane.input_of(PlaneDiagram::triangle(finite)), finite.value() & 3U);
  }

  void number_tets();
  void start_below(TriangleId t, std::uint32_t name);
  void start_above(TriangleId t, TetId name);
  void place_type2();
  void place_run(EdgeId f);
  // Until chain() is on the lower edge of a type-2 tet, its half-faces are all that is touched of
  // it: kToRight tells its upper edge, and which way this crosses.
  void note(TetId t, Crossing upper) {
    opposite_[half_face(t, kToRight).index()] = HalfFaceId(upper.packed());
  }
  [[nodiscard]] Crossing noted(TetId t) const {
    return Crossing::unpacked(opposite_[half_face(t, kToRight).index()].value());
  }
  void chain_lower_edges();
  void chain(EdgeId e);
  void settle(HalfEdgeId side, HalfFaceId face, PlaneVertexId nearest_above);
  [[nodiscard]] bool is_crossed(HalfEdgeId h) const {
    return trace_.count_on_edge[planes_.lower_edges.edge(h)] != 0;
  }
  void settle_neighbours();

  const SlabDiagrams& planes_;
  const PlaneDiagram& lower_;
  const PlaneDiagram& upper_;
  UpperTrace trace_;
  SlabVertexNames names_;
  std::size_t tet_count_;
  std::vector<TetVertices> tets_;
  std::vector<HalfFaceId> opposite_;
  IdVector<TetId, TetBase> base_;  // empty where nobody asks

  // The type-1 tets of the finite triangles.
  IdVector<TriangleId, TetBelow> below_;
  IdVector<TriangleId, TetId> above_;
  // By lower edge: where its next type-2 tet goes, so in the end behind its last one.
  IdVector<EdgeId, std::uint32_t> place_;

  // Sides without crossings of lower triangles that have their apex, from their triangle on.
  struct Uncrossed {
    HalfEdgeId side;
    PlaneVertexId nearest_above;
  };
  std::vector<Uncrossed> uncrossed_;

  // Scratch of chain(), by upper vertex: the tet on lower edge `edge` to whose left it is.
  struct Cell {
    EdgeId edge;
    TetId tet;
  };
  IdVector<PlaneVertexId, Cell> cells_;
  struct UpperVertices {
    PlaneVertexId left;
    PlaneVertexId right;
  };
  std::vector<UpperVertices> chained_;  // scratch of chain(): of the tets on the edge
};

// Visits the finite triangles of which edge e is the lowest, by their third vertex.
template <class Visit>
void for_each_triangle_from(const PlaneDiagram& plane, HalfEdgeId e, const Visit& visit) {
  const HalfEdgeId back = plane.opposite(e);
  const PlaneVertexId higher = plane.destination(e);
  const auto third_of = [&](HalfEdgeId h) {
    const PlaneVertexId v = plane.apex(h);
    return higher < v && v != PlaneDiagram::kGhostVertex ? v : PlaneVertexId();
  };
  const PlaneVertexId left = third_of(e);
  const PlaneVertexId right = third_of(back);
  if (right < left) visit(PlaneDiagram::triangle(back));
  if (left.valid()) visit(PlaneDiagram::triangle(e));
  if (left < right && right.valid()) visit(PlaneDiagram::triangle(back));
}

// Gives every tet its number; those of type 1 are made, with the apex of those below to come.
void SlabOverlay::number_tets() {
  const DiagramEdges& edges = planes_.lower_edges;
  std::vector<std::uint32_t> above_at(lower_.vertex_count());
  for (const PlaneVertexId v : trace_.nearest_below) ++above_at[v.index()];
  below_.resize(lower_.finite_count());
  above_.resize(upper_.finite_count());
  place_.reserve(edges.size());
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < above_at.size(); ++v) {
    while (place_.size() < edges.size()) {
      const EdgeId e = place_.end_id();
      const HalfEdgeId h = edges.half_edge(e);
      if (lower_.origin(h).index() != v) break;
      for_each_triangle_from(lower_, h, [&](TriangleId t) { start_below(t, next++); });
      place_.push_back(next);
      next += trace_.count_on_edge[e];
    }
    next += std::exchange(above_at[v], next);
  }
  TETLOFT_CHECK(next == tet_count_);
  for (const EdgeId e : planes_.upper_edges.ids()) {
    for_each_triangle_from(upper_, planes_.upper_edges.half_edge(e), [&](TriangleId t) {
      start_above(t, TetId(above_at[trace_.nearest_below[t].index()]++));
    });
  }
}

void SlabOverlay::start_below(TriangleId t, std::uint32_t name) {
  const auto corner = [&](std::uint32_t i) { return lower_.apex(PlaneDiagram::half_edge(t, i)); };
  const TetBelow below(name, corner(2) < corner(1));
  below_[t] = below;
  for (std::uint32_t i = 0; i < 3; ++i) tet(below.tet())[below.place(i)] = lower_vertex(corner(i));
  if (!base_.empty()) base_[below.tet()].lower = side_of(lower_.input_of(t), 0);
}

void SlabOverlay::start_above(TriangleId t, TetId name) {
  above_[t] = name;
  tet(name)[0] = lower_vertex(trace_.nearest_below[t]);
  for (std::uint32_t i = 0; i < 3; ++i) {
    tet(name)[i + 1] = upper_vertex(upper_.apex(PlaneDiagram::half_edge(t, i)));
  }
  if (!base_.empty()) base_[name].upper = side_of(upper_.input_of(t), 0);
}

// In order of upper edges, so that those of each lower edge come to lie in order. Edges that are
// near each other in one plane cross such in the other, so what is written next is in cache.
void SlabOverlay::place_type2() {
  for (const EdgeId f : planes_.upper_edges.ids()) place_run(f);
}

// Glues the tets of an upper edge along it, and with the type-1 tets at its ends.
void SlabOverlay::place_run(EdgeId f) {
  const UpperTrace::Run& run = trace_.run[f];
  HalfFaceId last = face_above(run.upper);
  for (std::uint32_t k = run.begin; k < run.end; ++k) {
    const Crossing crossing = trace_.crossings[k];
    const TetId t(place_[crossing.edge()]++);
    note(t, Crossing(f, crossing.to_higher()));
    glue(last, half_face(t, crossing.to_higher() ? kIntoLower : kIntoHigher));
    last = half_face(t, crossing.to_higher() ? kIntoHigher : kIntoLower);
  }
  const HalfEdgeId target = upper_.opposite(run.upper);
  if (!upper_.is_ghost(PlaneDiagram::triangle(target))) glue(last, face_above(target));
}

// Glues the type-2 tets of every lower edge along it, and with the type-1 tets at its ends.
void SlabOverlay::chain_lower_edges() {
  cells_.resize(upper_.vertex_count());
  for (const EdgeId e : planes_.lower_edges.ids()) {
    if (trace_.count_on_edge[e] == 0) continue;
    chain(e);
    settle_neighbours();
  }
}

// The Voronoi edge passes each upper cell in one piece: of two tets in a row the first has to
// its right what the second has to its left.
void SlabOverlay::chain(EdgeId e) {
  const HalfEdgeId h = planes_.lower_edges.half_edge(e);
  const VertexId a = lower_vertex(lower_.origin(h));
  const VertexId b = lower_vertex(lower_.destination(h));
  const std::size_t begin = place_[e] - trace_.count_on_edge[e];
  chained_.clear();
  for (std::size_t k = begin; k < place_[e]; ++k) {
    const TetId t(k);
    const Crossing upper = noted(t);
    const UpperTrace::Run& run = trace_.run[upper.edge()];
    const PlaneVertexId left = upper.to_higher() ? run.left : run.right;
    const PlaneVertexId right = upper.to_higher() ? run.right : run.left;
    tet(t) = {a, b, upper_vertex(left), upper_vertex(right)};
    if (!base_.empty()) base_[t] = {side(lower_, h), side(upper_, run.upper)};
    cells_[left] = {e, t};
    chained_.push_back({left, right});
  }
  for (std::size_t i = 0; i < chained_.size(); ++i) {
    const PlaneVertexId cell = chained_[i].right;
    const HalfFaceId face = half_face(TetId(begin + i), kToRight);
    if (cells_[cell].edge == e) {
      glue(face, half_face(cells_[cell].tet, kToLeft));
    } else {
      settle(lower_.opposite(h), face, cell);
    }
  }
  // In front of the first there is none.
  std::size_t first = 0;
  while (opposite_[half_face(TetId(begin + first), kToLeft).index()].valid()) ++first;
  settle(h, half_face(TetId(begin + first), kToLeft), chained_[first].left);
}

// Glues `face` to the type-1 tet of the triangle to the left of `side`, whose circumcentre then
// lies in the cell of `nearest_above`; with none there on the hull.
void SlabOverlay::settle(HalfEdgeId side, HalfFaceId face, PlaneVertexId nearest_above) {
  const TriangleId t = lower_.left(side);
  if (lower_.is_ghost(t)) {
    opposite_[face.index()] = HalfFaceId();  // what was noted there
    return;
  }
  glue(face, face_below(side));
  VertexId& apex = tet(below_[t].tet())[below_[t].place(3)];
  const VertexId v = upper_vertex(nearest_above);
  TETLOFT_CHECK(!apex.valid() || apex == v);
  if (apex.valid()) return;
  apex = v;
  for (const HalfEdgeId h : {PlaneDiagram::next(side), PlaneDiagram::previous(side)}) {
    if (!is_crossed(h)) uncrossed_.push_back({h, nearest_above});
  }
}

// Lower Voronoi edges without crossings join circumcentres of one cell. All are reached in the end:
// type-1 tets below have no type-1 neighbours above, so each group has a crossing at its rim.
void SlabOverlay::settle_neighbours() {
  while (!uncrossed_.empty()) {
    const Uncrossed last = uncrossed_.back();
    uncrossed_.pop_back();
    settle(lower_.opposite(last.side), face_below(last.side), last.nearest_above);
  }
}

EdgesOfSides edges_of_sides(const PlaneDiagram& plane, const DiagramEdges& edges) {
  EdgesOfSides result(plane.finite_count());
  for (std::size_t k = 0; k < plane.finite_count(); ++k) {
    const TriangleId t(k);
    for (std::uint32_t i = 0; i < 3; ++i) {
      result[plane.input_of(t)][i] = edges.edge(PlaneDiagram::half_edge(t, i));
    }
  }
  return result;
}

}  // namespace

std::optional<TetMesh> slab_overlay(const Triangulation2& lower, const Triangulation2& upper,
                                    const SlabVertexNames& names, WatchedWork& work,
                                    std::size_t most_tets) {
  const SlabDiagrams planes(lower, upper);
  std::optional<UpperTrace> trace = trace_upper_edges(planes, work, most_tets);
  if (!trace) return std::nullopt;
  work.step_done_go_on();
  SlabOverlay overlay(planes, *std::move(trace), names);
  overlay.run();
  return overlay.take_mesh();
}

std::optional<SlabTets> slab_overlay_with_bases(const Triangulation2& lower,
                                                const Triangulation2& upper,
                                                const WatchedWork& work, std::size_t most_tets) {
  const SlabDiagrams planes(lower, upper);
  std::optional<UpperTrace> trace = trace_upper_edges(planes, work, most_tets);
  if (!trace) return std::nullopt;
  SlabOverlay overlay(planes, *std::move(trace),
                      {.input_of = {}, .input_count = lower.points.size() + upper.points.size()});
  overlay.with_bases();
  overlay.run();
  SlabTets result;
  result.mesh = overlay.take_mesh();
  result.base = overlay.take_bases();
  result.edges = {edges_of_sides(planes.lower, planes.lower_edges),
                  edges_of_sides(planes.upper, planes.upper_edges)};
  return result;
}

}  // namespace tetloft::internal::delaunay3_detail
