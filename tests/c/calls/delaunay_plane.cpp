// Delaunay triangulations of the plane that change: a square with a point in it and constraints
// along its sides.
#include <array>
#include <cstdint>
#include <vector>

#include "c/calls/calls.hpp"
#include "c/calls/changing.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;
using P = tetloft_delaunay_plane;

const std::vector<double> kPlaneQueries{0.25, 0.125, 1, 0, 9, 9};

std::uint32_t constraint(A& a) { return static_cast<std::uint32_t>(a.integer(1)); }

// The vertices near a point, as far as `limit` says.
template <class Query, class Limit>
tetloft_status about_plane(A& a, Query query, Limit limit) {
  auto* const delaunay = a.handle<P>();
  const double x = a.real(0.5);
  const double y = a.real(0.25);
  const auto array = a.output_array<std::uint64_t>();
  return query(delaunay, x, y, limit, array.data, array.size, a.output<std::size_t>());
}

constexpr auto kPlaneCalls = std::to_array<Call>({
    {"tetloft_delaunay_plane_create",
     [](A& a) {
       const auto xy = a.array(a.reals(kPlanePoints), 2);
       const auto* const how = execution(a);
       return tetloft_delaunay_plane_create(xy.data, xy.size, how, a.handle_output<P>());
     }},
    {"tetloft_delaunay_plane_copy",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       return tetloft_delaunay_plane_copy(delaunay, a.handle_output<P>());
     }},
    {"tetloft_delaunay_plane_free",
     [](A& a) { return tetloft_delaunay_plane_free(a.own_handle<P>()); }},
    {"tetloft_delaunay_plane_insert",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       const double x = a.real(3);
       const double y = a.real(0.5);
       const std::uint64_t near = vertex(a, 3);
       auto* const made = a.output<std::uint64_t>();
       return tetloft_delaunay_plane_insert(delaunay, x, y, near, made, a.optional_output<int>());
     }},
    {"tetloft_delaunay_plane_insert_all",
     [](A& a) {
       return for_points(a, a.changing_handle<P>(), tetloft_delaunay_plane_insert_all,
                         kPlaneQueries, 2);
     }},
    {"tetloft_delaunay_plane_remove",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       return tetloft_delaunay_plane_remove(delaunay, vertex(a, 4));
     }},
    {"tetloft_delaunay_plane_move",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       const std::uint64_t moved = vertex(a, 4);
       const double x = a.real(0.75);
       return tetloft_delaunay_plane_move(delaunay, moved, x, a.real(0.5));
     }},
    {"tetloft_delaunay_plane_clear",
     [](A& a) { return tetloft_delaunay_plane_clear(a.changing_handle<P>()); }},
    {"tetloft_delaunay_plane_insert_constraint",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       const std::uint64_t u = vertex(a, 0);
       const std::uint64_t v = vertex(a, 2);
       const auto crossing = static_cast<std::int32_t>(a.integer(TETLOFT_CROSSING_SPLIT));
       return tetloft_delaunay_plane_insert_constraint(delaunay, u, v, crossing,
                                                       a.output<std::uint32_t>());
     }},
    {"tetloft_delaunay_plane_insert_constraints",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       const std::vector<std::uint32_t> ends = a.ids({0, 2, 4, 1});
       const auto segments = a.array(std::vector<std::uint64_t>(ends.begin(), ends.end()), 2);
       const auto crossing = static_cast<std::int32_t>(a.integer(TETLOFT_CROSSING_SPLIT));
       std::vector<std::uint32_t> made(kMostPoints);
       return tetloft_delaunay_plane_insert_constraints(delaunay, segments.data, segments.size,
                                                        crossing, made.data());
     }},
    {"tetloft_delaunay_plane_remove_constraint",
     [](A& a) {
       auto* const delaunay = a.changing_handle<P>();
       return tetloft_delaunay_plane_remove_constraint(delaunay, constraint(a));
     }},
    {"tetloft_delaunay_plane_has_constraint",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint32_t of = constraint(a);
       return tetloft_delaunay_plane_has_constraint(delaunay, of, a.output<int>());
     }},
    {"tetloft_delaunay_plane_constraints",
     [](A& a) { return of_all<P, std::uint32_t>(a, tetloft_delaunay_plane_constraints, 1); }},
    {"tetloft_delaunay_plane_constraint_ends",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint32_t of = constraint(a);
       using Ends = std::array<std::uint64_t, 2>;
       auto* const ends = a.output<Ends>();
       return tetloft_delaunay_plane_constraint_ends(delaunay, of,
                                                     ends == nullptr ? nullptr : ends->data());
     }},
    {"tetloft_delaunay_plane_constraint_edges",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint32_t of = constraint(a);
       const auto edges = a.output_array<std::uint64_t>(2);
       return tetloft_delaunay_plane_constraint_edges(delaunay, of, edges.data, edges.size,
                                                      a.output<std::size_t>());
     }},
    {"tetloft_delaunay_plane_edge_constraints",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint64_t u = vertex(a, 0);
       const std::uint64_t v = vertex(a, 1);
       const auto over = a.output_array<std::uint32_t>();
       return tetloft_delaunay_plane_edge_constraints(delaunay, u, v, over.data, over.size,
                                                      a.output<std::size_t>());
     }},
    {"tetloft_delaunay_plane_inside",
     [](A& a) { return of_all<P, std::uint64_t>(a, tetloft_delaunay_plane_inside, 3); }},
    {"tetloft_delaunay_plane_counts",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       auto* const vertices = a.optional_output<std::size_t>();
       auto* const slots = a.optional_output<std::size_t>();
       auto* const triangles = a.optional_output<std::size_t>();
       auto* const constraints = a.optional_output<std::size_t>();
       return tetloft_delaunay_plane_counts(delaunay, vertices, slots, triangles, constraints,
                                            a.optional_output<int>());
     }},
    {"tetloft_delaunay_plane_is_live",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint64_t of = vertex(a, 7);
       return tetloft_delaunay_plane_is_live(delaunay, of, a.output<int>());
     }},
    {"tetloft_delaunay_plane_vertices",
     [](A& a) { return of_all<P, std::uint64_t>(a, tetloft_delaunay_plane_vertices, 1); }},
    {"tetloft_delaunay_plane_points",
     [](A& a) { return of_all<P, double>(a, tetloft_delaunay_plane_points, 2); }},
    {"tetloft_delaunay_plane_point",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const std::uint64_t of = vertex(a, 2);
       using Coordinates = std::array<double, 2>;
       auto* const xy = a.output<Coordinates>();
       return tetloft_delaunay_plane_point(delaunay, of, xy == nullptr ? nullptr : xy->data());
     }},
    {"tetloft_delaunay_plane_triangles",
     [](A& a) { return of_all<P, std::uint64_t>(a, tetloft_delaunay_plane_triangles, 3); }},
    {"tetloft_delaunay_plane_star",
     [](A& a) { return around_vertex<P>(a, tetloft_delaunay_plane_star, 3); }},
    {"tetloft_delaunay_plane_neighbours",
     [](A& a) { return around_vertex<P>(a, tetloft_delaunay_plane_neighbours, 1); }},
    {"tetloft_delaunay_plane_hull",
     [](A& a) { return of_all<P, std::uint64_t>(a, tetloft_delaunay_plane_hull, 1); }},
    {"tetloft_delaunay_plane_locate",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const auto xy = a.array(a.reals(kPlaneQueries), 2);
       const auto* const how = execution(a);
       std::vector<std::int32_t> kinds(kMostPoints);
       std::vector<std::uint64_t> vertices(3 * kMostPoints);
       return tetloft_delaunay_plane_locate(delaunay, xy.data, xy.size, how, kinds.data(),
                                            vertices.data());
     }},
    {"tetloft_delaunay_plane_nearest",
     [](A& a) {
       return for_points(a, a.handle<P>(), tetloft_delaunay_plane_nearest, kPlaneQueries, 2);
     }},
    {"tetloft_delaunay_plane_nearest_few",
     [](A& a) {
       return about_plane(a, tetloft_delaunay_plane_nearest_few,
                          static_cast<std::size_t>(a.integer(3)));
     }},
    {"tetloft_delaunay_plane_within",
     [](A& a) { return about_plane(a, tetloft_delaunay_plane_within, a.real(0.75)); }},
    {"tetloft_delaunay_plane_conflict_zone",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       const double x = a.real(0.5);
       const double y = a.real(0.25);
       const std::uint64_t near = vertex(a, 3);
       return zone(a, 3, [&](auto... parts) {
         return tetloft_delaunay_plane_conflict_zone(delaunay, x, y, near, parts...);
       });
     }},
    {"tetloft_delaunay_plane_serialise",
     [](A& a) {
       auto* const delaunay = a.handle<P>();
       return tetloft_delaunay_plane_serialise(delaunay, a.handle_output<tetloft_bytes>());
     }},
    {"tetloft_delaunay_plane_deserialise",
     [](A& a) {
       const auto data = a.array(serialised<P>(tetloft_delaunay_plane_serialise));
       return tetloft_delaunay_plane_deserialise(data.data, data.size, a.handle_output<P>());
     }},
});

}  // namespace

std::span<const Call> calls_of_planes() { return kPlaneCalls; }

}  // namespace tetloft::c_test
