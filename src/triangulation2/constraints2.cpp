// Constraints: inserted, removed, asked for.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "delaunay2/spatial_order.hpp"
#include "triangulation2/crossing_of.hpp"
#include "triangulation2/edges_of_plane.hpp"
#include "triangulation2/handles2.hpp"

namespace tetloft {

using namespace internal;
using triangulation2::EdgesOfPlane;
using triangulation2::HalfEdgeId;
using triangulation2::Incremental2;
using triangulation2::LivePlane;
using triangulation2::PlaneWall;

namespace {

// Pieces that one constraint may lead to.
constexpr std::size_t kMostPieces = std::size_t{1} << 16;

Error no_constraint(ConstraintId c) {
  std::string message = "there is no constraint";
  if (c.valid()) message.append(" ").append(std::to_string(c.value()));
  return {ErrorCode::invalid_input, message + ", or no longer", {}};
}

Error crossed_by(const LivePlane& plane, const std::array<VertexId, 2>& wall, VertexId u,
                 VertexId v) {
  Error error{ErrorCode::invalid_input,
              "a constraint of vertices " + std::to_string(u.value()) + " and " +
                  std::to_string(v.value()) + " crosses constraint " +
                  std::to_string(plane.walls().find(wall[0], wall[1])->lowest().value()),
              {}};
  const std::optional<Point2> at = triangulation2::crossing_of(
      plane.point(u), plane.point(v), plane.point(wall[0]), plane.point(wall[1]));
  if (at) error.where.point = Point3{at->x, at->y, 0};
  return error;
}

}  // namespace

Result<void> DelaunayTriangulation2::Impl::check_ends(
    const std::array<DelaunayVertex, 2>& segment) const {
  for (const DelaunayVertex end : segment) {
    if (!is_live(end)) return no_such_vertex(end);
  }
  if (segment[0] != segment[1]) return {};
  Error error{ErrorCode::invalid_input, "a constraint from a vertex to itself", {}};
  error.where.vertex = segment[0].index;
  return error;
}

Result<std::vector<VertexId>> DelaunayTriangulation2::Impl::path_between(VertexId u,
                                                                         VertexId v) const {
  std::vector<VertexId> path{u};
  while (path.back() != v) {
    const LivePlane::Step step = plane.step(path.back(), v);
    if (step.crossed[0].valid()) return crossed_by(plane, step.crossed, u, v);
    path.push_back(step.reached);
  }
  return path;
}

void DelaunayTriangulation2::Impl::lay(ConstraintId c, std::span<const VertexId> path) {
  std::size_t made = 0;
  try {
    for (; made + 1 < path.size(); ++made) plane.add_to_edge(path[made], path[made + 1], {&c, 1});
  } catch (...) {
    while (made-- > 0) plane.take_from_edge(path[made], path[made + 1], c);
    throw;
  }
}

// All is looked at before anything changes.
Result<ConstraintId> DelaunayTriangulation2::Impl::constrain(VertexId u, VertexId v) {
  const Result<std::vector<VertexId>> path = path_between(u, v);
  if (!path) return path.error();
  const ConstraintId c = ends.push_back({u, v});
  try {
    lay(c, *path);
  } catch (...) {
    ends.resize(ends.size() - 1);
    throw;
  }
  ++constraint_count;
  return c;
}

// Along a curve, so that one finds in the cache what the last one left there. If none is refused
// that is the same as one after the other. No vertex comes, so where two segments cross away from
// vertices each crosses an edge that the other goes over, and the later one is refused in any
// order; if none is, each goes over the edges between the vertices on it, as it would in any order,
// and the triangulation with these walls is unique.
bool DelaunayTriangulation2::Impl::constrain_in_any_order(
    std::span<const std::array<DelaunayVertex, 2>> segments) {
  std::vector<Point2> starts;
  starts.reserve(segments.size());
  const std::size_t before = ends.size();
  ends.reserve(before + segments.size());
  for (const std::array<DelaunayVertex, 2>& segment : segments) {
    if (!check_ends(segment)) return false;
    starts.push_back(plane.point(id(segment[0])));
    ends.push_back({id(segment[0]), id(segment[1])});
  }
  for (const std::uint32_t i : delaunay2_detail::insertion_order(starts)) {
    const ConstraintId c(before + i);
    const Result<std::vector<VertexId>> path = path_between(ends[c][0], ends[c][1]);
    if (!path) return false;
    lay(c, *path);
  }
  constraint_count += segments.size();
  return true;
}

// Piece by piece: what crosses a wall is divided where it does, and the wall with it.
Result<ConstraintId> DelaunayTriangulation2::Impl::constrain_dividing(VertexId u, VertexId v) {
  struct Piece {
    std::vector<ConstraintId> of;
    VertexId from;
    VertexId to;
  };
  const ConstraintId c = ends.push_back({u, v});
  ++constraint_count;
  std::vector<Piece> pieces{{{c}, u, v}};
  for (std::size_t work = 0; !pieces.empty(); ++work) {
    if (work == kMostPieces) {
      return Error{
          ErrorCode::work_limit, "constraints that cross end in more than 2^16 pieces", {}};
    }
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    if (piece.from == piece.to) continue;
    const LivePlane::Step step = plane.step(piece.from, piece.to);
    if (!step.crossed[0].valid()) {
      plane.add_to_edge(piece.from, step.reached, piece.of);
      pieces.push_back({piece.of, step.reached, piece.to});
      continue;
    }
    const VertexId p = step.crossed[0];
    const VertexId q = step.crossed[1];
    const std::optional<Point2> at = triangulation2::crossing_of(
        plane.point(piece.from), plane.point(piece.to), plane.point(p), plane.point(q));
    if (!at) {
      return Error{
          ErrorCode::unrepresentable, "where constraints cross is beyond the range of doubles", {}};
    }
    const VertexId x(insert(*at, p).vertex.index);
    pieces.push_back({piece.of, x, piece.to});
    pieces.push_back({piece.of, piece.from, x});
    // Gone where x lies on it and has divided it.
    if (x == p || x == q || plane.walls().find(p, q) == nullptr) continue;
    const std::vector<ConstraintId> over = plane.open_edge(p, q);
    pieces.push_back({over, p, x});
    pieces.push_back({over, x, q});
  }
  return c;
}

// From one end along edges that it goes over: it is connected.
std::vector<std::array<VertexId, 2>> DelaunayTriangulation2::Impl::edges_of(ConstraintId c) const {
  std::set<std::array<VertexId, 2>> edges;
  std::vector<VertexId> open{ends[c][0]};
  while (!open.empty()) {
    const VertexId v = open.back();
    open.pop_back();
    EdgesOfPlane(plane).for_each_neighbour(v, [&](VertexId u) {
      const PlaneWall* wall = plane.walls().find(v, u);
      if (wall != nullptr && wall->has(c) && edges.insert(wall->edge()).second) open.push_back(u);
      return true;
    });
  }
  return {edges.begin(), edges.end()};
}

Result<void> DelaunayTriangulation2::Impl::constrain_in_order(
    std::span<const std::array<DelaunayVertex, 2>> segments, Crossing crossing) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Result<ConstraintId> made = constrain_one(segments[i], crossing);
    if (made) continue;
    Error error = made.error();
    error.message = "segment " + std::to_string(i) + ": " + error.message;
    return error;
  }
  return {};
}

Result<ConstraintId> DelaunayTriangulation2::Impl::constrain_one(
    const std::array<DelaunayVertex, 2>& segment, Crossing crossing) {
  if (Result<void> fine = check_ends(segment); !fine) return fine.error();
  Result<ConstraintId> made = constrain(id(segment[0]), id(segment[1]));
  if (made || crossing == Crossing::refuse) return made;
  return constrain_dividing(id(segment[0]), id(segment[1]));
}

Result<ConstraintId> DelaunayTriangulation2::insert_constraint(DelaunayVertex u, DelaunayVertex v,
                                                               Crossing crossing) {
  return guard_internal([&]() -> Result<ConstraintId> {
    if (Result<void> fine = get().check_ends({u, v}); !fine) return fine.error();
    Result<ConstraintId> made = impl_->constrain(impl_->id(u), impl_->id(v));
    if (made || crossing == Crossing::refuse) return made;
    auto copy = std::make_unique<Impl>(*impl_);
    made = copy->constrain_dividing(copy->id(u), copy->id(v));
    if (made) impl_ = std::move(copy);
    return made;
  });
}

Result<std::vector<ConstraintId>> DelaunayTriangulation2::insert_constraints(
    std::span<const std::array<DelaunayVertex, 2>> segments, Crossing crossing) {
  return guard_internal([&]() -> Result<std::vector<ConstraintId>> {
    std::vector<ConstraintId> result;
    if (segments.empty()) return result;
    auto copy = std::make_unique<Impl>(get());
    if (!copy->constrain_in_any_order(segments)) {
      copy = std::make_unique<Impl>(get());
      if (Result<void> made = copy->constrain_in_order(segments, crossing); !made) {
        return made.error();
      }
    }
    for (std::size_t i = 0; i < segments.size(); ++i) result.emplace_back(get().ends.size() + i);
    impl_ = std::move(copy);
    return result;
  });
}

Result<void> DelaunayTriangulation2::remove_constraint(ConstraintId c) {
  return guard_internal([&]() -> Result<void> {
    if (!is_live(c)) return no_constraint(c);
    for (const std::array<VertexId, 2>& edge : impl_->edges_of(c)) {
      impl_->plane.take_from_edge(edge[0], edge[1], c);
    }
    impl_->ends[c] = {};
    --impl_->constraint_count;
    return {};
  });
}

bool DelaunayTriangulation2::is_live(ConstraintId c) const { return get().is_live(c); }
std::size_t DelaunayTriangulation2::constraint_count() const { return get().constraint_count; }

std::vector<ConstraintId> DelaunayTriangulation2::constraints() const {
  const Impl& impl = get();
  std::vector<ConstraintId> result;
  for (const ConstraintId c : impl.ends.ids()) {
    if (impl.is_live(c)) result.push_back(c);
  }
  return result;
}

std::vector<ConstraintId> DelaunayTriangulation2::constraints(DelaunayVertex u,
                                                              DelaunayVertex v) const {
  const Impl& impl = get();
  const PlaneWall* wall = impl.plane.walls().find(impl.id(u), impl.id(v));
  if (wall == nullptr) return {};
  std::vector<ConstraintId> result = wall->constraints();
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::array<DelaunayVertex, 2> DelaunayTriangulation2::ends(ConstraintId c) const {
  const Impl& impl = get();
  if (!impl.is_live(c)) throw std::out_of_range("no such constraint");
  return {impl.handle(impl.ends[c][0]), impl.handle(impl.ends[c][1])};
}

std::vector<std::array<DelaunayVertex, 2>> DelaunayTriangulation2::edges(ConstraintId c) const {
  const Impl& impl = get();
  if (!impl.is_live(c)) throw std::out_of_range("no such constraint");
  std::vector<std::array<DelaunayVertex, 2>> result;
  for (const std::array<VertexId, 2>& edge : impl.edges_of(c)) {
    result.push_back({impl.handle(edge[0]), impl.handle(edge[1])});
  }
  return result;
}

// Which of the triangles, ghosts included, are inside: from the ghosts on.
Result<std::vector<TriangleId>> DelaunayTriangulation2::inside() const {
  return guard_internal([&]() -> Result<std::vector<TriangleId>> {
    const Impl& impl = get();
    std::vector<bool> is_odd(impl.places.size());
    for (const PlaneWall& wall : impl.plane.walls().all()) {
      if (wall.count() % 2 == 0) continue;
      for (const VertexId v : wall.edge()) is_odd[v.index()] = !is_odd[v.index()];
    }
    if (const auto end = std::find(is_odd.begin(), is_odd.end(), true); end != is_odd.end()) {
      Error error{ErrorCode::invalid_input, "a constraint ends where no other goes on", {}};
      error.where.vertex = static_cast<std::size_t>(end - is_odd.begin());
      return error;
    }
    std::vector<TriangleId> result;
    if (dimension() < 2) return result;
    const Incremental2& plane = impl.plane.triangles();
    const auto is_odd_wall = [&](HalfEdgeId h) {
      if (!plane.is_wall(h)) return false;
      const VertexId from = impl.plane.vertex(plane.origin(h));
      const VertexId to = impl.plane.vertex(plane.destination(h));
      return impl.plane.walls().find(from, to)->count() % 2 != 0;
    };
    enum class Side : std::uint8_t { unknown, outside, inside };
    std::vector<Side> side(plane.triangle_count(), Side::unknown);
    std::vector<TriangleId> open{Incremental2::triangle(plane.out(Incremental2::kGhost))};
    side[open[0].index()] = Side::outside;
    while (!open.empty()) {
      const TriangleId t = open.back();
      open.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdgeId h = Incremental2::half_edge(t, i);
        Side& beyond = side[Incremental2::triangle(plane.opposite(h)).index()];
        if (beyond != Side::unknown) continue;
        beyond = side[t.index()];
        if (is_odd_wall(h)) beyond = beyond == Side::inside ? Side::outside : Side::inside;
        open.push_back(Incremental2::triangle(plane.opposite(h)));
      }
    }
    for (const TriangleId t : triangles()) {
      if (side[t.index()] == Side::inside) result.push_back(t);
    }
    return result;
  });
}

}  // namespace tetloft
