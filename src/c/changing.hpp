// The functions that Delaunay triangulations that change have in space and in the plane, by the
// type of their handle.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/vertex_numbers.hpp"

namespace tetloft::internal::c {

/// Of edges.
template <std::size_t n>
[[nodiscard]] std::vector<std::array<VertexNumber, n>> vertex_numbers(
    const std::vector<std::array<DelaunayVertex, n>>& simplices) {
  std::vector<std::array<VertexNumber, n>> numbers;
  for (const std::array<DelaunayVertex, n>& vertices : simplices) {
    numbers.push_back(vertex_numbers(vertices));
  }
  return numbers;
}

/// Copies the parts of a conflict zone to the caller's arrays: all of them, or none.
template <class Cell, class Face>
void fill_zone(const std::vector<Cell>& cells, const CallerArray<VertexNumber>& cell_array,
               const std::vector<Face>& horizon, const CallerArray<VertexNumber>& horizon_array,
               const std::vector<VertexNumber>& neighbours,
               const CallerArray<VertexNumber>& neighbour_array) {
  for (const auto& array : {cell_array, horizon_array, neighbour_array}) array.require_output();
  *cell_array.count = cells.size();
  *horizon_array.count = horizon.size();
  *neighbour_array.count = neighbours.size();
  for (const auto& array : {cell_array, horizon_array, neighbour_array}) array.require_room();
  fill_array(cells, cell_array);
  fill_array(horizon, horizon_array);
  fill_array(neighbours, neighbour_array);
}

// What differs between space and the plane.
inline constexpr const char* coordinates_name(Point3) { return "xyz"; }
inline constexpr const char* coordinates_name(Point2) { return "xy"; }
[[nodiscard]] inline std::vector<Point3> points_of(const double* xyz, std::size_t count, Point3) {
  return space_points(xyz, count);
}
[[nodiscard]] inline std::vector<Point2> points_of(const double* xy, std::size_t count, Point2) {
  return plane_points(xy, count);
}
[[nodiscard]] inline auto cells_of(const DelaunayTriangulation3& t) { return t.tets(); }
[[nodiscard]] inline auto cells_of(const DelaunayTriangulation2& t) { return t.triangles(); }
[[nodiscard]] inline std::size_t cell_count(const DelaunayTriangulation3& t) {
  return t.tet_count();
}
[[nodiscard]] inline std::size_t cell_count(const DelaunayTriangulation2& t) {
  return t.triangle_count();
}

template <class Handle>
class Changing {
 public:
  using Triangulation = typename ValueOf<Handle>::Triangulation;
  using Point = std::remove_cvref_t<decltype(std::declval<Triangulation>().point({}))>;
  /// The vertices of a tet or a triangle.
  static constexpr std::size_t kCorners = sizeof(Point) / sizeof(double) + 1;

  // Answers with what `ask` finds, copied to the caller's array.
  template <class Number, class Ask>
  static tetloft_status found(const Handle* handle, Number* array, std::size_t capacity,
                              std::size_t* count, const char* name, Ask&& ask) {
    clear(count);
    return answer([&] {
      const auto value = value_of_handle(handle, "delaunay");
      fill_array(value->ask(ask), array, capacity, count, name);
    });
  }
  // The same where `number_of` tells the number of elements before `write` makes them, if they are
  // to be made, and puts them there.
  template <class Number, class NumberOf, class Write>
  static tetloft_status counted(const Handle* handle, Number* array, std::size_t capacity,
                                std::size_t* count, const char* name, NumberOf&& number_of,
                                Write&& write) {
    clear(count);
    return answer([&] {
      value_of_handle(handle, "delaunay")->ask([&](const Triangulation& t) {
        fill_by(number_of(t), CallerArray<Number>{array, capacity, count, name},
                [&](Number* to) { write(t, to); });
      });
    });
  }
  /// The vertices of each of these tets, triangles, or parts of them.
  template <class Simplices>
  static auto corners(const Triangulation& t, const Simplices& simplices) {
    using Vertices = decltype(t.vertices(*simplices.begin()));
    std::vector<std::array<VertexNumber, std::tuple_size_v<Vertices>>> numbers;
    for (const auto simplex : simplices) numbers.push_back(vertex_numbers(t.vertices(simplex)));
    return numbers;
  }

  static tetloft_status create(const double* coordinates, std::size_t point_count,
                               const tetloft_execution* execution, Handle** delaunay) {
    clear(delaunay);
    return answer([&] {
      require_output(delaunay, "delaunay");
      const Execution how = execution_of(execution);
      hand_out(delaunay,
               ValueOf<Handle>(value_of(Triangulation::of(points(coordinates, point_count), how))));
    });
  }

  static tetloft_status copy(const Handle* delaunay, Handle** copy) {
    clear(copy);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(copy, "copy");
      hand_out(copy, ValueOf<Handle>(value->ask([](const Triangulation& t) { return t; })));
    });
  }

  static tetloft_status insert(const Handle* delaunay, const Point& point, VertexNumber near,
                               VertexNumber* vertex, int* is_new) {
    clear(vertex);
    clear(is_new);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(vertex, "vertex");
      const typename Triangulation::Insertion made = value_of(
          value->change([&](Triangulation& t) { return t.insert(point, vertex_of_number(near)); }));
      *vertex = vertex_number(made.vertex);
      put(is_new, made.is_new ? 1 : 0);
    });
  }

  static tetloft_status insert_all(const Handle* delaunay, const double* coordinates,
                                   std::size_t point_count, const tetloft_execution* execution,
                                   VertexNumber* vertices) {
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      const Execution how = execution_of(execution);
      const std::vector<Point> given = points(coordinates, point_count);
      const std::vector<DelaunayVertex> made =
          value_of(value->change([&](Triangulation& t) { return t.insert(given, how); }));
      if (vertices != nullptr) put_vertices(made, vertices);
    });
  }

  static tetloft_status remove(const Handle* delaunay, VertexNumber vertex) {
    return answer([&] {
      require_success(value_of_handle(delaunay, "delaunay")->change([&](Triangulation& t) {
        return t.remove(live_vertex(t, vertex));
      }));
    });
  }

  static tetloft_status move(const Handle* delaunay, VertexNumber vertex, const Point& to) {
    return answer([&] {
      require_success(value_of_handle(delaunay, "delaunay")->change([&](Triangulation& t) {
        return t.move(live_vertex(t, vertex), to);
      }));
    });
  }

  static tetloft_status clear_all(const Handle* delaunay) {
    return answer([&] {
      value_of_handle(delaunay, "delaunay")->change([](Triangulation& t) { t.clear(); });
    });
  }

  static tetloft_status is_live(const Handle* delaunay, VertexNumber vertex, int* is_live) {
    clear(is_live);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(is_live, "is_live");
      *is_live = value->ask(
          [&](const Triangulation& t) { return t.is_live(vertex_of_number(vertex)) ? 1 : 0; });
    });
  }

  static tetloft_status vertices(const Handle* delaunay, VertexNumber* vertices,
                                 std::size_t capacity, std::size_t* count) {
    return counted(
        delaunay, vertices, capacity, count, "vertices",
        [](const Triangulation& t) { return t.vertex_count(); },
        [](const Triangulation& t, VertexNumber* to) {
          for (const DelaunayVertex v : t.vertices()) *to++ = vertex_number(v);
        });
  }

  static tetloft_status points(const Handle* delaunay, double* coordinates, std::size_t capacity,
                               std::size_t* count) {
    return counted(
        delaunay, coordinates, capacity, count, coordinates_name(Point()),
        [](const Triangulation& t) { return t.vertex_count(); },
        [](const Triangulation& t, double* to) {
          for (const DelaunayVertex v : t.vertices()) to = put_point(t.point(v), to);
        });
  }

  static tetloft_status point(const Handle* delaunay, VertexNumber vertex, double* coordinates) {
    if (coordinates != nullptr) put_point(Point{}, coordinates);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(coordinates, coordinates_name(Point()));
      put_point(value->ask([&](const Triangulation& t) { return t.point(live_vertex(t, vertex)); }),
                coordinates);
    });
  }

  static tetloft_status cells(const Handle* delaunay, VertexNumber* cells, std::size_t capacity,
                              std::size_t* count, const char* name) {
    return counted(
        delaunay, cells, capacity, count, name,
        [](const Triangulation& t) { return cell_count(t); },
        [](const Triangulation& t, VertexNumber* to) {
          for (const auto cell : cells_of(t)) to = put_vertices(t.vertices(cell), to);
        });
  }

  static tetloft_status star(const Handle* delaunay, VertexNumber vertex, VertexNumber* cells,
                             std::size_t capacity, std::size_t* count, const char* name) {
    return found(delaunay, cells, capacity, count, name, [&](const Triangulation& t) {
      return corners(t, t.star(live_vertex(t, vertex)));
    });
  }

  static tetloft_status neighbours(const Handle* delaunay, VertexNumber vertex,
                                   VertexNumber* neighbours, std::size_t capacity,
                                   std::size_t* count) {
    return found(delaunay, neighbours, capacity, count, "neighbours", [&](const Triangulation& t) {
      return vertex_numbers(t.neighbours(live_vertex(t, vertex)));
    });
  }

  static tetloft_status locate(const Handle* delaunay, const double* coordinates,
                               std::size_t point_count, const tetloft_execution* execution,
                               std::int32_t* kinds, VertexNumber* vertices) {
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      const Execution how = execution_of(execution);
      const std::vector<Point> given = points(coordinates, point_count);
      const auto found =
          value_of(value->ask([&](const Triangulation& t) { return t.locate(given, how); }));
      for (const auto& location : found) {
        if (kinds != nullptr) *kinds++ = static_cast<std::int32_t>(location.kind);
        if (vertices != nullptr) vertices = put_vertices(location.vertices, vertices);
      }
    });
  }

  static tetloft_status nearest(const Handle* delaunay, const double* coordinates,
                                std::size_t point_count, const tetloft_execution* execution,
                                VertexNumber* vertices) {
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(vertices, "vertices");
      const Execution how = execution_of(execution);
      const std::vector<Point> given = points(coordinates, point_count);
      put_vertices(value_of(value->ask(
                       [&](const Triangulation& t) { return t.nearest_vertex(given, how); })),
                   vertices);
    });
  }

  static tetloft_status nearest_few(const Handle* delaunay, const Point& point, std::size_t most,
                                    VertexNumber* vertices, std::size_t capacity,
                                    std::size_t* count) {
    return found(delaunay, vertices, capacity, count, "vertices", [&](const Triangulation& t) {
      return vertex_numbers(value_of(t.nearest_vertices(point, most)));
    });
  }

  static tetloft_status within(const Handle* delaunay, const Point& point, double radius,
                               VertexNumber* vertices, std::size_t capacity, std::size_t* count) {
    return found(delaunay, vertices, capacity, count, "vertices", [&](const Triangulation& t) {
      return vertex_numbers(value_of(t.vertices_within(point, radius)));
    });
  }

  /// What `measure(t, execution)` finds of the cell of each vertex, by index.
  template <class Measure>
  static tetloft_status measured(const Handle* delaunay, const tetloft_execution* execution,
                                 double* values, std::size_t capacity, std::size_t* count,
                                 const char* name, Measure&& measure) {
    clear(count);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      const Execution how = execution_of(execution);
      value->ask([&](const Triangulation& t) {
        fill_by(t.vertex_slots(), CallerArray<double>{values, capacity, count, name},
                [&](double* to) {
                  const std::vector<double> found = value_of(measure(t, how));
                  std::copy(found.begin(), found.end(), to);
                });
      });
    });
  }

  static tetloft_status serialise(const Handle* delaunay, tetloft_bytes** bytes) {
    clear(bytes);
    return answer([&] {
      const auto value = value_of_handle(delaunay, "delaunay");
      require_output(bytes, "bytes");
      const std::vector<std::byte> made =
          value_of(value->ask([](const Triangulation& t) { return t.serialise(); }));
      hand_out(bytes, std::string(reinterpret_cast<const char*>(made.data()), made.size()));
    });
  }

  static tetloft_status deserialise(const void* data, std::size_t size, Handle** delaunay) {
    clear(delaunay);
    return answer([&] {
      require_output(delaunay, "delaunay");
      const std::string_view bytes = bytes_of(data, size);
      hand_out(delaunay, ValueOf<Handle>(value_of(Triangulation::deserialise(
                             std::as_bytes(std::span(bytes.data(), bytes.size()))))));
    });
  }

 private:
  static std::vector<Point> points(const double* coordinates, std::size_t count) {
    return points_of(coordinates, count, Point());
  }
  static double* put_point(const Point& point, double* coordinates) {
    return std::copy_n(numbers_of(std::span(&point, 1)), kCorners - 1, coordinates);
  }
};

using ChangingSpace = Changing<tetloft_delaunay>;
using ChangingPlane = Changing<tetloft_delaunay_plane>;

}  // namespace tetloft::internal::c
