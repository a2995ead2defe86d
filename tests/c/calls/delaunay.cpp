// Delaunay triangulations that change: the five points of two tets, numbered as they come.
#include <array>

#include "c/calls/calls.hpp"
#include "c/calls/changing.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;
using D = tetloft_delaunay;

// The vertices near a point, as far as `limit` says.
template <class Query, class Limit>
tetloft_status about(A& a, Query query, Limit limit) {
  auto* const delaunay = a.handle<tetloft_delaunay>();
  const double x = a.real(0.5);
  const double y = a.real(0.25);
  const double z = a.real(0.25);
  const auto array = a.output_array<std::uint64_t>();
  return query(delaunay, x, y, z, limit, array.data, array.size, a.output<std::size_t>());
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_delaunay_create",
     [](A& a) {
       const auto xyz = a.array(a.reals(kTetPoints), 3);
       const auto* const how = execution(a);
       return tetloft_delaunay_create(xyz.data, xyz.size, how, a.handle_output<tetloft_delaunay>());
     }},
    {"tetloft_delaunay_copy",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       return tetloft_delaunay_copy(delaunay, a.handle_output<tetloft_delaunay>());
     }},
    {"tetloft_delaunay_free",
     [](A& a) { return tetloft_delaunay_free(a.own_handle<tetloft_delaunay>()); }},
    {"tetloft_delaunay_insert",
     [](A& a) {
       auto* const delaunay = a.changing_handle<tetloft_delaunay>();
       const double x = a.real(2);
       const double y = a.real(0.5);
       const double z = a.real(0);
       const std::uint64_t near = vertex(a, 3);
       auto* const made = a.output<std::uint64_t>();
       return tetloft_delaunay_insert(delaunay, x, y, z, near, made, a.optional_output<int>());
     }},
    {"tetloft_delaunay_insert_all",
     [](A& a) {
       return for_points(a, a.changing_handle<D>(), tetloft_delaunay_insert_all, kQueries, 3);
     }},
    {"tetloft_delaunay_remove",
     [](A& a) {
       auto* const delaunay = a.changing_handle<tetloft_delaunay>();
       return tetloft_delaunay_remove(delaunay, vertex(a, 4));
     }},
    {"tetloft_delaunay_move",
     [](A& a) {
       auto* const delaunay = a.changing_handle<tetloft_delaunay>();
       const std::uint64_t moved = vertex(a, 4);
       const double x = a.real(2);
       const double y = a.real(0.5);
       return tetloft_delaunay_move(delaunay, moved, x, y, a.real(1));
     }},
    {"tetloft_delaunay_clear",
     [](A& a) { return tetloft_delaunay_clear(a.changing_handle<tetloft_delaunay>()); }},
    {"tetloft_delaunay_counts",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       auto* const vertices = a.optional_output<std::size_t>();
       auto* const slots = a.optional_output<std::size_t>();
       auto* const tets = a.optional_output<std::size_t>();
       return tetloft_delaunay_counts(delaunay, vertices, slots, tets, a.optional_output<int>());
     }},
    {"tetloft_delaunay_is_live",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const std::uint64_t of = vertex(a, 7);
       return tetloft_delaunay_is_live(delaunay, of, a.output<int>());
     }},
    {"tetloft_delaunay_vertices",
     [](A& a) { return of_all<D, std::uint64_t>(a, tetloft_delaunay_vertices, 1); }},
    {"tetloft_delaunay_points",
     [](A& a) { return of_all<D, double>(a, tetloft_delaunay_points, 3); }},
    {"tetloft_delaunay_point",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const std::uint64_t of = vertex(a, 2);
       using Coordinates = std::array<double, 3>;
       auto* const xyz = a.output<Coordinates>();
       return tetloft_delaunay_point(delaunay, of, xyz == nullptr ? nullptr : xyz->data());
     }},
    {"tetloft_delaunay_tets",
     [](A& a) { return of_all<D, std::uint64_t>(a, tetloft_delaunay_tets, 4); }},
    {"tetloft_delaunay_star", [](A& a) { return around_vertex<D>(a, tetloft_delaunay_star, 4); }},
    {"tetloft_delaunay_neighbours",
     [](A& a) { return around_vertex<D>(a, tetloft_delaunay_neighbours, 1); }},
    {"tetloft_delaunay_locate",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const auto xyz = a.array(a.reals(kQueries), 3);
       const auto* const how = execution(a);
       std::vector<std::int32_t> kinds(kMostPoints);
       std::vector<std::uint64_t> vertices(4 * kMostPoints);
       return tetloft_delaunay_locate(delaunay, xyz.data, xyz.size, how, kinds.data(),
                                      vertices.data());
     }},
    {"tetloft_delaunay_nearest",
     [](A& a) { return for_points(a, a.handle<D>(), tetloft_delaunay_nearest, kQueries, 3); }},
    {"tetloft_delaunay_nearest_few",
     [](A& a) {
       return about(a, tetloft_delaunay_nearest_few, static_cast<std::size_t>(a.integer(3)));
     }},
    {"tetloft_delaunay_within",
     [](A& a) { return about(a, tetloft_delaunay_within, a.real(0.75)); }},
    {"tetloft_delaunay_conflict_zone",
     [](A& a) {
       auto* const delaunay = a.handle<D>();
       const double x = a.real(0.5);
       const double y = a.real(0.25);
       const double z = a.real(0.125);
       const std::uint64_t near = vertex(a, 3);
       return zone(a, 4, [&](auto... parts) {
         return tetloft_delaunay_conflict_zone(delaunay, x, y, z, near, parts...);
       });
     }},
    {"tetloft_delaunay_serialise",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       return tetloft_delaunay_serialise(delaunay, a.handle_output<tetloft_bytes>());
     }},
    {"tetloft_delaunay_deserialise",
     [](A& a) {
       const auto data = a.array(serialised<D>(tetloft_delaunay_serialise));
       return tetloft_delaunay_deserialise(data.data, data.size,
                                           a.handle_output<tetloft_delaunay>());
     }},
});

}  // namespace

std::span<const Call> calls_of_delaunay() { return kCalls; }

}  // namespace tetloft::c_test
