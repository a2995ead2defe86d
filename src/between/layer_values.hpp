// The values of a class in a plane between two sections, from its distances in four.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>

#include "between/distance_field.hpp"
#include "between/section_cubic.hpp"
#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

/// Between two sections a class grows beyond both by less than this part of the reach.
inline constexpr double kOvergrowth = 0.4;

/// What lies around a slab, in steps.
struct FieldsAround {
  std::array<DistanceField, 4> field;
  std::array<double, 4> share{};  ///< heights, in gaps
  Beside beside;
  double reach = 0;  ///< what is far in all fields
};

/// Samples on an outline count as this far from it, in steps: no value is 0.
inline constexpr double kOnOutline = 0x1p-30;
[[nodiscard]] inline double never_zero(double value) { return value == 0 ? kOnOutline : value; }

/// How the samples of a window move from the lower to the upper plane.
class WindowMotion {
 public:
  struct Tile {
    motion::LatticeWindow window;
    Box2 motions;  ///< of its samples
  };
  WindowMotion(const motion::LatticeWindow& window, std::vector<Point2> of_samples);

  [[nodiscard]] const std::vector<Point2>& of_samples() const& { return of_samples_; }
  [[nodiscard]] std::vector<Point2> of_samples() && { return std::move(of_samples_); }
  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }

 private:
  std::vector<Point2> of_samples_;
  std::vector<Tile> tiles_;
};

/// The values at the samples of the window, at this share of the gap; `motion` is null if nothing
/// moves.
[[nodiscard]] std::vector<double> layer_values(const FieldsAround& around,
                                               const motion::LatticeWindow& window,
                                               const WindowMotion* motion, double share);

}  // namespace tetloft::internal::between
