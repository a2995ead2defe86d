// Random height fields over a lattice of triangles, linear on each, and their level lines, open
// where they leave the rectangle.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/repair.hpp>
#include <tetloft/section_stack.hpp>

#include "core/prng.hpp"

namespace tetloft::testing {

struct HeightField {
  std::size_t columns = 0;  ///< of lattice points, at least 2
  std::size_t rows = 0;
  std::vector<double> height;  ///< row by row
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return height[j * columns + i]; }
  [[nodiscard]] double width() const { return static_cast<double>(columns - 1); }
  [[nodiscard]] double height_of_frame() const { return static_cast<double>(rows - 1); }
};

/// Hills and hollows on a slope.
[[nodiscard]] HeightField random_field(internal::Prng& prng);

/// Sections of lines, whichever way they run and in any order; which of them are open.
struct LevelLines {
  SectionStack stack;
  std::vector<ContourOfSection> open;
};

/// At two to five heights between the field's least and largest; no lattice point has any of them.
[[nodiscard]] LevelLines level_lines(internal::Prng& prng, const HeightField& field);

/// The area where the field is at least as high as `level`, which no lattice point is.
[[nodiscard]] double area_above(const HeightField& field, double level);

}  // namespace tetloft::testing
