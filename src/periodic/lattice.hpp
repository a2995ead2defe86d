// A lattice by a reduced basis on a grid, and points wrapped into its cell.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/periodic.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::periodic {

using Integers = std::array<std::int64_t, 3>;

/// Invariant: coordinates of the basis are multiples of the grid's, and small enough that all
/// points of the grid within two covering radii of the cell are doubles, exactly.
struct Lattice {
  PeriodicBox box;                   ///< the caller's
  std::array<Point3, 3> basis;       ///< reduced: short, and nearly orthogonal
  std::array<Integers, 3> in_box{};  ///< basis[i] in the caller's vectors
  std::array<Point3, 3> dual;        ///< dual[i] · basis[j] is 1 for i = j, else 0, rounded
  std::array<double, 3> slope{};     ///< |dual[i]|: by how much coordinate i changes with distance
  std::array<int, 3> grid{};         ///< exponents of two
  /// No point of space is farther from all lattice points: half the diagonal of the box that the
  /// basis' Gram–Schmidt vectors span (Babai, Combinatorica 6, 1986), which is no longer than that
  /// of its own.
  double covering_radius = 0;
  double volume = 0;
};
[[nodiscard]] Result<Lattice> reduced_lattice(const PeriodicBox& box);

/// Coordinates in the reduced basis.
[[nodiscard]] std::array<double, 3> coordinates(const Lattice& lattice, const Point3& p);

/// Points on the grid whose coordinates are in [0, 1], or by less than kWrapSlack beyond, and what
/// was subtracted, in the caller's vectors.
struct WrappedPoints {
  std::vector<Point3> points;
  std::vector<Integers> subtracted;
};
inline constexpr double kWrapSlack = 0x1p-26;
[[nodiscard]] Result<WrappedPoints> wrapped(const Lattice& lattice, std::span<const Point3> points);

}  // namespace tetloft::internal::periodic
