// Delaunay triangulations of points in the plane that change.
#include <tetloft/delaunay_triangulation2.hpp>

#include "c/changing.hpp"

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation2;

tetloft_status tetloft_delaunay_plane_create(const double* xy, size_t point_count,
                                             const tetloft_execution* execution,
                                             tetloft_delaunay_plane** delaunay) {
  return ChangingPlane::create(xy, point_count, execution, delaunay);
}

tetloft_status tetloft_delaunay_plane_copy(const tetloft_delaunay_plane* delaunay,
                                           tetloft_delaunay_plane** copy) {
  return ChangingPlane::copy(delaunay, copy);
}

tetloft_status tetloft_delaunay_plane_free(tetloft_delaunay_plane* delaunay) {
  return free_handle(delaunay);
}

tetloft_status tetloft_delaunay_plane_insert(tetloft_delaunay_plane* delaunay, double x, double y,
                                             uint64_t near, uint64_t* vertex, int* is_new) {
  return ChangingPlane::insert(delaunay, {x, y}, near, vertex, is_new);
}

tetloft_status tetloft_delaunay_plane_insert_all(tetloft_delaunay_plane* delaunay, const double* xy,
                                                 size_t point_count,
                                                 const tetloft_execution* execution,
                                                 uint64_t* vertices) {
  return ChangingPlane::insert_all(delaunay, xy, point_count, execution, vertices);
}

tetloft_status tetloft_delaunay_plane_remove(tetloft_delaunay_plane* delaunay, uint64_t vertex) {
  return ChangingPlane::remove(delaunay, vertex);
}

tetloft_status tetloft_delaunay_plane_move(tetloft_delaunay_plane* delaunay, uint64_t vertex,
                                           double x, double y) {
  return ChangingPlane::move(delaunay, vertex, {x, y});
}

tetloft_status tetloft_delaunay_plane_clear(tetloft_delaunay_plane* delaunay) {
  return ChangingPlane::clear_all(delaunay);
}

tetloft_status tetloft_delaunay_plane_counts(const tetloft_delaunay_plane* delaunay,
                                             size_t* vertices, size_t* slots, size_t* triangles,
                                             size_t* constraints, int* dimension) {
  clear(vertices, slots, triangles, constraints);
  clear(dimension);
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->ask([&](const DelaunayTriangulation2& t) {
      put(vertices, t.vertex_count());
      put(slots, t.vertex_slots());
      put(triangles, t.triangle_count());
      put(constraints, t.constraint_count());
      put(dimension, t.dimension());
    });
  });
}

tetloft_status tetloft_delaunay_plane_is_live(const tetloft_delaunay_plane* delaunay,
                                              uint64_t vertex, int* is_live) {
  return ChangingPlane::is_live(delaunay, vertex, is_live);
}

tetloft_status tetloft_delaunay_plane_vertices(const tetloft_delaunay_plane* delaunay,
                                               uint64_t* vertices, size_t capacity, size_t* count) {
  return ChangingPlane::vertices(delaunay, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_plane_points(const tetloft_delaunay_plane* delaunay, double* xy,
                                             size_t capacity, size_t* count) {
  return ChangingPlane::points(delaunay, xy, capacity, count);
}

tetloft_status tetloft_delaunay_plane_point(const tetloft_delaunay_plane* delaunay, uint64_t vertex,
                                            double* xy) {
  return ChangingPlane::point(delaunay, vertex, xy);
}

tetloft_status tetloft_delaunay_plane_triangles(const tetloft_delaunay_plane* delaunay,
                                                uint64_t* triangles, size_t capacity,
                                                size_t* count) {
  return ChangingPlane::cells(delaunay, triangles, capacity, count, "triangles");
}

tetloft_status tetloft_delaunay_plane_star(const tetloft_delaunay_plane* delaunay, uint64_t vertex,
                                           uint64_t* triangles, size_t capacity, size_t* count) {
  return ChangingPlane::star(delaunay, vertex, triangles, capacity, count, "triangles");
}

tetloft_status tetloft_delaunay_plane_neighbours(const tetloft_delaunay_plane* delaunay,
                                                 uint64_t vertex, uint64_t* neighbours,
                                                 size_t capacity, size_t* count) {
  return ChangingPlane::neighbours(delaunay, vertex, neighbours, capacity, count);
}

tetloft_status tetloft_delaunay_plane_hull(const tetloft_delaunay_plane* delaunay,
                                           uint64_t* vertices, size_t capacity, size_t* count) {
  return ChangingPlane::found(
      delaunay, vertices, capacity, count, "vertices",
      [](const DelaunayTriangulation2& t) { return vertex_numbers(t.hull()); });
}

tetloft_status tetloft_delaunay_plane_locate(const tetloft_delaunay_plane* delaunay,
                                             const double* xy, size_t point_count,
                                             const tetloft_execution* execution, int32_t* kinds,
                                             uint64_t* vertices) {
  return ChangingPlane::locate(delaunay, xy, point_count, execution, kinds, vertices);
}

tetloft_status tetloft_delaunay_plane_nearest(const tetloft_delaunay_plane* delaunay,
                                              const double* xy, size_t point_count,
                                              const tetloft_execution* execution,
                                              uint64_t* vertices) {
  return ChangingPlane::nearest(delaunay, xy, point_count, execution, vertices);
}

tetloft_status tetloft_delaunay_plane_nearest_few(const tetloft_delaunay_plane* delaunay, double x,
                                                  double y, size_t most, uint64_t* vertices,
                                                  size_t capacity, size_t* count) {
  return ChangingPlane::nearest_few(delaunay, {x, y}, most, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_plane_within(const tetloft_delaunay_plane* delaunay, double x,
                                             double y, double radius, uint64_t* vertices,
                                             size_t capacity, size_t* count) {
  return ChangingPlane::within(delaunay, {x, y}, radius, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_plane_conflict_zone(const tetloft_delaunay_plane* delaunay,
                                                    double x, double y, uint64_t near,
                                                    uint64_t* triangles, size_t triangle_capacity,
                                                    size_t* triangle_count, uint64_t* horizon,
                                                    size_t horizon_capacity, size_t* horizon_count,
                                                    uint64_t* neighbours, size_t neighbour_capacity,
                                                    size_t* neighbour_count) {
  clear(triangle_count, horizon_count, neighbour_count);
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->ask([&](const DelaunayTriangulation2& t) {
      const tetloft::ConflictZone2 zone = value_of(t.conflict_zone({x, y}, vertex_of_number(near)));
      fill_zone(ChangingPlane::corners(t, zone.triangles),
                {triangles, triangle_capacity, triangle_count, "triangles"},
                vertex_numbers(zone.horizon), {horizon, horizon_capacity, horizon_count, "horizon"},
                vertex_numbers(zone.neighbours),
                {neighbours, neighbour_capacity, neighbour_count, "neighbours"});
    });
  });
}

tetloft_status tetloft_delaunay_plane_serialise(const tetloft_delaunay_plane* delaunay,
                                                tetloft_bytes** bytes) {
  return ChangingPlane::serialise(delaunay, bytes);
}

tetloft_status tetloft_delaunay_plane_deserialise(const void* data, size_t size,
                                                  tetloft_delaunay_plane** delaunay) {
  return ChangingPlane::deserialise(data, size, delaunay);
}
