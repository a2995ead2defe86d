// One section of a stack, for functions that need it alone.
#pragma once

#include <cstddef>

#include <tetloft/section_stack.hpp>

namespace tetloft::internal::c {

/// Ends a body with TETLOFT_USAGE unless the stack has such a section.
const Section& section_of(const SectionStack& stack, std::size_t section);
/// The same; and it must be valid by itself, or have no contours.
const Section& valid_section_of(const SectionStack& stack, std::size_t section);

}  // namespace tetloft::internal::c
