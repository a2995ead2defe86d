// Natural neighbours of points.
#include <tetloft/voronoi.hpp>
#include <tetloft/voronoi2.hpp>

#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/changing.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_SIBSON == static_cast<int>(NaturalWeights::sibson) &&
              TETLOFT_LAPLACE == static_cast<int>(NaturalWeights::laplace));

NaturalWeights natural_weights_of(std::int32_t kind) {
  return enumerator_of(kind, NaturalWeights::laplace, "kind");
}

template <class Handle>
using PointOf = typename Changing<Handle>::Point;

template <class Handle>
tetloft_status natural_neighbours_at(const Handle* delaunay, const PointOf<Handle>& point,
                                     std::int32_t kind, VertexNumber near, VertexNumber* vertices,
                                     double* weights, std::size_t capacity, std::size_t* count) {
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(count, "count");
    if ((vertices == nullptr) != (weights == nullptr)) {
      fail_usage("of the arrays vertices and weights one is NULL");
    }
    const NaturalWeights asked = natural_weights_of(kind);
    const NaturalNeighbours found = value_of(value->ask([&](const auto& t) {
      return natural_neighbours(t, point, asked, vertex_of_number(near));
    }));
    fill_array(vertex_numbers(found.vertices), vertices, capacity, count, "vertices");
    fill_array(found.weights, weights, capacity, count, "weights");
  });
}

template <class Handle>
tetloft_status natural_neighbours_at_all(const Handle* delaunay, const double* coordinates,
                                         std::size_t point_count, std::int32_t kind,
                                         const tetloft_execution* execution,
                                         tetloft_natural_neighbours** neighbours) {
  clear(neighbours);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(neighbours, "neighbours");
    const NaturalWeights asked = natural_weights_of(kind);
    const Execution how = execution_of(execution);
    const auto points = points_of(coordinates, point_count, PointOf<Handle>());
    NaturalNeighboursOfMany found = value_of(value->ask(
        [&](const auto& t) { return natural_neighbours_of_many(t, points, asked, how); }));
    hand_out(neighbours,
             {std::move(found.begin), vertex_numbers(found.vertices), std::move(found.weights)});
  });
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_delaunay_natural_neighbours(const tetloft_delaunay* delaunay, double x,
                                                   double y, double z, int32_t kind, uint64_t near,
                                                   uint64_t* vertices, double* weights,
                                                   size_t capacity, size_t* count) {
  return natural_neighbours_at(delaunay, {x, y, z}, kind, near, vertices, weights, capacity, count);
}

tetloft_status tetloft_delaunay_plane_natural_neighbours(const tetloft_delaunay_plane* delaunay,
                                                         double x, double y, int32_t kind,
                                                         uint64_t near, uint64_t* vertices,
                                                         double* weights, size_t capacity,
                                                         size_t* count) {
  return natural_neighbours_at(delaunay, {x, y}, kind, near, vertices, weights, capacity, count);
}

tetloft_status tetloft_delaunay_natural_neighbours_all(const tetloft_delaunay* delaunay,
                                                       const double* xyz, size_t point_count,
                                                       int32_t kind,
                                                       const tetloft_execution* execution,
                                                       tetloft_natural_neighbours** neighbours) {
  return natural_neighbours_at_all(delaunay, xyz, point_count, kind, execution, neighbours);
}

tetloft_status tetloft_delaunay_plane_natural_neighbours_all(
    const tetloft_delaunay_plane* delaunay, const double* xy, size_t point_count, int32_t kind,
    const tetloft_execution* execution, tetloft_natural_neighbours** neighbours) {
  return natural_neighbours_at_all(delaunay, xy, point_count, kind, execution, neighbours);
}

tetloft_status tetloft_natural_neighbours_begin(const tetloft_natural_neighbours* neighbours,
                                                const size_t** begin, size_t* count) {
  return answer_array(neighbours, "neighbours", &NaturalNeighboursValue::begin, begin, count);
}

tetloft_status tetloft_natural_neighbours_vertices(const tetloft_natural_neighbours* neighbours,
                                                   const uint64_t** vertices, size_t* count) {
  return answer_array(neighbours, "neighbours", &NaturalNeighboursValue::vertices, vertices, count);
}

tetloft_status tetloft_natural_neighbours_weights(const tetloft_natural_neighbours* neighbours,
                                                  const double** weights, size_t* count) {
  return answer_array(neighbours, "neighbours", &NaturalNeighboursValue::weights, weights, count);
}

tetloft_status tetloft_natural_neighbours_free(tetloft_natural_neighbours* neighbours) {
  return free_handle(neighbours);
}
