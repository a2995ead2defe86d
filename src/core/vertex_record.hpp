// The vertices of a triangulation that changes, in a record: places, generations, points, and the
// order in which free places are taken.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

#include "core/record.hpp"
#include "core/vertex_places.hpp"

namespace tetloft::internal {

[[nodiscard]] inline std::array<double, 2> coordinates_of(const Point2& p) { return {p.x, p.y}; }
[[nodiscard]] inline std::array<double, 3> coordinates_of(const Point3& p) {
  return {p.x, p.y, p.z};
}
inline void take_coordinates(Point2& p, const std::array<double, 2>& c) { p = {c[0], c[1]}; }
inline void take_coordinates(Point3& p, const std::array<double, 3>& c) { p = {c[0], c[1], c[2]}; }

/// The vertices of a triangulation with vertices(), vertex_count() and point(vertex).
template <class Triangulation>
void put_vertices(RecordWriter& writer, const VertexPlaces& places, const Triangulation& t) {
  writer.put_all(places.generation);
  writer.put_all(places.free);
  writer.put_count(t.vertex_count());
  for (const DelaunayVertex v : t.vertices()) {
    writer.put(v.index);
    for (const double x : coordinates_of(t.point(v))) writer.put(x);
  }
}

template <class Point>
struct VerticesOfRecord {
  VertexPlaces places;
  std::vector<Point> points;        ///< by place
  std::vector<std::uint32_t> live;  ///< the places that have a vertex
};

/// What put_vertices() wrote. Refused where a place is neither free nor a vertex's, or both, where
/// there are `most` of them, and where a coordinate is not finite; equal points are not looked for.
template <class Point>
[[nodiscard]] VerticesOfRecord<Point> get_vertices(RecordReader& reader, std::size_t most) {
  using Coordinates = decltype(coordinates_of(Point()));
  VerticesOfRecord<Point> result;
  result.places.generation = reader.get_all<std::uint32_t>();
  result.places.free = reader.get_all<std::uint32_t>();
  const std::size_t count = reader.get_count(sizeof(std::uint32_t) + sizeof(Coordinates));
  const std::size_t places = result.places.size();
  reader.require(places < most && places == result.places.free.size() + count,
                 "has places that are neither free nor a vertex's");
  result.points.resize(reader.refused() ? 0 : places);
  std::vector<std::uint8_t> taken(result.points.size());
  const auto take = [&](std::uint32_t place) {
    const bool fine = place < taken.size() && taken[place] == 0;
    reader.require(fine, "has a place twice, or one that it does not have");
    if (fine) taken[place] = 1;
    return fine;
  };
  for (std::size_t k = 0; k < count && !reader.refused(); ++k) {
    const auto place = reader.get<std::uint32_t>();
    Coordinates c{};
    for (double& x : c) {
      x = reader.get<double>();
      reader.require(std::isfinite(x), "has a coordinate that is not finite");
    }
    if (reader.refused() || !take(place)) break;
    take_coordinates(result.points[place], c);
    result.live.push_back(place);
  }
  for (const std::uint32_t place : result.places.free) {
    if (reader.refused() || !take(place)) break;
  }
  return result;
}

}  // namespace tetloft::internal
