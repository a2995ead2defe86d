// Delaunay triangulations, in space and in the plane.
#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay.hpp>

#include <algorithm>
#include <limits>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/sections.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_delaunay3_options default_delaunay3_options() {
  const Delaunay3Options defaults;
  tetloft_delaunay3_options options{};
  options.version = TETLOFT_DELAUNAY3_OPTIONS_VERSION;
  options.engine = static_cast<std::int32_t>(defaults.engine);
  options.most_tets = defaults.most_tets;
  return options;
}

Delaunay3Options delaunay3_options_of(const tetloft_delaunay3_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_DELAUNAY3_OPTIONS_VERSION, "delaunay3 options");
  Delaunay3Options result;
  result.engine = enumerator_of(options->engine, DelaunayEngine::slab, "delaunay3 options: engine");
  constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
  result.most_tets = static_cast<std::size_t>(std::min(options->most_tets, kMost));
  result.execution = execution_of(options->execution);
  return result;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_delaunay3_options_defaults(tetloft_delaunay3_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_delaunay3_options();
  });
}

tetloft_status tetloft_delaunay3(const double* xyz, size_t point_count,
                                 const tetloft_delaunay3_options* options, tetloft_mesh** mesh,
                                 int* dimension, uint32_t* representative) {
  clear(mesh);
  clear(dimension);
  return answer([&] {
    require_output(mesh, "mesh");
    const tetloft::Delaunay3Options asked = delaunay3_options_of(options);
    tetloft::Delaunay3 made = value_of(tetloft::delaunay3(space_points(xyz, point_count), asked));
    NewHandle<tetloft_mesh> handle(std::move(made.mesh));
    put(dimension, made.dimension);
    if (representative != nullptr) {
      std::copy_n(numbers_of(made.representative.raw()), point_count, representative);
    }
    handle.give(mesh);
  });
}

tetloft_status tetloft_delaunay2(const double* xy, size_t point_count,
                                 const tetloft_execution* execution,
                                 tetloft_triangulation** triangulation) {
  clear(triangulation);
  return answer([&] {
    require_output(triangulation, "triangulation");
    const tetloft::Execution how = execution_of(execution);
    TriangulationValue made;
    made.triangulation = value_of(tetloft::delaunay2(plane_points(xy, point_count), how));
    hand_out(triangulation, std::move(made));
  });
}

tetloft_status tetloft_conforming_delaunay2(const double* xy, size_t point_count,
                                            const uint32_t* segments, size_t segment_count,
                                            const tetloft_execution* execution,
                                            tetloft_triangulation** triangulation) {
  clear(triangulation);
  return answer([&] {
    require_output(triangulation, "triangulation");
    tetloft::ConformingOptions options;
    options.execution = execution_of(execution);
    tetloft::Conforming2 conforming = value_of(tetloft::conforming_delaunay2(
        plane_points(xy, point_count),
        id_tuples<tetloft::PlaneVertexId, 2>(segments, segment_count, "segments"), options));
    TriangulationValue made;
    made.triangulation = std::move(conforming.triangulation);
    made.chains = std::move(conforming.chains);
    hand_out(triangulation, std::move(made));
  });
}

tetloft_status tetloft_stack_triangulate(const tetloft_stack* stack, size_t section,
                                         const tetloft_execution* execution,
                                         tetloft_triangulation** triangulation) {
  clear(triangulation);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(triangulation, "triangulation");
    tetloft::ConformOptions options;
    options.execution = execution_of(execution);
    const tetloft::Section& found = valid_section_of(*value, section);
    TriangulationValue made;
    if (!found.contours.empty()) {
      tetloft::ConformingSection conforming =
          value_of(tetloft::conform(found, tetloft::SectionId(section), options));
      made.triangulation = std::move(conforming.triangulation);
      made.internal = std::move(conforming.internal.raw());
    }
    hand_out(triangulation, std::move(made));
  });
}
