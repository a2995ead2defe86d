// The Voronoi diagram of one section, read off its Delaunay triangulation: half-edges with
// a ghost triangle behind every hull edge, and the circumcentre of every triangle with a
// proven bound of its error.
//
// Half-edge h = 4 t + i, i < 3, is the edge of triangle t opposite its vertex i, counter-clockwise
// around t. It is dual to the Voronoi edge that runs, seen in the direction of h, from right
// to left: from the circumcentre of the triangle across to that of t. Triangles from
// finite_count() on are ghosts with the ghost as vertex 0, hence their half-edge 0 is the hull
// edge: their "circumcentre" is the end at infinity of the ray dual to it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay3_detail {

/// A half-edge of a planar triangulation.
using HalfEdgeId = Id<struct PlaneHalfEdgeTag>;

/// Points further out have no trusted circumcentres: computing with these could overflow.
inline constexpr double kFarthestTrusted = 0x1p+400;

/// A circumcentre as computed. The true one lies within `radius` along each axis; infinite or
/// NaN where no bound is proven.
struct Circumcentre {
  double x;
  double y;
  double radius;
  /// With what is lost by computing along an axis with it and with points of the planes: see
  /// Bisector.
  double slack;
};

/// The largest magnitude of a coordinate.
[[nodiscard]] double reach_of(const IdVector<PlaneVertexId, Point2>& points);

class PlaneDiagram {
 public:
  static constexpr PlaneVertexId kGhostVertex{0xFFFFFFFEU};

  /// Triangles get numbers of their own. `reach` is that of all points that circumcentres are
  /// compared with; no radius is finite where it is beyond kFarthestTrusted. Requires a triangle at
  /// least, vertices in canonical order, and fewer than 2^29 of them. Keeps a reference to the
  /// points.
  PlaneDiagram(const Triangulation2& triangulation, double reach);

  [[nodiscard]] std::size_t vertex_count() const { return points_->size(); }
  [[nodiscard]] std::size_t finite_count() const { return finite_count_; }
  /// Ghost triangles included.
  [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }
  /// Half-edges and the unused ids between them.
  [[nodiscard]] std::size_t half_edge_slots() const { return 4 * triangles_.size(); }
  /// Its number in the triangulation, and back; of finite ones only.
  [[nodiscard]] TriangleId input_of(TriangleId t) const { return input_of_[t]; }
  [[nodiscard]] TriangleId place_of(TriangleId input) const { return place_of_[input]; }
  [[nodiscard]] bool is_ghost(TriangleId t) const { return t.index() >= finite_count_; }
  [[nodiscard]] const Point2& point(PlaneVertexId v) const { return (*points_)[v]; }
  /// Of a ghost: nothing, with an infinite radius.
  [[nodiscard]] const Circumcentre& centre(TriangleId t) const { return triangles_[t].centre; }

  [[nodiscard]] static TriangleId triangle(HalfEdgeId h) { return TriangleId(h.value() / 4); }
  [[nodiscard]] static HalfEdgeId half_edge(TriangleId t, std::uint32_t i) {
    return HalfEdgeId(4 * t.value() + i);
  }
  [[nodiscard]] static HalfEdgeId next(HalfEdgeId h) {
    return HalfEdgeId((h.value() & 3U) == 2 ? h.value() - 2 : h.value() + 1);
  }
  [[nodiscard]] static HalfEdgeId previous(HalfEdgeId h) {
    return HalfEdgeId((h.value() & 3U) == 0 ? h.value() + 2 : h.value() - 1);
  }
  [[nodiscard]] HalfEdgeId opposite(HalfEdgeId h) const { return at(h).opposite[h.value() & 3U]; }
  [[nodiscard]] PlaneVertexId apex(HalfEdgeId h) const { return at(h).apex[h.value() & 3U]; }
  [[nodiscard]] PlaneVertexId origin(HalfEdgeId h) const { return apex(next(h)); }
  [[nodiscard]] PlaneVertexId destination(HalfEdgeId h) const { return apex(previous(h)); }
  [[nodiscard]] TriangleId left(HalfEdgeId h) const { return triangle(h); }
  [[nodiscard]] TriangleId right(HalfEdgeId h) const { return triangle(opposite(h)); }
  /// The next half-edge with the same origin, counter-clockwise and clockwise.
  [[nodiscard]] HalfEdgeId turn_left(HalfEdgeId h) const { return opposite(previous(h)); }
  [[nodiscard]] HalfEdgeId turn_right(HalfEdgeId h) const { return next(opposite(h)); }

 private:
  // Fills a cache line: walks touch one for each triangle.
  struct alignas(64) Triangle {
    std::array<PlaneVertexId, 3> apex;   // the vertex that half-edge i is opposite to
    std::array<HalfEdgeId, 3> opposite;  // the other side of half-edge i
    Circumcentre centre;
  };

  [[nodiscard]] const Triangle& at(HalfEdgeId h) const { return triangles_[triangle(h)]; }
  void set_opposite(HalfEdgeId h, HalfEdgeId other) {
    triangles_[triangle(h)].opposite[h.value() & 3U] = other;
  }
  void glue(HalfEdgeId a, HalfEdgeId b) {
    set_opposite(a, b);
    set_opposite(b, a);
  }

  const IdVector<PlaneVertexId, Point2>* points_;
  std::size_t finite_count_;
  IdVector<TriangleId, TriangleId> input_of_;
  IdVector<TriangleId, TriangleId> place_of_;
  IdVector<TriangleId, Triangle> triangles_;
};

}  // namespace tetloft::internal::delaunay3_detail
