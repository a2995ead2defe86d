// Errors of files of voxels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

[[nodiscard]] inline Error volume_error(const std::string& file, const std::string& message,
                                        std::optional<std::size_t> line = {}) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = file;
  error.where.line = line;
  return error;
}

}  // namespace tetloft::internal::io
