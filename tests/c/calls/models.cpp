#include <array>

#include "c/calls/calls.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;

const tetloft_reconstruct_options* reconstruct_options(A& a) {
  tetloft_reconstruct_options options;
  tetloft_reconstruct_options_defaults(&options);
  options.correspondence = correspondence(a);
  options.ends = static_cast<std::int32_t>(a.integer(TETLOFT_ENDS_HALF));
  options.engine = static_cast<std::int32_t>(a.integer(TETLOFT_ENGINE_AUTOMATIC));
  options.between = a.integer(1);
  options.divide_coarse = static_cast<std::int32_t>(a.integer(0));
  options.thickness = a.real(0);
  options.work_limit = a.real(100);
  options.execution = execution(a);
  return a.options(options);
}

const tetloft_render_options* render_options(A& a) {
  tetloft_render_options options;
  tetloft_render_options_defaults(&options);
  options.colour = static_cast<std::int32_t>(a.integer(TETLOFT_COLOUR_DIHEDRAL));
  options.azimuth = a.real(10);
  options.elevation = a.real(20);
  options.width = static_cast<std::int32_t>(a.integer(40));
  options.height = static_cast<std::int32_t>(a.integer(30));
  options.cut_axis = static_cast<std::int32_t>(a.integer(2));
  options.cut_position = a.real(0.25);
  options.explode = a.real(0);
  options.stretch = a.real(1);
  options.edges = static_cast<std::int32_t>(a.integer(1));
  options.contours = static_cast<std::int32_t>(a.integer(1));
  options.white = static_cast<std::int32_t>(a.integer(1));
  options.title = a.optional_text("A title");
  options.execution = execution(a);
  return a.options(options);
}

// A model as the text of a file.
std::vector<char> model_bytes() {
  static const std::vector<char> bytes = [] {
    auto* const model = static_cast<tetloft_model*>(new_handle(Kind::model));
    tetloft_write_options options;
    tetloft_write_options_defaults(&options);
    options.format = "vtu";
    options.ascii = 1;
    tetloft_bytes* made = nullptr;
    tetloft_model_format(model, &options, &made, nullptr);
    const void* data = nullptr;
    std::size_t size = 0;
    tetloft_bytes_data(made, &data, &size);
    const char* const text = static_cast<const char*>(data);
    std::vector<char> copy(text, text + size);
    tetloft_bytes_free(made);
    tetloft_model_free(model);
    return copy;
  }();
  return bytes;
}

// Reconstructed, for what others have not.
tetloft_status report(A& a) {
  const auto* const options = reconstruct_options(a);
  auto* const stack = a.handle<tetloft_stack>();
  auto* const result = a.result<tetloft_report>(TETLOFT_REPORT_VERSION);
  tetloft_model* model = nullptr;
  tetloft_status status = tetloft_reconstruct(stack, options, &model, nullptr);
  if (status == TETLOFT_OK) status = tetloft_model_report(model, result);
  tetloft_model_free(model);
  return status;
}

tetloft_status create_model(A& a) {
  const auto xyz = a.array(a.reals(kTetPoints), 3);
  const auto tets = a.array(a.ids(kTets), 4);
  return tetloft_model_create(xyz.data, xyz.size, tets.data, tets.size,
                              a.handle_output<tetloft_model>());
}

template <class Write>
tetloft_status write_model(A& a, Write write, const char* format) {
  auto* const model = a.handle<tetloft_model>();
  const char* const path = a.file("written");
  tetloft_write_options options;
  tetloft_write_options_defaults(&options);
  options.format = format;
  return write(model, path, &options, a.optional_handle_output<tetloft_warnings>());
}

template <class Format>
tetloft_status format_model(A& a, Format format, const char* name) {
  auto* const model = a.handle<tetloft_model>();
  const auto* const options = write_options(a, name, Expected::usage);
  auto* const bytes = a.handle_output<tetloft_bytes>();
  return format(model, options, bytes, a.optional_handle_output<tetloft_warnings>());
}

template <class T, class Get>
tetloft_status model_array(A& a, Get get) {
  return get_array<tetloft_model, T>(a, get);
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_reconstruct",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto* const options = reconstruct_options(a);
       auto* const model = a.handle_output<tetloft_model>();
       return tetloft_reconstruct(stack, options, model,
                                  a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_between",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto* const options = reconstruct_options(a);
       auto* const longer = a.handle_output<tetloft_stack>();
       auto* const decisions = a.optional_handle_output<tetloft_labels>();
       return tetloft_between(stack, options, longer, decisions,
                              a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_model_report", report},
    {"tetloft_model_create", create_model},
    {"tetloft_model_read",
     [](A& a) {
       const char* const path = a.file("sample.vtu");
       const auto* const options = read_options(a);
       auto* const model = a.handle_output<tetloft_model>();
       return tetloft_model_read(path, options, model,
                                 a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_model_parse",
     [](A& a) {
       const auto data = a.array(model_bytes());
       const char* const name = a.text("model.vtu");
       const auto* const options = read_options(a);
       auto* const model = a.handle_output<tetloft_model>();
       return tetloft_model_parse(data.data, data.size, name, options, model,
                                  a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_model_write", [](A& a) { return write_model(a, tetloft_model_write, "vtu"); }},
    {"tetloft_model_write_surface",
     [](A& a) { return write_model(a, tetloft_model_write_surface, "obj"); }},
    {"tetloft_model_format", [](A& a) { return format_model(a, tetloft_model_format, "vtu"); }},
    {"tetloft_model_format_surface",
     [](A& a) { return format_model(a, tetloft_model_format_surface, "obj"); }},
    {"tetloft_model_free", [](A& a) { return tetloft_model_free(a.own_handle<tetloft_model>()); }},
    {"tetloft_model_points", [](A& a) { return model_array<double>(a, tetloft_model_points); }},
    {"tetloft_model_tets", [](A& a) { return model_array<std::uint32_t>(a, tetloft_model_tets); }},
    {"tetloft_model_tet_components",
     [](A& a) { return model_array<std::uint32_t>(a, tetloft_model_tet_components); }},
    {"tetloft_model_tet_slabs",
     [](A& a) { return model_array<std::uint32_t>(a, tetloft_model_tet_slabs); }},
    {"tetloft_model_tet_kinds",
     [](A& a) { return model_array<std::uint8_t>(a, tetloft_model_tet_kinds); }},
    {"tetloft_model_point_sections",
     [](A& a) { return model_array<std::uint32_t>(a, tetloft_model_point_sections); }},
    {"tetloft_model_point_contours",
     [](A& a) { return model_array<std::uint32_t>(a, tetloft_model_point_contours); }},
    {"tetloft_model_point_origins",
     [](A& a) { return model_array<std::uint8_t>(a, tetloft_model_point_origins); }},
    {"tetloft_model_component_count",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       return tetloft_model_component_count(model, a.output<std::size_t>());
     }},
    {"tetloft_model_description",
     [](A& a) { return description<tetloft_model>(a, tetloft_model_description); }},
    {"tetloft_model_component_name",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       const auto component = static_cast<std::size_t>(a.integer(0));
       return tetloft_model_component_name(model, component, a.handle_output<tetloft_bytes>());
     }},
    {"tetloft_model_component",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       const auto component = static_cast<std::size_t>(a.integer(0));
       return tetloft_model_component(model, component, a.handle_output<tetloft_model>());
     }},
    {"tetloft_model_volume",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       return tetloft_model_volume(model, a.output<double>());
     }},
    {"tetloft_model_mesh",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       return tetloft_model_mesh(model, a.handle_output<tetloft_mesh>());
     }},
    {"tetloft_model_boundary",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       return tetloft_model_boundary(model, a.handle_output<tetloft_surface>());
     }},
    {"tetloft_surface_triangles",
     [](A& a) { return get_array<tetloft_surface, std::uint32_t>(a, tetloft_surface_triangles); }},
    {"tetloft_surface_tets",
     [](A& a) { return get_array<tetloft_surface, std::uint32_t>(a, tetloft_surface_tets); }},
    {"tetloft_surface_components",
     [](A& a) {
       auto* const surface = a.handle<tetloft_surface>();
       auto* const component = a.output<const std::uint32_t*>();
       auto* const count = a.output<std::size_t>();
       return tetloft_surface_components(surface, component, count,
                                         a.optional_output<std::size_t>());
     }},
    {"tetloft_surface_topology",
     [](A& a) {
       auto* const surface = a.handle<tetloft_surface>();
       const auto component = static_cast<std::size_t>(a.integer(0));
       auto* const vertices = a.optional_output<std::size_t>();
       auto* const edges = a.optional_output<std::size_t>();
       auto* const triangles = a.optional_output<std::size_t>();
       return tetloft_surface_topology(surface, component, vertices, edges, triangles,
                                       a.optional_output<std::int64_t>());
     }},
    {"tetloft_surface_free",
     [](A& a) { return tetloft_surface_free(a.own_handle<tetloft_surface>()); }},
    {"tetloft_model_render",
     [](A& a) {
       auto* const model = a.handle<tetloft_model>();
       auto* const stack = a.optional_handle<tetloft_stack>();
       const char* const path = a.file("written.svg");
       return tetloft_model_render(model, stack, path, render_options(a));
     }},
});

}  // namespace

std::span<const Call> calls_of_models() { return kCalls; }

}  // namespace tetloft::c_test
