// The API boundary of the 3D Delaunay triangulation: input checks, canonical ranks and
// duplicates, then order, insertion and canonical output.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/predicates.hpp>

#include "core/enums.hpp"
#include "core/finite_points.hpp"
#include "core/guard.hpp"
#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "delaunay3/batch.hpp"
#include "delaunay3/canonical_mesh.hpp"
#include "delaunay3/canonical_order.hpp"
#include "delaunay3/incremental.hpp"
#include "delaunay3/slab_overlay.hpp"

namespace tetloft {

using namespace internal;

namespace {

// 32-bit ids hold many more; the limit of 2^30 tets comes first for all but degenerate input.
constexpr std::size_t kMaxPoints = std::size_t{1} << 30;

Result<void> check_points(std::span<const Point3> points) {
  if (points.size() >= kMaxPoints) {
    return Error{ErrorCode::invalid_input, "more than 2^30 points", {}};
  }
  return check_all_finite(points);
}

IdVector<VertexId, VertexId> own_representatives(std::size_t n) {
  IdVector<VertexId, VertexId> all;
  all.reserve(n);
  for (std::size_t i = 0; i < n; ++i) all.push_back(VertexId(i));
  return all;
}

// The distinct points in canonical order.
struct RankedPoints {
  std::vector<Point3> point;       // by rank
  std::vector<VertexId> input_of;  // input_of[rank]: lowest input index of the point
  std::size_t input_count = 0;     // with duplicates
};

// Also tells the number of duplicates, and where there are any, who represents whom.
RankedPoints rank_points(std::span<const Point3> points, unsigned threads, Delaunay3& out) {
  const std::vector<std::uint32_t> order = delaunay3_detail::canonical_order(points, threads);
  RankedPoints ranked;
  ranked.input_count = points.size();
  ranked.point = delaunay3_detail::picked<Point3>(points, order, threads);
  ranked.input_of.reserve(points.size());
  // In place, from the first duplicate on.
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t rank = ranked.input_of.size();
    if (rank != 0 && ranked.point[rank - 1] == ranked.point[i]) {
      if (out.duplicates++ == 0) out.representative = own_representatives(points.size());
      out.representative[VertexId(order[i])] = ranked.input_of.back();
      continue;
    }
    if (rank != i) ranked.point[rank] = ranked.point[i];
    ranked.input_of.emplace_back(order[i]);
  }
  ranked.point.resize(ranked.input_of.size());
  return ranked;
}

// Of points on two planes of constant z in canonical order: how many lie on the lower one; 0
// for all other points.
std::size_t count_below(std::span<const Point3> points) {
  if (points.empty() || points.front().z == points.back().z) return 0;
  const auto above = std::partition_point(points.begin(), points.end(),
                                          [&](const Point3& p) { return p.z == points.front().z; });
  return above->z == points.back().z ? static_cast<std::size_t>(above - points.begin()) : 0;
}

Result<Triangulation2> triangulate_plane(std::span<const Point3> points,
                                         const Execution& execution) {
  std::vector<Point2> flat;
  flat.reserve(points.size());
  for (const Point3& p : points) flat.push_back({p.x, p.y});
  return delaunay2(flat, execution);
}

// The most tets an engine may make.
std::size_t bound_on_tets(std::size_t most_tets) {
  using delaunay3_detail::kMostTetSlots;
  return most_tets == 0 ? kMostTetSlots : std::min(kMostTetSlots, most_tets);
}

Error too_many_tets(std::size_t most_tets) {
  if (bound_on_tets(most_tets) == most_tets) {
    return {ErrorCode::work_limit,
            "the triangulation takes more than " + std::to_string(most_tets) +
                " tets, the work limit; raise the limit if it is to be made",
            {}};
  }
  return {ErrorCode::invalid_input, "the triangulation takes 2^30 tets or more", {}};
}

// By the overlay of the two planes' Voronoi diagrams. Nothing where the points are not on two
// planes, or one of them has no triangles.
Result<bool> overlay_planes(const RankedPoints& ranked, const Delaunay3Options& options,
                            Delaunay3& out) {
  const std::span<const Point3> points(ranked.point);
  const std::size_t below = count_below(points);
  if (below < 3 || points.size() - below < 3) return false;
  Result<Triangulation2> lower = Triangulation2{};
  Result<Triangulation2> upper = Triangulation2{};
  WatchedWork work(options.execution, 4);
  const Execution planes = untold(options.execution);
  parallel_for(2, planes.threads, [&](std::size_t plane) {
    if (plane == 0) lower = triangulate_plane(points.first(below), planes);
    if (plane == 1) upper = triangulate_plane(points.subspan(below), planes);
    work.step_done();
  });
  if (!lower) return lower.error();
  if (!upper) return upper.error();
  if (lower->triangles.empty() || upper->triangles.empty()) return false;
  std::optional<TetMesh> mesh = delaunay3_detail::slab_overlay(
      *lower, *upper, {.input_of = ranked.input_of, .input_count = ranked.input_count}, work,
      bound_on_tets(options.most_tets));
  if (!mesh) return too_many_tets(options.most_tets);
  out.mesh = *std::move(mesh);
  out.dimension = 3;
  out.engine = DelaunayEngine::slab;
  work.step_done();
  return true;
}

Result<bool> insert_points(RankedPoints& ranked, const Delaunay3Options& options, Delaunay3& out) {
  out.engine = DelaunayEngine::incremental;
  const unsigned threads = options.execution.threads;
  // order.places[v]: rank of the vertex inserted as v-th.
  const delaunay3_detail::BatchOrder order = delaunay3_detail::batch_order(ranked.point, threads);
  out.dimension = order.dimension;
  if (order.dimension < 3) {
    out.mesh = TetMesh::from_adjacency(ranked.input_count, {}, {});
    return true;
  }

  using delaunay3_detail::Delaunay3Builder;
  WatchedWork work(options.execution, order.places.size() / Delaunay3Builder::kPointsOfStep + 1);
  work.go_on();
  // How many tets there are at a time depends on the order: a limit is that of one thread's.
  Delaunay3Builder builder(ranked.point, order.places,
                           {.threads = options.most_tets == 0 ? threads : 1});
  core::release(ranked.point);
  if (!builder.insert_all(work, bound_on_tets(options.most_tets))) {
    return too_many_tets(options.most_tets);
  }
  out.mesh = delaunay3_detail::canonical_mesh(
      builder.slots(),
      {.rank_of = order.places, .input_of = ranked.input_of, .input_count = ranked.input_count},
      threads);
  work.step_done();
  return true;
}

Result<Delaunay3> triangulate(std::span<const Point3> points, const Delaunay3Options& options) {
  const DelaunayEngine engine = options.engine;
  if (!is_enumerator(engine, DelaunayEngine::slab)) {
    return Error{ErrorCode::usage, "there is no such Delaunay engine", {}};
  }
  if (Result<void> checked = fp_self_check(); !checked) return checked.error();
  if (Result<void> checked = check_points(points); !checked) return checked.error();
  Delaunay3 out;
  RankedPoints ranked = rank_points(points, options.execution.threads, out);
  Result<bool> done = false;
  if (engine != DelaunayEngine::incremental) done = overlay_planes(ranked, options, out);
  if (done && !*done) {
    if (engine == DelaunayEngine::slab) {
      return Error{ErrorCode::invalid_input,
                   "the slab engine takes points on two planes of constant z, three at least on "
                   "each and not in a row",
                   {}};
    }
    done = insert_points(ranked, options, out);
  }
  if (!done) return done.error();
  // Last, when there is memory for them again.
  if (out.duplicates == 0) out.representative = own_representatives(points.size());
  return out;
}

Result<void> check_flat_points(const Triangulation2& plane) {
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    const Point2& p = plane.points[PlaneVertexId(i)];
    if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
    Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
    error.where.vertex = i;
    return error;
  }
  return {};
}

// Ids in range, triangles in canonical order, and neighbours mutual: what the overlay walks along.
Result<void> check_triangles(const Triangulation2& plane) {
  const auto refused = [](std::size_t t, const char* why) {
    return Error{ErrorCode::invalid_input, "triangle " + std::to_string(t) + why, {}};
  };
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    const PlaneTriangleVertices& v = plane.triangles[TriangleId(t)];
    for (std::size_t i = 0; i < 3; ++i) {
      if (v[i].index() >= plane.points.size()) return refused(t, " has a corner that is no point");
    }
    if (v[0] > v[1] || v[0] > v[2]) return refused(t, " does not start at its lowest vertex");
    if (t > 0 && v < plane.triangles[TriangleId(t - 1)]) return refused(t, " is out of order");
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId n = plane.neighbours[TriangleId(t)][i];
      if (!n.valid()) continue;
      if (n.index() >= plane.triangles.size()) {
        return refused(t, " has a neighbour that is no triangle");
      }
      bool mutual = false;
      for (std::size_t j = 0; j < 3; ++j) {
        const PlaneTriangleVertices& w = plane.triangles[n];
        mutual = mutual || (plane.neighbours[n][j] == TriangleId(t) &&
                            w[(j + 1) % 3] == v[(i + 2) % 3] && w[(j + 2) % 3] == v[(i + 1) % 3]);
      }
      if (!mutual) return refused(t, " is not its neighbour's neighbour across their edge");
    }
  }
  return {};
}

Result<void> check_planes(const Triangulation2& lower, const Triangulation2& upper) {
  constexpr std::size_t kMostVertices = std::size_t{1} << 29;
  if (lower.points.size() + upper.points.size() >= kMostVertices) {
    return Error{ErrorCode::invalid_input, "2^29 vertices or more", {}};
  }
  for (const Triangulation2* plane : {&lower, &upper}) {
    if (plane->triangles.empty()) {
      return Error{ErrorCode::invalid_input, "a plane without triangles", {}};
    }
    if (plane->neighbours.size() != plane->triangles.size()) {
      return Error{ErrorCode::invalid_input, "a plane without all neighbours of triangles", {}};
    }
    if (Result<void> fine = check_triangles(*plane); !fine) return fine;
    if (Result<void> fine = check_flat_points(*plane); !fine) return fine;
    for (std::size_t i = 1; i < plane->points.size(); ++i) {
      const PlaneVertexId v(i);
      if (canonical_less(plane->points[PlaneVertexId(i - 1)], plane->points[v])) continue;
      Error error{ErrorCode::invalid_input, "points are not in canonical order", {}};
      error.where.vertex = i;
      return error;
    }
  }
  return {};
}

Result<TetMesh> triangulate_slab(const Triangulation2& lower, const Triangulation2& upper,
                                 std::size_t most_tets, const Execution& execution) {
  if (Result<void> checked = fp_self_check(); !checked) return checked.error();
  if (Result<void> checked = check_planes(lower, upper); !checked) return checked.error();
  WatchedWork work(execution, 1);
  std::optional<TetMesh> mesh = delaunay3_detail::slab_overlay(
      lower, upper, {.input_of = {}, .input_count = lower.points.size() + upper.points.size()},
      work, bound_on_tets(most_tets));
  if (!mesh) return too_many_tets(most_tets);
  return *std::move(mesh);
}

}  // namespace

const char* name_of(DelaunayEngine engine) {
  switch (engine) {
    case DelaunayEngine::automatic: return "auto";
    case DelaunayEngine::incremental: return "incremental";
    case DelaunayEngine::slab: return "slab";
  }
  return "unknown";
}

Result<Delaunay3> delaunay3(std::span<const Point3> points, const Delaunay3Options& given_options) {
  return guard_threads(
      given_options, [&](const Delaunay3Options& options) { return triangulate(points, options); });
}

Result<TetMesh> slab_delaunay3(const Triangulation2& lower, const Triangulation2& upper,
                               std::size_t most_tets, const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) {
    return triangulate_slab(lower, upper, most_tets, own);
  });
}

}  // namespace tetloft
