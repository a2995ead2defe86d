// What writers and readers ask of their arguments, and how they tell of which file.
#pragma once

#include <string>

#include <tetloft/io.hpp>

#include "core/enums.hpp"

namespace tetloft::internal::io {

[[nodiscard]] inline Result<void> check_encoding(Encoding encoding) {
  if (is_enumerator(encoding, Encoding::compressed)) return {};
  return Error{ErrorCode::usage, "there is no such encoding: binary, ascii or compressed", {}};
}

[[nodiscard]] inline Result<void> check_validity(Validity validity) {
  if (is_enumerator(validity, Validity::unchecked)) return {};
  return Error{ErrorCode::usage, "there is no such validity: required or unchecked", {}};
}

/// `error`, at `path` unless it names a file.
[[nodiscard]] inline Error at_file(const std::string& path, Error error) {
  if (error.where.file.empty()) error.where.file = path;
  return error;
}

}  // namespace tetloft::internal::io
