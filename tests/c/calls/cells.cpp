// Voronoi cells, natural neighbours, periodic sets.
#include <array>
#include <vector>

#include "c/calls/calls.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;
using Cells = tetloft_cells;
using Sphere = std::array<double, 4>;

template <class Made>
using OfPeriodicSet = tetloft_status (*)(const double*, std::size_t, const double*,
                                         const tetloft_execution*, Made**);
template <class Made>
tetloft_status of_periodic_set(A& a, OfPeriodicSet<Made> make) {
  const auto xyz = a.array(a.reals(kTetPoints), 3);
  const double* const box = a.numbers(kBoxVectors);
  const auto* const how = execution(a);
  return make(xyz.data, xyz.size, box, how, a.handle_output<Made>());
}

tetloft_status natural_neighbours(A& a) {
  auto* const delaunay = a.handle<tetloft_delaunay>();
  const double x = a.real(0.25);
  const double y = a.real(0.25);
  const double z = a.real(0.25);
  const auto kind = static_cast<std::int32_t>(a.integer(TETLOFT_LAPLACE));
  const auto near = static_cast<std::uint64_t>(a.integer(3));
  const auto vertices = a.output_array<std::uint64_t>();
  std::vector<double> weights(vertices.size + 1);
  return tetloft_delaunay_natural_neighbours(delaunay, x, y, z, kind, near, vertices.data,
                                             vertices.data == nullptr ? nullptr : weights.data(),
                                             vertices.size, a.output<std::size_t>());
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_delaunay_cells",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const double* const box = a.numbers(kClippingBox, Expected::ok);
       const auto* const how = execution(a);
       return tetloft_delaunay_cells(delaunay, box, how, a.handle_output<Cells>());
     }},
    {"tetloft_delaunay_cell",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const auto vertex = static_cast<std::uint64_t>(a.integer(2));
       const double* const box = a.numbers(kClippingBox, Expected::ok);
       return tetloft_delaunay_cell(delaunay, vertex, box, a.handle_output<Cells>());
     }},
    {"tetloft_periodic_voronoi",
     [](A& a) { return of_periodic_set<Cells>(a, tetloft_periodic_voronoi); }},
    {"tetloft_cells_sites",
     [](A& a) { return get_array<Cells, std::uint64_t>(a, tetloft_cells_sites); }},
    {"tetloft_cells_bounded",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_cells_bounded); }},
    {"tetloft_cells_volumes",
     [](A& a) { return get_array<Cells, double>(a, tetloft_cells_volumes); }},
    {"tetloft_cells_corner_begin",
     [](A& a) { return get_array<Cells, std::size_t>(a, tetloft_cells_corner_begin); }},
    {"tetloft_cells_corners",
     [](A& a) { return get_array<Cells, double>(a, tetloft_cells_corners); }},
    {"tetloft_cells_face_begin",
     [](A& a) { return get_array<Cells, std::size_t>(a, tetloft_cells_face_begin); }},
    {"tetloft_cells_neighbours",
     [](A& a) { return get_array<Cells, std::uint64_t>(a, tetloft_cells_neighbours); }},
    {"tetloft_cells_sides",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_cells_sides); }},
    {"tetloft_cells_faces_bounded",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_cells_faces_bounded); }},
    {"tetloft_cells_areas", [](A& a) { return get_array<Cells, double>(a, tetloft_cells_areas); }},
    {"tetloft_cells_face_corner_begin",
     [](A& a) { return get_array<Cells, std::size_t>(a, tetloft_cells_face_corner_begin); }},
    {"tetloft_cells_face_corners",
     [](A& a) { return get_array<Cells, std::uint32_t>(a, tetloft_cells_face_corners); }},
    {"tetloft_cells_shifts",
     [](A& a) { return get_array<Cells, std::int32_t>(a, tetloft_cells_shifts); }},
    {"tetloft_cells_normals",
     [](A& a) { return get_array<Cells, double>(a, tetloft_cells_normals); }},
    {"tetloft_cells_free", [](A& a) { return tetloft_cells_free(a.own_handle<Cells>()); }},
    {"tetloft_delaunay_volumes",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const auto* const how = execution(a);
       const auto volumes = a.output_array<double>();
       return tetloft_delaunay_volumes(delaunay, how, volumes.data, volumes.size,
                                       a.output<std::size_t>());
     }},
    {"tetloft_delaunay_circumspheres",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const auto spheres = a.output_array<double>(4);
       return tetloft_delaunay_circumspheres(delaunay, spheres.data, spheres.size,
                                             a.output<std::size_t>());
     }},
    {"tetloft_circumsphere",
     [](A& a) {
       const double* const xyz = a.numbers({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
       auto* const sphere = a.output<Sphere>();
       return tetloft_circumsphere(xyz, sphere == nullptr ? nullptr : sphere->data());
     }},
    {"tetloft_delaunay_natural_neighbours", natural_neighbours},
    {"tetloft_delaunay_natural_neighbours_all",
     [](A& a) {
       auto* const delaunay = a.handle<tetloft_delaunay>();
       const auto xyz = a.array(a.reals(kQueries), 3);
       const auto kind = static_cast<std::int32_t>(a.integer(TETLOFT_SIBSON));
       const auto* const how = execution(a);
       return tetloft_delaunay_natural_neighbours_all(
           delaunay, xyz.data, xyz.size, kind, how, a.handle_output<tetloft_natural_neighbours>());
     }},
    {"tetloft_natural_neighbours_begin",
     [](A& a) {
       return get_array<tetloft_natural_neighbours, std::size_t>(a,
                                                                 tetloft_natural_neighbours_begin);
     }},
    {"tetloft_natural_neighbours_vertices",
     [](A& a) {
       return get_array<tetloft_natural_neighbours, std::uint64_t>(
           a, tetloft_natural_neighbours_vertices);
     }},
    {"tetloft_natural_neighbours_weights",
     [](A& a) {
       return get_array<tetloft_natural_neighbours, double>(a, tetloft_natural_neighbours_weights);
     }},
    {"tetloft_natural_neighbours_free",
     [](A& a) {
       return tetloft_natural_neighbours_free(a.own_handle<tetloft_natural_neighbours>());
     }},
    {"tetloft_periodic_delaunay",
     [](A& a) { return of_periodic_set<tetloft_periodic_tets>(a, tetloft_periodic_delaunay); }},
    {"tetloft_periodic_tets_points",
     [](A& a) {
       return get_array<tetloft_periodic_tets, std::uint32_t>(a, tetloft_periodic_tets_points);
     }},
    {"tetloft_periodic_tets_shifts",
     [](A& a) {
       return get_array<tetloft_periodic_tets, std::int32_t>(a, tetloft_periodic_tets_shifts);
     }},
    {"tetloft_periodic_tets_free",
     [](A& a) { return tetloft_periodic_tets_free(a.own_handle<tetloft_periodic_tets>()); }},
});

}  // namespace

std::span<const Call> calls_of_cells() { return kCalls; }

}  // namespace tetloft::c_test
