// Stacks as CSL, labelled cross sections (csl.cpp has the form).
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// A plane a section, in the space of the file, A x + B y + C z + D = 0; a component a contour, of
/// label 1, holes with the contour around them as parent. Sections without contours are left out,
/// with a warning. The stack must be valid.
[[nodiscard]] Written write_csl(Sink& sink, const SectionStack& stack, const Target& target);

}  // namespace tetloft::internal::io
