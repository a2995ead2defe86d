// What is behind a DelaunayTriangulation3: its tets, and the handles of its vertices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>

#include "core/finite_points.hpp"
#include "core/pages.hpp"
#include "core/provide_room.hpp"
#include "core/vertex_places.hpp"
#include "delaunay3/canonical_order.hpp"
#include "triangulation3/live_tets.hpp"

namespace tetloft::internal::triangulation3 {

inline constexpr std::size_t kMostVertices = std::size_t{1} << 30;

/// The vertex in a place, as LiveTets numbers it.
[[nodiscard]] inline VertexId id_of_place(std::size_t place) {
  return VertexId(place + LiveTets::kAuxiliaries);
}

/// Of many at once, fewer than 2^30; the error names the first one that is not finite.
[[nodiscard]] inline Result<void> check_points(std::span<const Point3> points) {
  if (points.size() >= kMostVertices) {
    return Error{ErrorCode::invalid_input, "2^30 points or more", {}};
  }
  return check_all_finite(points);
}

}  // namespace tetloft::internal::triangulation3

class tetloft::DelaunayTriangulation3::Impl {
  using LiveTets = internal::triangulation3::LiveTets;
  static VertexId id_of_place(std::size_t place) {
    return internal::triangulation3::id_of_place(place);
  }
  static std::size_t place_of(VertexId v) { return v.index() - LiveTets::kAuxiliaries; }

 public:
  LiveTets tets;
  internal::VertexPlaces places;

  [[nodiscard]] bool is_live(DelaunayVertex v) const {
    return places.is_latest(v) && tets.is_live(id_of_place(v.index));
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
  [[nodiscard]] DelaunayVertex handle(VertexId v) const { return places.handle(place_of(v)); }
  [[nodiscard]] std::vector<DelaunayVertex> handles(std::span<const VertexId> vertices) const {
    std::vector<DelaunayVertex> result;
    for (const VertexId v : vertices) result.push_back(handle(v));
    return result;
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
    const VertexId v = id_of_place(places.next(internal::triangulation3::kMostVertices));
    tets.provide(v, p);
    return v;
  }
  Insertion insert(const Point3& p, VertexId near) {
    const VertexId v = provide(p);
    const VertexId found = tets.insert(v, near);
    if (found == v) places.take();
    return {handle(found), found == v};
  }
  /// Points one after the other, along a curve: each search starts at the last one.
  [[nodiscard]] std::vector<DelaunayVertex> insert_all(std::span<const Point3> points,
                                                       const Execution& execution);
  void remove(VertexId v) {
    internal::provide_room(places.free, 1);
    tets.remove(v);
    places.release(place_of(v));
  }
  /// The first points there are; equal ones share a vertex. Returns that of each.
  std::vector<VertexId> take_all(std::span<const Point3> points, const Execution& execution) {
    places.generation.resize(points.size());
    provide_all(points);
    std::vector<VertexId> distinct;
    distinct.reserve(points.size());
    std::vector<VertexId> vertex_of(points.size());
    std::vector<std::uint32_t> order =
        internal::delaunay3_detail::canonical_order(points, execution.threads);
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (k == 0 || points[order[k]] != points[order[k - 1]]) {
        distinct.push_back(id_of_place(order[k]));
      } else {
        places.give_back(order[k]);
      }
      vertex_of[order[k]] = distinct.back();
    }
    internal::core::release(order);
    std::sort(places.free.begin(), places.free.end(), std::greater<>());
    std::sort(distinct.begin(), distinct.end());
    tets.build(distinct, execution);
    return vertex_of;
  }
  /// The first points there are, by place, of which these are vertices. False where two are equal.
  [[nodiscard]] bool take_vertices(std::span<const Point3> points, std::vector<VertexId> vertices) {
    provide_all(points);
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
  void provide_all(std::span<const Point3> points) {
    tets.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) tets.provide(id_of_place(i), points[i]);
  }
  /// Places that were provided and are of no vertex, from the last one on to be taken again.
  void give_back(std::span<const VertexId> unused) {
    for (std::size_t k = unused.size(); k-- > 0;) places.give_back(place_of(unused[k]));
  }
};
