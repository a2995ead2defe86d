// A convex polygon, a rectangle first, that is cut by lines.
//
// What is cut off is one run of corners, whatever rounding said of single ones, and so is what
// stays: as of a CutPolyhedron, only where corners lie is rounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

#include "voronoi/cut_polyhedron.hpp"

namespace tetloft::internal::voronoi {

class CutPolygon {
 public:
  struct Corner {
    Point2 point;
    double spread = 0;       // as a CutPolyhedron's corners have it
    std::uint32_t edge = 0;  // from here counter-clockwise to the next corner
  };
  /// Edges 0 to 3 of all: low x, high x, low y, high y.
  static constexpr std::uint32_t kSides = 4;

  CutPolygon(const Point2& low, const Point2& high);
  [[nodiscard]] static CutPolygon around_origin(double half) {
    return {{-half, -half}, {half, half}};
  }

  /// Keeps what is in the half-space of no slope in z; the edge on its line has the next number,
  /// whether anything of it is there or not.
  void cut(const HalfSpace& half_space);

  /// Counter-clockwise.
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  [[nodiscard]] double area() const;
  /// Is anything left of the rectangle's sides?
  [[nodiscard]] bool reaches_box() const;

 private:
  [[nodiscard]] Corner crossing(std::size_t kept, std::size_t cut_off, std::uint32_t edge) const;

  std::vector<Corner> corners_;
  std::vector<double> height_;
  std::vector<HalfSpace> lines_;  // by edge
};

}  // namespace tetloft::internal::voronoi
