// Sections times a power of two.
#pragma once

#include <tetloft/section_stack.hpp>

#include "core/unit_of_length.hpp"

namespace tetloft::internal::sections {

/// Of x and y; 0 where there are none.
[[nodiscard]] double largest_magnitude(const Section& section);
/// Makes all its coordinates numbers of the unit.
void include(const Section& section, UnitOfLength& unit);
/// The unit of all coordinates.
[[nodiscard]] UnitOfLength unit_of(const SectionStack& stack);

/// All coordinates times 2^exponent.
[[nodiscard]] SectionStack scaled(const SectionStack& stack, int exponent);
[[nodiscard]] Section scaled(const Section& section, int exponent);
/// The same of the contours; z stays as it is.
[[nodiscard]] Section scaled_in_plane(const Section& section, int exponent);

}  // namespace tetloft::internal::sections
