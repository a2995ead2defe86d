// Whole files in.
#pragma once

#include <string>

#include <tetloft/result.hpp>

namespace tetloft::io {

/// The bytes of a file. Error io, with the system's reason.
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Lower-case extension of the last path component with its dot (".vtu"), or "".
[[nodiscard]] std::string extension_of(const std::string& path);

}  // namespace tetloft::io
