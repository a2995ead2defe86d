// Natural neighbours of points.
#include <tetloft/voronoi.hpp>

#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"
#include "c/vertex_numbers.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_SIBSON == static_cast<int>(NaturalWeights::sibson) &&
              TETLOFT_LAPLACE == static_cast<int>(NaturalWeights::laplace));

NaturalWeights natural_weights_of(std::int32_t kind) {
  return enumerator_of(kind, NaturalWeights::laplace, "kind");
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation3;

tetloft_status tetloft_delaunay_natural_neighbours(const tetloft_delaunay* delaunay, double x,
                                                   double y, double z, int32_t kind, uint64_t near,
                                                   uint64_t* vertices, double* weights,
                                                   size_t capacity, size_t* count) {
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(count, "count");
    if ((vertices == nullptr) != (weights == nullptr)) {
      fail_usage("of the arrays vertices and weights one is NULL");
    }
    const tetloft::NaturalWeights asked = natural_weights_of(kind);
    const tetloft::NaturalNeighbours found =
        value_of(value->ask([&](const DelaunayTriangulation3& t) {
          return tetloft::natural_neighbours(t, {x, y, z}, asked, vertex_of_number(near));
        }));
    fill_array(vertex_numbers(found.vertices), vertices, capacity, count, "vertices");
    fill_array(found.weights, weights, capacity, count, "weights");
  });
}

tetloft_status tetloft_delaunay_natural_neighbours_all(const tetloft_delaunay* delaunay,
                                                       const double* xyz, size_t point_count,
                                                       int32_t kind,
                                                       const tetloft_execution* execution,
                                                       tetloft_natural_neighbours** neighbours) {
  clear(neighbours);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(neighbours, "neighbours");
    const tetloft::NaturalWeights asked = natural_weights_of(kind);
    const tetloft::Execution how = execution_of(execution);
    const std::vector<tetloft::Point3> points = space_points(xyz, point_count);
    tetloft::NaturalNeighboursOfMany found =
        value_of(value->ask([&](const DelaunayTriangulation3& t) {
          return tetloft::natural_neighbours_of_many(t, points, asked, how);
        }));
    hand_out(neighbours,
             {std::move(found.begin), vertex_numbers(found.vertices), std::move(found.weights)});
  });
}

tetloft_status tetloft_natural_neighbours_begin(const tetloft_natural_neighbours* neighbours,
                                                const size_t** begin, size_t* count) {
  clear(begin);
  clear(count);
  return answer([&] { put_array(value_of_handle(neighbours, "neighbours")->begin, begin, count); });
}

tetloft_status tetloft_natural_neighbours_vertices(const tetloft_natural_neighbours* neighbours,
                                                   const uint64_t** vertices, size_t* count) {
  clear(vertices);
  clear(count);
  return answer(
      [&] { put_array(value_of_handle(neighbours, "neighbours")->vertices, vertices, count); });
}

tetloft_status tetloft_natural_neighbours_weights(const tetloft_natural_neighbours* neighbours,
                                                  const double** weights, size_t* count) {
  clear(weights);
  clear(count);
  return answer(
      [&] { put_array(value_of_handle(neighbours, "neighbours")->weights, weights, count); });
}

tetloft_status tetloft_natural_neighbours_free(tetloft_natural_neighbours* neighbours) {
  return free_handle(neighbours);
}
