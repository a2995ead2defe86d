// Sections over the solid, as small drawings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/subject.hpp"

namespace tetloft::internal::report {

/// Positions of `shown` of `count` things: the first, the last, and evenly between.
[[nodiscard]] std::vector<std::size_t> evenly(std::size_t count, std::size_t shown);

/// Two figures for the page: the sections, and half way to the next ones; of a model that tells no
/// sections, cuts at even heights.
[[nodiscard]] std::string section_panels(const Subject& subject, std::size_t shown);

}  // namespace tetloft::internal::report
