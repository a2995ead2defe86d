// Which lattice would merge coordinates that differ in their last bits.
#pragma once

#include <tetloft/conforming_section.hpp>

namespace tetloft::internal {

/// The most bits, from 12 to 40, of a lattice (snap()) over the coordinates of two sections that is
/// 16 times coarser than differences as of rounding among x or among y and finer than half of all
/// other differences; 0 if there is none, or no such small difference.
[[nodiscard]] int merging_bits(const ConformingSection& lower, const ConformingSection& upper);

}  // namespace tetloft::internal
