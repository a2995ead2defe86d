// What is behind a DelaunayTriangulation3: its tets, and the handles of its vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>

#include "delaunay3/canonical_order.hpp"
#include "triangulation3/live_tets.hpp"

namespace tetloft::internal::triangulation3 {

inline constexpr std::size_t kMostVertices = std::size_t{1} << 30;

/// The vertex in a place, as LiveTets numbers it.
[[nodiscard]] inline VertexId id_of_place(std::size_t place) {
  return VertexId(place + LiveTets::kAuxiliaries);
}

[[nodiscard]] inline Result<void> check_point(const Point3& p) {
  if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) return {};
  Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
  error.where.point = p;
  return error;
}

/// Of many at once, 2^30 at most; the error names the first one that is not finite.
[[nodiscard]] inline Result<void> check_points(std::span<const Point3> points) {
  if (points.size() >= kMostVertices) {
    return Error{ErrorCode::invalid_input, "2^30 points or more", {}};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (Result<void> fine = check_point(points[i]); !fine) {
      Error error = fine.error();
      error.where.vertex = i;
      return error;
    }
  }
  return {};
}

}  // namespace tetloft::internal::triangulation3

class tetloft::DelaunayTriangulation3::Impl {
  using LiveTets = internal::triangulation3::LiveTets;
  static VertexId id_of_place(std::size_t place) {
    return internal::triangulation3::id_of_place(place);
  }

 public:
  LiveTets tets;
  std::vector<std::uint32_t> generation;  // by place
  std::vector<std::uint32_t> free;        // places, the next to be taken last

  [[nodiscard]] bool is_live(DelaunayVertex v) const {
    return v.index < generation.size() && generation[v.index] == v.generation &&
           tets.is_live(id_of_place(v.index));
  }
  /// The id of a live vertex; throws std::out_of_range otherwise.
  [[nodiscard]] VertexId id(DelaunayVertex v) const {
    if (!is_live(v)) throw std::out_of_range("no such vertex");
    return id_of_place(v.index);
  }
  /// Where a search is to start; invalid where v is none.
  [[nodiscard]] VertexId hint(DelaunayVertex v) const {
    return is_live(v) ? id_of_place(v.index) : VertexId();
  }
  [[nodiscard]] DelaunayVertex handle(VertexId v) const {
    const std::size_t place = v.index() - LiveTets::kAuxiliaries;
    return {static_cast<std::uint32_t>(place), generation[place]};
  }
  /// Throws std::out_of_range where t is no tet of the triangulation.
  [[nodiscard]] const TetVertices& tet(TetId t) const {
    if (tets.dimension() < 3 || !tets.is_finite(t)) throw std::out_of_range("no such tet");
    return tets.tets().tet(t);
  }

  /// Where p lies; requires points.
  [[nodiscard]] Location3 location(const Point3& p, VertexId near) const;

  /// A place for a vertex at p, provided but not taken.
  [[nodiscard]] VertexId provide(const Point3& p) {
    if (free.empty()) {
      if (generation.size() >= internal::triangulation3::kMostVertices)
        throw std::length_error("2^30 vertices");
      generation.push_back(0);
      try {
        free.push_back(static_cast<std::uint32_t>(generation.size() - 1));
      } catch (...) {
        generation.pop_back();
        throw;
      }
    }
    const VertexId v = id_of_place(free.back());
    tets.provide(v, p);
    return v;
  }
  Insertion insert(const Point3& p, VertexId near) {
    const VertexId v = provide(p);
    const VertexId found = tets.insert(v, near);
    if (found == v) free.pop_back();
    return {handle(found), found == v};
  }
  /// Points one after the other, along a curve: each search starts at the last one.
  [[nodiscard]] std::vector<DelaunayVertex> insert_all(std::span<const Point3> points,
                                                       const Execution& execution);
  void remove(VertexId v) {
    if (free.size() == free.capacity()) free.reserve(2 * free.size() + 1);
    tets.remove(v);
    release(v);
  }
  /// The first points there are; equal ones share a vertex. Returns that of each.
  std::vector<VertexId> take_all(std::span<const Point3> points, const Execution& execution) {
    generation.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) tets.provide(id_of_place(i), points[i]);
    std::vector<VertexId> distinct;
    std::vector<VertexId> vertex_of(points.size());
    const std::vector<std::uint32_t> order =
        internal::delaunay3_detail::canonical_order(points, execution.threads);
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (k == 0 || points[order[k]] != points[order[k - 1]]) {
        distinct.push_back(id_of_place(order[k]));
      } else {
        free.push_back(order[k]);
      }
      vertex_of[order[k]] = distinct.back();
    }
    std::sort(free.begin(), free.end(), std::greater<>());
    std::sort(distinct.begin(), distinct.end());
    tets.build(distinct, execution);
    return vertex_of;
  }
  /// The first points there are, by place, of which these are vertices. False where two are equal.
  [[nodiscard]] bool take_vertices(std::span<const Point3> points, std::vector<VertexId> vertices) {
    for (std::size_t i = 0; i < points.size(); ++i) tets.provide(id_of_place(i), points[i]);
    const auto before = [&](VertexId u, VertexId v) {
      return canonical_less(tets.point(u), tets.point(v));
    };
    std::sort(vertices.begin(), vertices.end(), before);
    const auto equal = std::adjacent_find(vertices.begin(), vertices.end(),
                                          [&](VertexId u, VertexId v) { return !before(u, v); });
    if (equal != vertices.end()) return false;
    std::sort(vertices.begin(), vertices.end());
    tets.build(vertices, {.threads = 1});
    return true;
  }
  /// Places that were provided and are of no vertex, from the last one on to be taken again.
  void give_back(std::span<const VertexId> places) {
    for (std::size_t k = places.size(); k-- > 0;) {
      free.push_back(static_cast<std::uint32_t>(places[k].index() - LiveTets::kAuxiliaries));
    }
  }
  /// v is in no tet any more.
  void release(VertexId v) {
    const std::size_t place = v.index() - LiveTets::kAuxiliaries;
    ++generation[place];
    free.push_back(static_cast<std::uint32_t>(place));
  }
};
