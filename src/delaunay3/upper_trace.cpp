// See upper_trace.hpp.
#include "delaunay3/upper_trace.hpp"

#include <algorithm>
#include <utility>

#include "core/guard.hpp"
#include "delaunay3/nearer.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// So many upper triangles are traced between two looks at the stop token.
constexpr std::size_t kTrianglesOfLook = 1024;

// 6.9 tets a vertex on 110 real stacks, up to 20 between large curves that wind around each other.
// Of a large array the part that is not used costs no memory, but growing would copy the rest.
std::size_t expected_tets(std::size_t vertices) {
  constexpr std::size_t kManyVertices = 20000;
  return (vertices < kManyVertices ? 7 : 20) * vertices;
}

class UpperTracer {
 public:
  UpperTracer(const SlabDiagrams& planes, const WatchedWork& work, std::size_t most_tets)
      : planes_(planes),
        lower_(planes.lower),
        upper_(planes.upper),
        work_(work),
        most_crossings_(most_tets - planes.type1_count()),
        lower_centres_{&lower_, &upper_, true},
        upper_centres_{&upper_, &lower_, false},
        cell_of_(upper_.finite_count()) {
    const std::size_t vertices = lower_.vertex_count() + upper_.vertex_count();
    result_.crossings.reserve(expected_tets(vertices) - planes.type1_count());
    result_.run.resize(planes.upper_edges.size());
    result_.count_on_edge.resize(planes.lower_edges.size());
  }

  std::optional<UpperTrace> run() {
    if (!trace_all()) return std::nullopt;
    result_.nearest_below.reserve(cell_of_.size());
    for (const HalfEdgeId cell : cell_of_) result_.nearest_below.push_back(lower_.origin(cell));
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool trace_all();
  [[nodiscard]] bool trace(HalfEdgeId upper);
  [[nodiscard]] HalfEdgeId cell_from(HalfEdgeId start, TriangleId t) const;
  [[nodiscard]] HalfEdgeId exit_from(HalfEdgeId lower, const Bisector& line) const;
  [[nodiscard]] HalfEdgeId first_exit(HalfEdgeId lower, const Bisector& line) const;
  [[nodiscard]] bool ends_before(HalfEdgeId exit, TriangleId target) const;

  const SlabDiagrams& planes_;
  const PlaneDiagram& lower_;
  const PlaneDiagram& upper_;
  const WatchedWork& work_;
  std::size_t most_crossings_;
  CentresAndSites lower_centres_;
  CentresAndSites upper_centres_;
  // By finite upper triangle: a half-edge from the lower vertex nearest to its circumcentre.
  IdVector<TriangleId, HalfEdgeId> cell_of_;
  UpperTrace result_;
};

// Every upper Voronoi edge once, from a circumcentre whose cell is known; its other end is then
// known as well. In order of triangles, which are near each other: where no trace came by, the
// cell is a few steps from the last one. False at too many tets.
bool UpperTracer::trace_all() {
  HalfEdgeId near = PlaneDiagram::half_edge(TriangleId(0), 0);
  for (std::size_t k = 0; k < upper_.finite_count(); ++k) {
    if (k % kTrianglesOfLook == 0) work_.go_on();
    const TriangleId t(k);
    if (!cell_of_[t].valid()) cell_of_[t] = cell_from(near, t);
    near = cell_of_[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId h = PlaneDiagram::half_edge(t, i);
      if (!result_.run[planes_.upper_edges.edge(h)].upper.valid() && !trace(h)) return false;
    }
  }
  return true;
}

// Goes from cell to cell, always nearer to the circumcentre of upper triangle t, until no
// neighbour is nearer. Power diagrams have no other local minima.
HalfEdgeId UpperTracer::cell_from(HalfEdgeId start, TriangleId t) const {
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

// The edge by which an upper Voronoi edge, on the line between the site to its left and that to
// its right, leaves the cell of the origin of `lower`, having entered it across `lower`. The
// cell's boundary, counter-clockwise, passes from the right of a line to its left where the line
// leaves.
HalfEdgeId UpperTracer::exit_from(HalfEdgeId lower, const Bisector& line) const {
  HalfEdgeId h = lower;
  do {
    h = lower_.turn_left(h);
    TETLOFT_CHECK(h != lower);
  } while (!line.nearer_to_first(lower_.left(h)));
  return h;
}

// The same where the line starts inside the cell, or in front of it.
HalfEdgeId UpperTracer::first_exit(HalfEdgeId lower, const Bisector& line) const {
  HalfEdgeId h = lower;
  if (!line.nearer_to_first(lower_.left(h))) return exit_from(h, line);
  while (line.nearer_to_first(lower_.right(h))) {
    h = lower_.turn_right(h);
    TETLOFT_CHECK(h != lower);
  }
  return h;
}

// Does an upper Voronoi edge end at the circumcentre of `target`, or never, before it reaches the
// exit of the cell that it is in? It passes every cell in one piece.
bool UpperTracer::ends_before(HalfEdgeId exit, TriangleId target) const {
  const PlaneVertexId ahead = lower_.destination(exit);
  if (ahead == PlaneDiagram::kGhostVertex) return true;
  if (upper_.is_ghost(target)) return false;
  if (cell_of_[target].valid()) return lower_.origin(cell_of_[target]) == lower_.origin(exit);
  return !Bisector(upper_centres_, ahead, lower_.origin(exit)).nearer_to_first(target);
}

// Follows the Voronoi edge dual to `upper` from its triangle's circumcentre to that of the
// triangle across, or to infinity. False at too many tets.
bool UpperTracer::trace(HalfEdgeId upper) {
  const TriangleId target = upper_.right(upper);
  UpperTrace::Run& run = result_.run[planes_.upper_edges.edge(upper)];
  run = {.upper = upper,
         .left = upper_.destination(upper),
         .right = upper_.origin(upper),
         .begin = static_cast<std::uint32_t>(result_.crossings.size()),
         .end = 0};
  const Bisector line(lower_centres_, run.left, run.right);
  HalfEdgeId exit = first_exit(cell_of_[upper_.left(upper)], line);
  while (!ends_before(exit, target)) {
    if (result_.crossings.size() == most_crossings_) return false;
    const EdgeId edge = planes_.lower_edges.edge(exit);
    result_.crossings.emplace_back(edge, lower_.origin(exit) < lower_.destination(exit));
    ++result_.count_on_edge[edge];
    exit = exit_from(lower_.opposite(exit), line);
  }
  run.end = static_cast<std::uint32_t>(result_.crossings.size());
  if (!upper_.is_ghost(target)) cell_of_[target] = exit;
  return true;
}

}  // namespace

SlabDiagrams::SlabDiagrams(const Triangulation2& lower_plane, const Triangulation2& upper_plane)
    : lower(lower_plane, std::max(reach_of(lower_plane.points), reach_of(upper_plane.points))),
      upper(upper_plane, std::max(reach_of(lower_plane.points), reach_of(upper_plane.points))),
      lower_edges(lower, lower_plane),
      upper_edges(upper, upper_plane) {}

std::optional<UpperTrace> trace_upper_edges(const SlabDiagrams& planes, const WatchedWork& work,
                                            std::size_t most_tets) {
  if (planes.type1_count() > most_tets) return std::nullopt;
  return UpperTracer(planes, work, most_tets).run();
}

}  // namespace tetloft::internal::delaunay3_detail
