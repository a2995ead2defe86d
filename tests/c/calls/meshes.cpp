#include <array>

#include "c/calls/calls.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;

const tetloft_check_options* check_options(A& a) {
  tetloft_check_options options;
  tetloft_check_options_defaults(&options);
  options.correspondence = correspondence(a);
  options.split_ulps = a.real(4);
  options.places = static_cast<std::uint64_t>(a.integer(2));
  options.recompute_motions = static_cast<std::int32_t>(a.integer(1));
  options.strict = static_cast<std::int32_t>(a.integer(1));
  options.execution = execution(a);
  return a.options(options);
}

const tetloft_delaunay3_options* delaunay3_options(A& a) {
  tetloft_delaunay3_options options;
  tetloft_delaunay3_options_defaults(&options);
  options.engine = static_cast<std::int32_t>(a.integer(TETLOFT_ENGINE_INCREMENTAL));
  options.most_tets = static_cast<std::uint64_t>(a.integer(1000));
  options.execution = execution(a);
  return a.options(options);
}

std::uint32_t id(A& a, std::uint32_t usual) { return static_cast<std::uint32_t>(a.integer(usual)); }

// Of a vertex, and of an edge.
template <class Query>
tetloft_status at_vertex(A& a, Query query, std::size_t tuple) {
  auto* const mesh = a.handle<tetloft_mesh>();
  const std::uint32_t vertex = id(a, 1);
  const auto array = a.output_array<std::uint32_t>(tuple);
  return query(mesh, vertex, array.data, array.size, a.output<std::size_t>());
}
template <class Query>
tetloft_status at_edge(A& a, Query query, std::size_t tuple) {
  auto* const mesh = a.handle<tetloft_mesh>();
  const std::uint32_t from = id(a, 1);
  const std::uint32_t to = id(a, 2);
  const auto array = a.output_array<std::uint32_t>(tuple);
  return query(mesh, from, to, array.data, array.size, a.output<std::size_t>());
}

tetloft_status delaunay3(A& a) {
  const auto xyz = a.array(a.reals(kTetPoints), 3);
  const auto* const options = delaunay3_options(a);
  auto* const mesh = a.handle_output<tetloft_mesh>();
  auto* const dimension = a.optional_output<int>();
  std::vector<std::uint32_t> representative(xyz.size < A::kMostElements ? xyz.size : 0);
  return tetloft_delaunay3(xyz.data, xyz.size, options, mesh, dimension,
                           representative.empty() ? nullptr : representative.data());
}

// Two tets that meet in a vertex alone.
tetloft_status singular_vertices(A& a) {
  const std::vector<std::uint32_t> tets{0, 1, 2, 3, 0, 4, 5, 6};
  const auto array = a.output_array<std::uint32_t>();
  auto* const count = a.output<std::size_t>();
  auto* const other = a.handle<tetloft_mesh>();
  tetloft_mesh* mesh = nullptr;
  tetloft_status status = tetloft_mesh_create(7, tets.data(), 2, &mesh);
  if (status != TETLOFT_OK) {
    if (count != nullptr) *count = 0;
    return status;
  }
  status = tetloft_mesh_singular_vertices(mesh, array.data, array.size, count);
  tetloft_mesh_free(mesh);
  if (status != TETLOFT_OK) return status;
  return tetloft_mesh_singular_vertices(other, array.data, array.size, count);
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_check",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       auto* const stack = a.handle<tetloft_stack>();
       const auto* const options = check_options(a);
       return tetloft_check(model, stack, options, a.handle_output<tetloft_verdict>());
     }},
    {"tetloft_verdict_pass",
     [](A& a) {
       auto* const verdict = a.handle<tetloft_verdict>();
       return tetloft_verdict_pass(verdict, a.output<int>());
     }},
    {"tetloft_verdict_guarantee",
     [](A& a) {
       auto* const verdict = a.handle<tetloft_verdict>();
       const int number = static_cast<int>(a.integer(2));
       auto* const name = a.optional_output<const char*>();
       auto* const pass = a.optional_output<int>();
       auto* const not_asked = a.optional_output<const char*>();
       return tetloft_verdict_guarantee(verdict, number, name, pass, not_asked,
                                        a.optional_output<std::size_t>());
     }},
    {"tetloft_verdict_failure",
     [](A& a) {
       auto* const verdict = a.handle<tetloft_verdict>();
       const int number = static_cast<int>(a.integer(2));
       const auto failure = static_cast<std::size_t>(a.integer(0));
       auto* const what = a.optional_output<const char*>();
       auto* const count = a.optional_output<std::size_t>();
       return tetloft_verdict_failure(verdict, number, failure, what, count,
                                      a.optional_output<std::size_t>());
     }},
    {"tetloft_verdict_place",
     [](A& a) {
       auto* const verdict = a.handle<tetloft_verdict>();
       const int number = static_cast<int>(a.integer(2));
       const auto failure = static_cast<std::size_t>(a.integer(0));
       const auto place = static_cast<std::size_t>(a.integer(0));
       return tetloft_verdict_place(verdict, number, failure, place, a.output<const char*>());
     }},
    {"tetloft_verdict_figures",
     [](A& a) {
       auto* const verdict = a.handle<tetloft_verdict>();
       return tetloft_verdict_figures(verdict, a.result<tetloft_figures>(TETLOFT_FIGURES_VERSION));
     }},
    {"tetloft_verdict_genus",
     [](A& a) { return get_array<tetloft_verdict, std::int64_t>(a, tetloft_verdict_genus); }},
    {"tetloft_verdict_free",
     [](A& a) { return tetloft_verdict_free(a.own_handle<tetloft_verdict>()); }},
    {"tetloft_mesh_create",
     [](A& a) {
       const auto vertices = static_cast<std::size_t>(a.integer(5));
       const auto tets = a.array(a.ids(kTets), 4);
       return tetloft_mesh_create(vertices, tets.data, tets.size, a.handle_output<tetloft_mesh>());
     }},
    {"tetloft_mesh_counts",
     [](A& a) {
       auto* const mesh = a.handle<tetloft_mesh>();
       auto* const vertices = a.optional_output<std::size_t>();
       return tetloft_mesh_counts(mesh, vertices, a.optional_output<std::size_t>());
     }},
    {"tetloft_mesh_tets",
     [](A& a) { return get_array<tetloft_mesh, std::uint32_t>(a, tetloft_mesh_tets); }},
    {"tetloft_mesh_opposites",
     [](A& a) { return get_array<tetloft_mesh, std::uint32_t>(a, tetloft_mesh_opposites); }},
    {"tetloft_mesh_star", [](A& a) { return at_vertex(a, tetloft_mesh_star, 1); }},
    {"tetloft_mesh_link", [](A& a) { return at_vertex(a, tetloft_mesh_link, 3); }},
    {"tetloft_mesh_edge_star", [](A& a) { return at_edge(a, tetloft_mesh_edge_star, 1); }},
    {"tetloft_mesh_edge_link", [](A& a) { return at_edge(a, tetloft_mesh_edge_link, 2); }},
    {"tetloft_mesh_link_kind",
     [](A& a) {
       auto* const mesh = a.handle<tetloft_mesh>();
       const std::uint32_t vertex = id(a, 1);
       return tetloft_mesh_link_kind(mesh, vertex, a.output<tetloft_link_kind>());
     }},
    {"tetloft_mesh_edge_link_kind",
     [](A& a) {
       auto* const mesh = a.handle<tetloft_mesh>();
       const std::uint32_t from = id(a, 1);
       const std::uint32_t to = id(a, 2);
       return tetloft_mesh_edge_link_kind(mesh, from, to, a.output<tetloft_link_kind>());
     }},
    {"tetloft_mesh_singular_vertices", singular_vertices},
    {"tetloft_mesh_boundary",
     [](A& a) {
       auto* const mesh = a.handle<tetloft_mesh>();
       const auto array = a.output_array<std::uint32_t>();
       return tetloft_mesh_boundary(mesh, array.data, array.size, a.output<std::size_t>());
     }},
    {"tetloft_mesh_free", [](A& a) { return tetloft_mesh_free(a.own_handle<tetloft_mesh>()); }},
    {"tetloft_delaunay3", delaunay3},
    {"tetloft_delaunay2",
     [](A& a) {
       const auto xy = a.array(a.reals(kPlanePoints), 2);
       const auto* const how = execution(a);
       return tetloft_delaunay2(xy.data, xy.size, how, a.handle_output<tetloft_triangulation>());
     }},
    {"tetloft_conforming_delaunay2",
     [](A& a) {
       const auto xy = a.array(a.reals(kPlanePoints), 2);
       const auto segments = a.array(a.ids(kSegments), 2);
       const auto* const how = execution(a);
       return tetloft_conforming_delaunay2(xy.data, xy.size, segments.data, segments.size, how,
                                           a.handle_output<tetloft_triangulation>());
     }},
    {"tetloft_triangulation_points",
     [](A& a) {
       return get_array<tetloft_triangulation, double>(a, tetloft_triangulation_points);
     }},
    {"tetloft_triangulation_triangles",
     [](A& a) {
       return get_array<tetloft_triangulation, std::uint32_t>(a, tetloft_triangulation_triangles);
     }},
    {"tetloft_triangulation_neighbours",
     [](A& a) {
       return get_array<tetloft_triangulation, std::uint32_t>(a, tetloft_triangulation_neighbours);
     }},
    {"tetloft_triangulation_internal",
     [](A& a) {
       return get_array<tetloft_triangulation, std::uint8_t>(a, tetloft_triangulation_internal);
     }},
    {"tetloft_triangulation_chain",
     [](A& a) {
       auto* const triangulation = a.handle<tetloft_triangulation>();
       const auto segment = static_cast<std::size_t>(a.integer(0));
       auto* const points = a.output<const std::uint32_t*>();
       return tetloft_triangulation_chain(triangulation, segment, points, a.output<std::size_t>());
     }},
    {"tetloft_triangulation_free",
     [](A& a) { return tetloft_triangulation_free(a.own_handle<tetloft_triangulation>()); }},
    {"tetloft_points_read",
     [](A& a) {
       const char* const path = a.file("sample.xyz");
       const auto* const options = read_options(a);
       auto* const points = a.handle_output<tetloft_points>();
       return tetloft_points_read(path, options, points,
                                  a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_points_parse",
     [](A& a) {
       const auto data = a.array(std::vector<char>(kPointText.begin(), kPointText.end()));
       const char* const name = a.text("points.xyz");
       const auto* const options = read_options(a);
       auto* const points = a.handle_output<tetloft_points>();
       return tetloft_points_parse(data.data, data.size, name, options, points,
                                   a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_points_data",
     [](A& a) { return get_array<tetloft_points, double>(a, tetloft_points_data); }},
    {"tetloft_points_free",
     [](A& a) { return tetloft_points_free(a.own_handle<tetloft_points>()); }},
    {"tetloft_points_write",
     [](A& a) {
       const auto xyz = a.array(a.reals(kTetPoints), 3);
       const char* const path = a.file("written.xyz");
       const auto* const options = write_options(a, "xyz", Expected::ok);
       return tetloft_points_write(xyz.data, xyz.size, path, options,
                                   a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_points_format",
     [](A& a) {
       const auto xyz = a.array(a.reals(kTetPoints), 3);
       const auto* const options = write_options(a, "xyz", Expected::usage);
       auto* const bytes = a.handle_output<tetloft_bytes>();
       return tetloft_points_format(xyz.data, xyz.size, options, bytes,
                                    a.optional_handle_output<tetloft_warnings>());
     }},
});

}  // namespace

std::span<const Call> calls_of_meshes() { return kCalls; }

}  // namespace tetloft::c_test
