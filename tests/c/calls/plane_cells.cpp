// Voronoi cells and natural neighbours in the plane.
#include <array>
#include <vector>

#include "c/calls/calls.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;
using Plane = tetloft_delaunay_plane;
using Cells = tetloft_plane_cells;

const std::vector<double> kRectangle{-1, -1, 2, 2};
const std::vector<double> kPlaneQueries{0.5, 0.5, 2, 1, 9, 9};

// With a triangulation from which the constraints are taken first, as there are no cells with them.
template <class Of>
tetloft_status without_constraints(A& a, Of call) {
  auto* const plane = a.changing_handle<Plane>();
  for (std::uint32_t constraint = 0; constraint < kOutline.size() / 2; ++constraint) {
    const tetloft_status status = tetloft_delaunay_plane_remove_constraint(plane, constraint);
    if (status == TETLOFT_OUT_OF_MEMORY) return status;
  }
  return call(a, plane);
}

tetloft_status cells(A& a, Plane* plane) {
  const double* const rectangle = a.numbers(kRectangle, Expected::ok);
  const auto* const how = execution(a);
  return tetloft_delaunay_plane_cells(plane, rectangle, how, a.handle_output<Cells>());
}

tetloft_status cell(A& a, Plane* plane) {
  const auto vertex = static_cast<std::uint64_t>(a.integer(2));
  const double* const rectangle = a.numbers(kRectangle, Expected::ok);
  return tetloft_delaunay_plane_cell(plane, vertex, rectangle, a.handle_output<Cells>());
}

tetloft_status areas(A& a, Plane* plane) {
  const auto* const how = execution(a);
  const auto array = a.output_array<double>();
  return tetloft_delaunay_plane_areas(plane, how, array.data, array.size, a.output<std::size_t>());
}

tetloft_status plane_neighbours(A& a, Plane* plane) {
  const double x = a.real(0.5);
  const double y = a.real(0.25);
  const auto kind = static_cast<std::int32_t>(a.integer(TETLOFT_SIBSON));
  const auto near = static_cast<std::uint64_t>(a.integer(3));
  const auto vertices = a.output_array<std::uint64_t>();
  std::vector<double> weights(vertices.size + 1);
  return tetloft_delaunay_plane_natural_neighbours(
      plane, x, y, kind, near, vertices.data, vertices.data == nullptr ? nullptr : weights.data(),
      vertices.size, a.output<std::size_t>());
}

tetloft_status plane_neighbours_all(A& a, Plane* plane) {
  const auto xy = a.array(a.reals(kPlaneQueries), 2);
  const auto kind = static_cast<std::int32_t>(a.integer(TETLOFT_LAPLACE));
  const auto* const how = execution(a);
  return tetloft_delaunay_plane_natural_neighbours_all(
      plane, xy.data, xy.size, kind, how, a.handle_output<tetloft_natural_neighbours>());
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_delaunay_plane_cells", [](A& a) { return without_constraints(a, cells); }},
    {"tetloft_delaunay_plane_cell", [](A& a) { return without_constraints(a, cell); }},
    {"tetloft_delaunay_plane_areas", [](A& a) { return without_constraints(a, areas); }},
    {"tetloft_delaunay_plane_natural_neighbours",
     [](A& a) { return without_constraints(a, plane_neighbours); }},
    {"tetloft_delaunay_plane_natural_neighbours_all",
     [](A& a) { return without_constraints(a, plane_neighbours_all); }},
    {"tetloft_plane_cells_sites",
     [](A& a) { return get_array<Cells, std::uint64_t>(a, tetloft_plane_cells_sites); }},
    {"tetloft_plane_cells_bounded",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_plane_cells_bounded); }},
    {"tetloft_plane_cells_areas",
     [](A& a) { return get_array<Cells, double>(a, tetloft_plane_cells_areas); }},
    {"tetloft_plane_cells_corner_begin",
     [](A& a) { return get_array<Cells, std::size_t>(a, tetloft_plane_cells_corner_begin); }},
    {"tetloft_plane_cells_corners",
     [](A& a) { return get_array<Cells, double>(a, tetloft_plane_cells_corners); }},
    {"tetloft_plane_cells_edge_begin",
     [](A& a) { return get_array<Cells, std::size_t>(a, tetloft_plane_cells_edge_begin); }},
    {"tetloft_plane_cells_neighbours",
     [](A& a) { return get_array<Cells, std::uint64_t>(a, tetloft_plane_cells_neighbours); }},
    {"tetloft_plane_cells_sides",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_plane_cells_sides); }},
    {"tetloft_plane_cells_inside",
     [](A& a) { return get_array<Cells, std::uint8_t>(a, tetloft_plane_cells_inside); }},
    {"tetloft_plane_cells_ends",
     [](A& a) { return get_array<Cells, std::uint32_t>(a, tetloft_plane_cells_ends); }},
    {"tetloft_plane_cells_lengths",
     [](A& a) { return get_array<Cells, double>(a, tetloft_plane_cells_lengths); }},
    {"tetloft_plane_cells_free",
     [](A& a) { return tetloft_plane_cells_free(a.own_handle<Cells>()); }},
});

}  // namespace

std::span<const Call> calls_of_plane_cells() { return kCalls; }

}  // namespace tetloft::c_test
