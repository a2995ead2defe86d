// Periodic sets, and what is true of all results.
#pragma once

#include <string>
#include <vector>

#include <tetloft/periodic.hpp>

#include "support/value_of.hpp"

namespace tetloft::test {

struct NamedBox {
  std::string name;
  PeriodicBox box;
};
/// Orthorhombic, triclinic, left-handed, turned, thin, and skewed by a thousand and a million.
[[nodiscard]] std::vector<NamedBox> periodic_boxes();
[[nodiscard]] double volume_of(const PeriodicBox& box);
[[nodiscard]] Point3 shifted(const Point3& p, const LatticeShift& shift, const PeriodicBox& box);
/// At coordinates in the box's vectors in [0, 1), multiples of 2^-bits.
[[nodiscard]] std::vector<Point3> points_in(const PeriodicBox& box, std::size_t n,
                                            std::uint64_t seed, int bits = 53);

/// Volumes sum to the box's; faces are mutual, closed, and lie halfway to their neighbours.
void expect_sound(const PeriodicVoronoi3& diagram, const std::vector<Point3>& points,
                  const PeriodicBox& box);

}  // namespace tetloft::test
