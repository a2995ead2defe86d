// Delaunay triangulations of points in space that change.
#include <tetloft/delaunay_triangulation3.hpp>

#include "c/changing.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_LOCATION_VERTEX == static_cast<int>(LocationKind::vertex) &&
              TETLOFT_LOCATION_EDGE == static_cast<int>(LocationKind::edge) &&
              TETLOFT_LOCATION_FACET == static_cast<int>(LocationKind::facet) &&
              TETLOFT_LOCATION_TET == static_cast<int>(LocationKind::tet) &&
              TETLOFT_LOCATION_OUTSIDE == static_cast<int>(LocationKind::outside));

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation3;

tetloft_status tetloft_delaunay_create(const double* xyz, size_t point_count,
                                       const tetloft_execution* execution,
                                       tetloft_delaunay** delaunay) {
  return ChangingSpace::create(xyz, point_count, execution, delaunay);
}

tetloft_status tetloft_delaunay_copy(const tetloft_delaunay* delaunay, tetloft_delaunay** copy) {
  return ChangingSpace::copy(delaunay, copy);
}

tetloft_status tetloft_delaunay_free(tetloft_delaunay* delaunay) { return free_handle(delaunay); }

tetloft_status tetloft_delaunay_insert(tetloft_delaunay* delaunay, double x, double y, double z,
                                       uint64_t near, uint64_t* vertex, int* is_new) {
  return ChangingSpace::insert(delaunay, {x, y, z}, near, vertex, is_new);
}

tetloft_status tetloft_delaunay_insert_all(tetloft_delaunay* delaunay, const double* xyz,
                                           size_t point_count, const tetloft_execution* execution,
                                           uint64_t* vertices) {
  return ChangingSpace::insert_all(delaunay, xyz, point_count, execution, vertices);
}

tetloft_status tetloft_delaunay_remove(tetloft_delaunay* delaunay, uint64_t vertex) {
  return ChangingSpace::remove(delaunay, vertex);
}

tetloft_status tetloft_delaunay_move(tetloft_delaunay* delaunay, uint64_t vertex, double x,
                                     double y, double z) {
  return ChangingSpace::move(delaunay, vertex, {x, y, z});
}

tetloft_status tetloft_delaunay_clear(tetloft_delaunay* delaunay) {
  return ChangingSpace::clear_all(delaunay);
}

tetloft_status tetloft_delaunay_counts(const tetloft_delaunay* delaunay, size_t* vertices,
                                       size_t* slots, size_t* tets, int* dimension) {
  clear(vertices, slots, tets);
  clear(dimension);
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->ask([&](const DelaunayTriangulation3& t) {
      put(vertices, t.vertex_count());
      put(slots, t.vertex_slots());
      put(tets, t.tet_count());
      put(dimension, t.dimension());
    });
  });
}

tetloft_status tetloft_delaunay_is_live(const tetloft_delaunay* delaunay, uint64_t vertex,
                                        int* is_live) {
  return ChangingSpace::is_live(delaunay, vertex, is_live);
}

tetloft_status tetloft_delaunay_vertices(const tetloft_delaunay* delaunay, uint64_t* vertices,
                                         size_t capacity, size_t* count) {
  return ChangingSpace::vertices(delaunay, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_points(const tetloft_delaunay* delaunay, double* xyz,
                                       size_t capacity, size_t* count) {
  return ChangingSpace::points(delaunay, xyz, capacity, count);
}

tetloft_status tetloft_delaunay_point(const tetloft_delaunay* delaunay, uint64_t vertex,
                                      double* xyz) {
  return ChangingSpace::point(delaunay, vertex, xyz);
}

tetloft_status tetloft_delaunay_tets(const tetloft_delaunay* delaunay, uint64_t* tets,
                                     size_t capacity, size_t* count) {
  return ChangingSpace::cells(delaunay, tets, capacity, count, "tets");
}

tetloft_status tetloft_delaunay_star(const tetloft_delaunay* delaunay, uint64_t vertex,
                                     uint64_t* tets, size_t capacity, size_t* count) {
  return ChangingSpace::star(delaunay, vertex, tets, capacity, count, "tets");
}

tetloft_status tetloft_delaunay_neighbours(const tetloft_delaunay* delaunay, uint64_t vertex,
                                           uint64_t* neighbours, size_t capacity, size_t* count) {
  return ChangingSpace::neighbours(delaunay, vertex, neighbours, capacity, count);
}

tetloft_status tetloft_delaunay_locate(const tetloft_delaunay* delaunay, const double* xyz,
                                       size_t point_count, const tetloft_execution* execution,
                                       int32_t* kinds, uint64_t* vertices) {
  return ChangingSpace::locate(delaunay, xyz, point_count, execution, kinds, vertices);
}

tetloft_status tetloft_delaunay_nearest(const tetloft_delaunay* delaunay, const double* xyz,
                                        size_t point_count, const tetloft_execution* execution,
                                        uint64_t* vertices) {
  return ChangingSpace::nearest(delaunay, xyz, point_count, execution, vertices);
}

tetloft_status tetloft_delaunay_nearest_few(const tetloft_delaunay* delaunay, double x, double y,
                                            double z, size_t most, uint64_t* vertices,
                                            size_t capacity, size_t* count) {
  return ChangingSpace::nearest_few(delaunay, {x, y, z}, most, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_within(const tetloft_delaunay* delaunay, double x, double y,
                                       double z, double radius, uint64_t* vertices, size_t capacity,
                                       size_t* count) {
  return ChangingSpace::within(delaunay, {x, y, z}, radius, vertices, capacity, count);
}

tetloft_status tetloft_delaunay_conflict_zone(const tetloft_delaunay* delaunay, double x, double y,
                                              double z, uint64_t near, uint64_t* tets,
                                              size_t tet_capacity, size_t* tet_count,
                                              uint64_t* horizon, size_t horizon_capacity,
                                              size_t* horizon_count, uint64_t* neighbours,
                                              size_t neighbour_capacity, size_t* neighbour_count) {
  clear(tet_count, horizon_count, neighbour_count);
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->ask([&](const DelaunayTriangulation3& t) {
      const tetloft::ConflictZone3 zone =
          value_of(t.conflict_zone({x, y, z}, vertex_of_number(near)));
      fill_zone(ChangingSpace::corners(t, zone.tets), {tets, tet_capacity, tet_count, "tets"},
                ChangingSpace::corners(t, zone.horizon),
                {horizon, horizon_capacity, horizon_count, "horizon"},
                vertex_numbers(zone.neighbours),
                {neighbours, neighbour_capacity, neighbour_count, "neighbours"});
    });
  });
}

tetloft_status tetloft_delaunay_serialise(const tetloft_delaunay* delaunay, tetloft_bytes** bytes) {
  return ChangingSpace::serialise(delaunay, bytes);
}

tetloft_status tetloft_delaunay_deserialise(const void* data, size_t size,
                                            tetloft_delaunay** delaunay) {
  return ChangingSpace::deserialise(data, size, delaunay);
}
