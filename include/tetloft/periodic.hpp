// Delaunay tets and Voronoi cells of periodic point sets, in orthorhombic and triclinic boxes.
//
// A box is spanned by three vectors a, b, c, in any orientation and however skewed; the set is all
// points[i] + s0 a + s1 b + s2 c for integers s. Points may lie anywhere: shifts tell where the
// neighbours of a point as it was given are, so that points[neighbour] + shift · (a, b, c) is next
// to points[i].
//
// The box and the points in it are rounded to a grid, of 2^-47 of the longest vector of the
// lattice's reduced basis or finer, so that all images are exact; of these, everything
// combinatorial is exact, and unique: the triangulation of the perturbed predicates
// (predicates.hpp), periodic as these depend on the order of points alone. So neighbours are
// mutual. As in voronoi.hpp there is a face for each edge of the triangulation; of points on a
// common sphere, as in crystals, some have no area, or what rounding left of it.
//
// How many images are looked at decides nothing: as many as it takes to prove each tet's sphere
// empty of all points of the infinite set.
//
// Refused (invalid_input) are vectors and points that are not finite or beyond 2^300, vectors in
// one plane, and two points at one place of the lattice, naming both; (unrepresentable) boxes whose
// shortest vectors are lost on the grid of the longest, or shifts beyond 2^30; (work_limit) sets
// whose proof takes more than 2^17 images and 2^11 of each point, or 2^26: few points in a box 200
// times as long as it is wide.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// Three vectors that span space.
struct PeriodicBox {
  Point3 a;
  Point3 b;
  Point3 c;
};
/// Of vectors along the axes.
[[nodiscard]] inline PeriodicBox orthorhombic_box(double x, double y, double z) {
  return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

/// How many times a, b and c.
using LatticeShift = std::array<std::int32_t, 3>;

struct PeriodicFace {
  std::size_t neighbour = 0;  ///< whose image is across, as an input index; perhaps the site itself
  LatticeShift shift{};       ///< which image of it
  /// The same, to the bit, as that of the face of `neighbour` with the opposite shift.
  double area = 0;
  Point3 normal;  ///< of length 1, towards the neighbour; the opposite one of that face
  /// Places in the cell's `corners`, counter-clockwise as seen from outside. Empty where rounding
  /// left nothing of a face without area.
  std::vector<std::uint32_t> corners;
};

struct PeriodicCell {
  double volume = 0;
  std::vector<Point3> corners;      ///< relative to the point as it was given
  std::vector<PeriodicFace> faces;  ///< by neighbour, then shift
};

struct PeriodicVoronoi3 {
  std::vector<PeriodicCell> cells;  ///< by input index
};
/// The cells of all points; the volumes sum to the box's.
[[nodiscard]] TETLOFT_API Result<PeriodicVoronoi3> periodic_voronoi(
    std::span<const Point3> points, const PeriodicBox& box, const Execution& execution = {});

/// A tet, of many images of which this is one: that in which the vertex of lowest index, of equal
/// ones of lowest shift, has shift 0.
struct PeriodicTet {
  std::array<std::uint32_t, 4> points{};  ///< input indices, in positive order
  std::array<LatticeShift, 4> shifts{};
  friend auto operator<=>(const PeriodicTet&, const PeriodicTet&) = default;
};
struct PeriodicDelaunay3 {
  std::vector<PeriodicTet> tets;  ///< each once, sorted
};
[[nodiscard]] TETLOFT_API Result<PeriodicDelaunay3> periodic_delaunay(
    std::span<const Point3> points, const PeriodicBox& box, const Execution& execution = {});

}  // namespace tetloft
