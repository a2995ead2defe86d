#include "c/calls/calls.hpp"

#include <algorithm>
#include <array>

namespace tetloft::c_test {

namespace {

using A = Arguments;

int go_on(void* user, std::size_t done, std::size_t all) {
  return user != nullptr && done > all ? 1 : 0;
}

template <class Options>
using Defaults = tetloft_status (*)(Options*);

template <class Options>
tetloft_status call_defaults(A& a, Defaults<Options> defaults) {
  return defaults(a.output<Options>());
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_version", [](A&) { return told(tetloft_version()); }},
    {"tetloft_status_name",
     [](A& a) { return told(tetloft_status_name(static_cast<int>(a.integer(3)))); }},
    {"tetloft_last_error", [](A&) { return told(tetloft_last_error()); }},
    {"tetloft_last_message", [](A&) { return told(tetloft_last_message()); }},
    {"tetloft_last_place",
     [](A& a) { return tetloft_last_place(a.result<tetloft_place>(TETLOFT_PLACE_VERSION)); }},
    {"tetloft_warnings_count",
     [](A& a) {
       auto* const warnings = a.handle<tetloft_warnings>();
       return tetloft_warnings_count(warnings, a.output<std::size_t>());
     }},
    {"tetloft_warnings_text",
     [](A& a) {
       auto* const warnings = a.handle<tetloft_warnings>();
       const auto index = static_cast<std::size_t>(a.integer(0));
       return tetloft_warnings_text(warnings, index, a.output<const char*>());
     }},
    {"tetloft_warnings_free",
     [](A& a) { return tetloft_warnings_free(a.own_handle<tetloft_warnings>()); }},
    {"tetloft_stop_create",
     [](A& a) { return tetloft_stop_create(a.handle_output<tetloft_stop>()); }},
    {"tetloft_stop_request", [](A& a) { return tetloft_stop_request(a.handle<tetloft_stop>()); }},
    {"tetloft_stop_free", [](A& a) { return tetloft_stop_free(a.own_handle<tetloft_stop>()); }},
    {"tetloft_execution_defaults",
     [](A& a) { return call_defaults<tetloft_execution>(a, tetloft_execution_defaults); }},
    {"tetloft_bytes_data",
     [](A& a) {
       auto* const bytes = a.handle<tetloft_bytes>();
       const void** const data = a.output<const void*>();
       return tetloft_bytes_data(bytes, data, a.output<std::size_t>());
     }},
    {"tetloft_bytes_free", [](A& a) { return tetloft_bytes_free(a.own_handle<tetloft_bytes>()); }},
    {"tetloft_format_count",
     [](A&) { return tetloft_format_count() > 0 ? TETLOFT_OK : TETLOFT_INTERNAL; }},
    {"tetloft_format_info",
     [](A& a) {
       const auto index = static_cast<std::size_t>(a.integer(1));
       return tetloft_format_info(index, a.result<tetloft_format>(TETLOFT_FORMAT_VERSION));
     }},
    {"tetloft_read_options_defaults",
     [](A& a) { return call_defaults<tetloft_read_options>(a, tetloft_read_options_defaults); }},
    {"tetloft_write_options_defaults",
     [](A& a) { return call_defaults<tetloft_write_options>(a, tetloft_write_options_defaults); }},
    {"tetloft_correspondence_defaults",
     [](A& a) {
       return call_defaults<tetloft_correspondence>(a, tetloft_correspondence_defaults);
     }},
    {"tetloft_reconstruct_options_defaults",
     [](A& a) {
       return call_defaults<tetloft_reconstruct_options>(a, tetloft_reconstruct_options_defaults);
     }},
    {"tetloft_render_options_defaults",
     [](A& a) {
       return call_defaults<tetloft_render_options>(a, tetloft_render_options_defaults);
     }},
    {"tetloft_check_options_defaults",
     [](A& a) { return call_defaults<tetloft_check_options>(a, tetloft_check_options_defaults); }},
    {"tetloft_delaunay3_options_defaults",
     [](A& a) {
       return call_defaults<tetloft_delaunay3_options>(a, tetloft_delaunay3_options_defaults);
     }},
    {"tetloft_evidence_name",
     [](A& a) { return told(tetloft_evidence_name(static_cast<int>(a.integer(1)))); }},
    {"tetloft_fate_name",
     [](A& a) { return told(tetloft_fate_name(static_cast<int>(a.integer(1)))); }},
    {"tetloft_tet_kind_name",
     [](A& a) { return told(tetloft_tet_kind_name(static_cast<int>(a.integer(1)))); }},
    {"tetloft_point_origin_name",
     [](A& a) { return told(tetloft_point_origin_name(static_cast<int>(a.integer(1)))); }},
});

}  // namespace

std::span<const Call> calls_of_values() { return kCalls; }

std::vector<Call> all_calls() {
  std::vector<Call> calls;
  for (const auto part :
       {calls_of_values(), calls_of_stacks(), calls_of_models(), calls_of_meshes(),
        calls_of_delaunay(), calls_of_planes(), calls_of_cells(), calls_of_plane_cells()}) {
    calls.insert(calls.end(), part.begin(), part.end());
  }
  std::sort(calls.begin(), calls.end(), [](const Call& x, const Call& y) {
    return std::string_view(x.function) < std::string_view(y.function);
  });
  return calls;
}

const tetloft_execution* execution(Arguments& a) {
  tetloft_execution options;
  tetloft_execution_defaults(&options);
  options.threads = static_cast<std::uint32_t>(a.integer(1));
  options.stop = a.optional_handle<tetloft_stop>();
  options.progress = go_on;
  return a.options(options);
}

const tetloft_read_options* read_options(Arguments& a) {
  tetloft_read_options options;
  tetloft_read_options_defaults(&options);
  options.unchecked = static_cast<std::int32_t>(a.integer(0));
  return a.options(options);
}

const tetloft_write_options* write_options(Arguments& a, const char* format, Expected null) {
  tetloft_write_options options;
  tetloft_write_options_defaults(&options);
  options.ascii = static_cast<std::int32_t>(a.integer(1));
  options.format = format;
  return a.options(options, null);
}

const tetloft_correspondence* correspondence(Arguments& a) {
  tetloft_correspondence options;
  tetloft_correspondence_defaults(&options);
  options.criterion = static_cast<std::int32_t>(a.integer(TETLOFT_OVERLAP));
  options.tau = a.real(0.1);
  options.chain = static_cast<std::int32_t>(a.integer(1));
  options.lone = static_cast<std::int32_t>(a.integer(1));
  options.void_rule = static_cast<std::int32_t>(a.integer(TETLOFT_VOIDS_OVERLAP));
  options.void_reach = a.real(0.5);
  options.labels = a.optional_handle<tetloft_labels>();
  return a.options(options);
}

}  // namespace tetloft::c_test
