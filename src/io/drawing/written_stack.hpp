// What writers of drawings ask of a stack.
#pragma once

#include <string_view>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

#include "io/format.hpp"

namespace tetloft::internal::io {

/// A file of contours has no sections without: a warning where the stack has some. Error
/// invalid_input where it is not valid.
[[nodiscard]] Result<std::vector<Warning>> check_written(const SectionStack& stack,
                                                         const Target& target);

/// Of formats that know planes z = const alone, `format`: a warning where the planes of the stack
/// lie in other directions.
[[nodiscard]] std::vector<Warning> warnings_of_turned(const SectionStack& stack,
                                                      const Target& target,
                                                      std::string_view format);

/// Each outer contour and the holes right within it, in the order of the contours.
[[nodiscard]] std::vector<std::vector<ContourId>> rings_by_outer(const Nesting& nesting);

}  // namespace tetloft::internal::io
