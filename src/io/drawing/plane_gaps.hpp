// What is odd about the gaps between the planes of a file.
#pragma once

#include <vector>

#include <tetloft/result.hpp>

#include "io/drawing/planes.hpp"

namespace tetloft::internal::io {

/// One warning for missing planes (gaps that are a multiple, twice or more, of the usual one up to
/// a tenth of it), with the first few named; one for gaps that differ otherwise, by more than a
/// tenth of the usual one.
[[nodiscard]] std::vector<Warning> plane_gaps(const PlanesOfLines& planes);

}  // namespace tetloft::internal::io
