// How one region moves from its section to the other one of its slab.
#pragma once

#include <cstdint>

#include <tetloft/point.hpp>

#include "motion/distance_samples.hpp"
#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::motion {

/// Samples of up to four sections in a row, as seen from a region of the second.
struct SectionsAround {
  const DistanceSamples* behind = nullptr;  // or none
  const DistanceSamples* here = nullptr;
  const DistanceSamples* there = nullptr;
  const DistanceSamples* beyond = nullptr;  // or none
  /// The gaps behind and beyond, by the gap between `here` and `there`.
  double back = 0, on = 0;
};

/// What displacement() reads of the samples of `here` for a region of these bounds.
[[nodiscard]] LatticeWindow window_of(const Box2& region);
/// How much farther it reads of a section `gaps` gaps away.
[[nodiscard]] std::int64_t margin_of(double gaps);

/// The displacement from `here` to `there`, of no more than a gap and half a step along each axis,
/// that fits the samples around the region best: src/motion/README.md. In lattice units, as the
/// region's bounds.
[[nodiscard]] Point2 displacement(const SectionsAround& around, const Box2& region);

}  // namespace tetloft::internal::motion
