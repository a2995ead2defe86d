// The colours of pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tetloft/model.hpp>

#include "model/component_colour.hpp"

namespace tetloft::internal::render {

using internal::component_colour;
using internal::Rgb;

[[nodiscard]] Rgb kind_colour(TetKind kind);
/// Of an Evidence, as a number, or of none.
[[nodiscard]] Rgb evidence_colour(std::size_t evidence);
/// From the first slab, 0, to the last, 1.
[[nodiscard]] Rgb slab_colour(double t);
/// From flat, 0, to kBestDihedral degrees or more, 1.
[[nodiscard]] Rgb dihedral_colour(double t);
/// The smallest dihedral angle of a regular tet, arccos(1/3), is 70.53 degrees.
inline constexpr double kBestDihedral = 70.53;

/// "#dec498".
[[nodiscard]] std::string hex(const Rgb& colour);

inline constexpr Rgb kContourColour{32, 36, 44};

}  // namespace tetloft::internal::render
