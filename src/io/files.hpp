// Whole files in.
#pragma once

#include <cstdint>
#include <string>

#include <tetloft/io.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// The most bytes that are read: of a file that tells its size, and of a stream (a pipe, a
/// device), which may never end.
struct ReadLimits {
  std::uint64_t file = kLargestFile;
  std::uint64_t stream = kLargestStream;
};

/// The bytes of a file. Memory: its size; of a stream, at most three times what was read. Error
/// io, with the system's reason, or where a limit is exceeded, which is named.
[[nodiscard]] Result<std::string> read_file(const std::string& path, const ReadLimits& limits = {});

/// Lower-case extension of the last path component with its dot (".vtu"), or "".
[[nodiscard]] std::string extension_of(const std::string& path);

}  // namespace tetloft::internal::io
