// The boundary of a model.
#include <tetloft/model.hpp>
#include <tetloft/tet_mesh.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"

using namespace tetloft::internal::c;

tetloft_status tetloft_model_boundary(const tetloft_model* model, tetloft_surface** surface) {
  clear(surface);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(surface, "surface");
    // What others made may be no mesh, and have no boundary then.
    if (!value->report) static_cast<void>(value_of(tetloft::half_faces(value->model)));
    SurfaceValue made;
    made.surface = tetloft::boundary_surface(value->model);
    made.components = tetloft::surface_components(made.surface.triangles);
    hand_out(surface, std::move(made));
  });
}

tetloft_status tetloft_surface_triangles(const tetloft_surface* surface, const uint32_t** triangles,
                                         size_t* count) {
  clear(triangles);
  clear(count);
  return answer(
      [&] { put_array(value_of_handle(surface, "surface")->surface.triangles, triangles, count); });
}

tetloft_status tetloft_surface_tets(const tetloft_surface* surface, const uint32_t** tets,
                                    size_t* count) {
  clear(tets);
  clear(count);
  return answer([&] { put_array(value_of_handle(surface, "surface")->surface.tet, tets, count); });
}

tetloft_status tetloft_surface_components(const tetloft_surface* surface,
                                          const uint32_t** component, size_t* count,
                                          size_t* components) {
  clear(component);
  clear(count, components);
  return answer([&] {
    const auto value = value_of_handle(surface, "surface");
    put_array(value->components.component, component, count);
    put(components, value->components.topology.size());
  });
}

tetloft_status tetloft_surface_topology(const tetloft_surface* surface, size_t component,
                                        size_t* vertices, size_t* edges, size_t* triangles,
                                        int64_t* genus) {
  clear(vertices, edges, triangles);
  clear(genus);
  return answer([&] {
    const auto value = value_of_handle(surface, "surface");
    require_index(component, value->components.topology.size(), "component");
    const tetloft::SurfaceTopology& topology = value->components.topology[component];
    put(vertices, topology.vertices);
    put(edges, topology.edges);
    put(triangles, topology.triangles);
    put(genus, static_cast<int64_t>(topology.genus()));
  });
}

tetloft_status tetloft_surface_free(tetloft_surface* surface) { return free_handle(surface); }
