// What a triangulation of the plane holds.
#include <tetloft/delaunay2.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"

using namespace tetloft::internal::c;

tetloft_status tetloft_triangulation_points(const tetloft_triangulation* triangulation,
                                            const double** xy, size_t* count) {
  clear(xy);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(triangulation, "triangulation");
    put_array(value->triangulation.points.raw(), xy, count);
  });
}

tetloft_status tetloft_triangulation_triangles(const tetloft_triangulation* triangulation,
                                               const uint32_t** triangles, size_t* count) {
  clear(triangles);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(triangulation, "triangulation");
    put_array(value->triangulation.triangles.raw(), triangles, count);
  });
}

tetloft_status tetloft_triangulation_neighbours(const tetloft_triangulation* triangulation,
                                                const uint32_t** neighbours, size_t* count) {
  clear(neighbours);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(triangulation, "triangulation");
    put_array(value->triangulation.neighbours.raw(), neighbours, count);
  });
}

tetloft_status tetloft_triangulation_internal(const tetloft_triangulation* triangulation,
                                              const uint8_t** internal, size_t* count) {
  return answer_array(triangulation, "triangulation", &TriangulationValue::internal, internal,
                      count);
}

tetloft_status tetloft_triangulation_chain(const tetloft_triangulation* triangulation,
                                           size_t segment, const uint32_t** points, size_t* count) {
  clear(points);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(triangulation, "triangulation");
    require_index(segment, value->chains.size(), "segment");
    put_array(value->chains[segment], points, count);
  });
}

tetloft_status tetloft_triangulation_free(tetloft_triangulation* triangulation) {
  return free_handle(triangulation);
}
