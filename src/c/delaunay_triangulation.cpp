// Delaunay triangulations of points in space that change.
#include <tetloft/delaunay_triangulation3.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/vertex_numbers.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_LOCATION_VERTEX == static_cast<int>(LocationKind::vertex) &&
              TETLOFT_LOCATION_EDGE == static_cast<int>(LocationKind::edge) &&
              TETLOFT_LOCATION_FACET == static_cast<int>(LocationKind::facet) &&
              TETLOFT_LOCATION_TET == static_cast<int>(LocationKind::tet) &&
              TETLOFT_LOCATION_OUTSIDE == static_cast<int>(LocationKind::outside));

using TetNumbers = std::array<VertexNumber, 4>;

// Answers with what `ask` finds in the triangulation, copied to the caller's array.
template <class Number, class Ask>
tetloft_status copy_found(const tetloft_delaunay* delaunay, Number* array, std::size_t capacity,
                          std::size_t* count, const char* name, Ask&& ask) {
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    fill_array(value->ask(ask), array, capacity, count, name);
  });
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation3;
using tetloft::DelaunayVertex;
using tetloft::Point3;

tetloft_status tetloft_delaunay_create(const double* xyz, size_t point_count,
                                       const tetloft_execution* execution,
                                       tetloft_delaunay** delaunay) {
  clear(delaunay);
  return answer([&] {
    require_output(delaunay, "delaunay");
    const tetloft::Execution how = execution_of(execution);
    hand_out(
        delaunay,
        DelaunayValue(value_of(DelaunayTriangulation3::of(space_points(xyz, point_count), how))));
  });
}

tetloft_status tetloft_delaunay_copy(const tetloft_delaunay* delaunay, tetloft_delaunay** copy) {
  clear(copy);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(copy, "copy");
    hand_out(copy, DelaunayValue(value->ask([](const DelaunayTriangulation3& t) { return t; })));
  });
}

tetloft_status tetloft_delaunay_free(tetloft_delaunay* delaunay) { return free_handle(delaunay); }

tetloft_status tetloft_delaunay_insert(tetloft_delaunay* delaunay, double x, double y, double z,
                                       uint64_t near, uint64_t* vertex, int* is_new) {
  clear(vertex);
  clear(is_new);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(vertex, "vertex");
    const DelaunayTriangulation3::Insertion made =
        value_of(value->change([&](DelaunayTriangulation3& t) {
          return t.insert(Point3{x, y, z}, vertex_of_number(near));
        }));
    *vertex = vertex_number(made.vertex);
    put(is_new, made.is_new ? 1 : 0);
  });
}

tetloft_status tetloft_delaunay_insert_all(tetloft_delaunay* delaunay, const double* xyz,
                                           size_t point_count, const tetloft_execution* execution,
                                           uint64_t* vertices) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    const tetloft::Execution how = execution_of(execution);
    const std::vector<Point3> points = space_points(xyz, point_count);
    const std::vector<DelaunayVertex> made =
        value_of(value->change([&](DelaunayTriangulation3& t) { return t.insert(points, how); }));
    if (vertices != nullptr) std::transform(made.begin(), made.end(), vertices, vertex_number);
  });
}

tetloft_status tetloft_delaunay_remove(tetloft_delaunay* delaunay, uint64_t vertex) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_success(
        value->change([&](DelaunayTriangulation3& t) { return t.remove(live_vertex(t, vertex)); }));
  });
}

tetloft_status tetloft_delaunay_move(tetloft_delaunay* delaunay, uint64_t vertex, double x,
                                     double y, double z) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_success(value->change([&](DelaunayTriangulation3& t) {
      return t.move(live_vertex(t, vertex), {x, y, z});
    }));
  });
}

tetloft_status tetloft_delaunay_clear(tetloft_delaunay* delaunay) {
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->change([](DelaunayTriangulation3& t) { t.clear(); });
  });
}

tetloft_status tetloft_delaunay_counts(const tetloft_delaunay* delaunay, size_t* vertices,
                                       size_t* slots, size_t* tets, int* dimension) {
  clear(vertices, slots, tets);
  clear(dimension);
  return answer([&] {
    value_of_handle(delaunay, "delaunay")->ask([&](const DelaunayTriangulation3& t) {
      put(vertices, t.vertex_count());
      put(slots, t.vertex_slots());
      put(tets, t.tet_count());
      put(dimension, t.dimension());
    });
  });
}

tetloft_status tetloft_delaunay_is_live(const tetloft_delaunay* delaunay, uint64_t vertex,
                                        int* is_live) {
  clear(is_live);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(is_live, "is_live");
    *is_live = value->ask([&](const DelaunayTriangulation3& t) {
      return t.is_live(vertex_of_number(vertex)) ? 1 : 0;
    });
  });
}

tetloft_status tetloft_delaunay_vertices(const tetloft_delaunay* delaunay, uint64_t* vertices,
                                         size_t capacity, size_t* count) {
  return copy_found(delaunay, vertices, capacity, count, "vertices",
                    [](const DelaunayTriangulation3& t) {
                      std::vector<VertexNumber> numbers;
                      for (const DelaunayVertex v : t.vertices())
                        numbers.push_back(vertex_number(v));
                      return numbers;
                    });
}

tetloft_status tetloft_delaunay_points(const tetloft_delaunay* delaunay, double* xyz,
                                       size_t capacity, size_t* count) {
  return copy_found(delaunay, xyz, capacity, count, "xyz", [](const DelaunayTriangulation3& t) {
    std::vector<Point3> points;
    for (const DelaunayVertex v : t.vertices()) points.push_back(t.point(v));
    return points;
  });
}

tetloft_status tetloft_delaunay_point(const tetloft_delaunay* delaunay, uint64_t vertex,
                                      double* xyz) {
  if (xyz != nullptr) std::fill_n(xyz, 3, 0.0);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(xyz, "xyz");
    const Point3 p = value->ask(
        [&](const DelaunayTriangulation3& t) { return t.point(live_vertex(t, vertex)); });
    std::copy_n(std::array{p.x, p.y, p.z}.begin(), 3, xyz);
  });
}

tetloft_status tetloft_delaunay_tets(const tetloft_delaunay* delaunay, uint64_t* tets,
                                     size_t capacity, size_t* count) {
  return copy_found(delaunay, tets, capacity, count, "tets", [](const DelaunayTriangulation3& t) {
    std::vector<TetNumbers> numbers;
    for (const tetloft::TetId tet : t.tets()) numbers.push_back(vertex_numbers(t.vertices(tet)));
    return numbers;
  });
}

tetloft_status tetloft_delaunay_star(const tetloft_delaunay* delaunay, uint64_t vertex,
                                     uint64_t* tets, size_t capacity, size_t* count) {
  return copy_found(delaunay, tets, capacity, count, "tets", [&](const DelaunayTriangulation3& t) {
    std::vector<TetNumbers> numbers;
    for (const tetloft::TetId tet : t.star(live_vertex(t, vertex))) {
      numbers.push_back(vertex_numbers(t.vertices(tet)));
    }
    return numbers;
  });
}

tetloft_status tetloft_delaunay_neighbours(const tetloft_delaunay* delaunay, uint64_t vertex,
                                           uint64_t* neighbours, size_t capacity, size_t* count) {
  return copy_found(delaunay, neighbours, capacity, count, "neighbours",
                    [&](const DelaunayTriangulation3& t) {
                      return vertex_numbers(t.neighbours(live_vertex(t, vertex)));
                    });
}

tetloft_status tetloft_delaunay_locate(const tetloft_delaunay* delaunay, const double* xyz,
                                       size_t point_count, const tetloft_execution* execution,
                                       int32_t* kinds, uint64_t* vertices) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    const tetloft::Execution how = execution_of(execution);
    const std::vector<Point3> points = space_points(xyz, point_count);
    const std::vector<tetloft::Location3> found = value_of(
        value->ask([&](const DelaunayTriangulation3& t) { return t.locate(points, how); }));
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (kinds != nullptr) kinds[i] = static_cast<std::int32_t>(found[i].kind);
      if (vertices != nullptr) {
        std::transform(found[i].vertices.begin(), found[i].vertices.end(), vertices + 4 * i,
                       vertex_number);
      }
    }
  });
}

tetloft_status tetloft_delaunay_nearest(const tetloft_delaunay* delaunay, const double* xyz,
                                        size_t point_count, const tetloft_execution* execution,
                                        uint64_t* vertices) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(vertices, "vertices");
    const tetloft::Execution how = execution_of(execution);
    const std::vector<Point3> points = space_points(xyz, point_count);
    const std::vector<DelaunayVertex> found = value_of(
        value->ask([&](const DelaunayTriangulation3& t) { return t.nearest_vertex(points, how); }));
    std::transform(found.begin(), found.end(), vertices, vertex_number);
  });
}

tetloft_status tetloft_delaunay_nearest_few(const tetloft_delaunay* delaunay, double x, double y,
                                            double z, size_t most, uint64_t* vertices,
                                            size_t capacity, size_t* count) {
  return copy_found(delaunay, vertices, capacity, count, "vertices",
                    [&](const DelaunayTriangulation3& t) {
                      return vertex_numbers(value_of(t.nearest_vertices({x, y, z}, most)));
                    });
}

tetloft_status tetloft_delaunay_within(const tetloft_delaunay* delaunay, double x, double y,
                                       double z, double radius, uint64_t* vertices, size_t capacity,
                                       size_t* count) {
  return copy_found(delaunay, vertices, capacity, count, "vertices",
                    [&](const DelaunayTriangulation3& t) {
                      return vertex_numbers(value_of(t.vertices_within({x, y, z}, radius)));
                    });
}

tetloft_status tetloft_delaunay_serialise(const tetloft_delaunay* delaunay, tetloft_bytes** bytes) {
  clear(bytes);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(bytes, "bytes");
    const std::vector<std::byte> made =
        value_of(value->ask([](const DelaunayTriangulation3& t) { return t.serialise(); }));
    hand_out(bytes, std::string(reinterpret_cast<const char*>(made.data()), made.size()));
  });
}

tetloft_status tetloft_delaunay_deserialise(const void* data, size_t size,
                                            tetloft_delaunay** delaunay) {
  clear(delaunay);
  return answer([&] {
    require_output(delaunay, "delaunay");
    const std::string_view bytes = bytes_of(data, size);
    hand_out(delaunay, DelaunayValue(value_of(DelaunayTriangulation3::deserialise(
                           std::as_bytes(std::span(bytes.data(), bytes.size()))))));
  });
}
