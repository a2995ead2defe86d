// IMOD models as text ("imod N"): the same objects and coordinates as the binary form.
#pragma once

#include <string_view>

#include <tetloft/result.hpp>

#include "io/drawing/drawing.hpp"
#include "io/format.hpp"

namespace tetloft::internal::io {

[[nodiscard]] bool begins_as_imod_text(std::string_view bytes);

/// Error invalid_input, naming the line.
[[nodiscard]] Result<Drawing> read_imod_text(const Source& source);

}  // namespace tetloft::internal::io
