// What natural neighbours in space and in the plane share: a point's surroundings, the cell that it
// would have, and weights made of measures.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/voronoi.hpp>

namespace tetloft::internal::voronoi {

/// The neighbours of a point that is no vertex, relative to it, and in a unit near the largest: of
/// weights only ratios count, and so no measure leaves the range of doubles.
struct Surroundings {
  std::vector<DelaunayVertex> vertices;
  std::vector<Point3> points;   ///< as they are; in the plane z is 0
  std::vector<Point3> offsets;  ///< relative, divided by 2^exponent
  int exponent = 0;
  std::optional<Point3> normal;  ///< on the hull of points in space: of its plane

  /// Of neighbours that are there already.
  void put_offsets_from(const Point3& p);
};

/// A shape of at first half · 2 in each direction around the origin, as `cut(shape)` leaves it: as
/// large as it must be to hold the cell. So near the hull that the cell is more than 2^18 times as
/// large as the distances, what is in the one of that size: what is missing changes the weights by
/// some 2^-18, and in larger cells rounding of the bisectors' directions tells.
template <class Shape, class Cut>
[[nodiscard]] Shape cell_among(const Cut& cut) {
  constexpr double kFirst = 0x1p2, kLarger = 0x1p8, kLast = 0x1p18;
  for (double half = kFirst;; half *= kLarger) {
    Shape cell = Shape::around_origin(half);
    cut(cell);
    if (half >= kLast || !cell.reaches_box()) return cell;
  }
}

/// Between the ends of an edge, as far as the other one is.
[[nodiscard]] std::vector<double> weights_between(const Surroundings& ends);

/// The neighbours with these weights, made to sum to 1. Among vertices within ulps nothing may be
/// left of the cell: the nearest has all.
[[nodiscard]] NaturalNeighbours of_sum_one(const Surroundings& around, std::vector<double> weights);

[[nodiscard]] Error refused_at(const char* why, const Point3& p);
/// Refused where there are no such weights.
[[nodiscard]] Result<void> check_weights(NaturalWeights weights);
/// Refused where p is not finite, or beyond 2^300.
[[nodiscard]] Result<void> check_asked(const Point3& p);
/// Refused where a neighbour is beyond 2^300.
[[nodiscard]] Result<void> check_neighbours(const Surroundings& around);

}  // namespace tetloft::internal::voronoi
