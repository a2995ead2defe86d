// What stands at an output path, links followed.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// Permissions and owner of a file.
struct FileAccess {
  mode_t mode = 0;
  uid_t owner = 0;
  gid_t group = 0;
};

struct OutputPlace {
  std::string target;            ///< the file that the path names in the end
  bool direct = false;           ///< no regular file: written as it is
  std::optional<int> inherited;  ///< the open file that /dev/stdout and the like stand for
};

/// Error io where no file can be written there: a folder, a socket, a loop of links, a file
/// without permission to write.
[[nodiscard]] Result<OutputPlace> find_output(const std::string& path);

/// Of the file at `target`; nothing where there is none.
[[nodiscard]] std::optional<FileAccess> access_of(const std::string& target);

/// The folder of a path, "." for a bare name.
[[nodiscard]] std::string folder_of(const std::string& path);

/// Error io of a file, with the system's words for `error_number` unless that is 0.
[[nodiscard]] Error io_error(const std::string& path, const std::string& message, int error_number);

}  // namespace tetloft::internal::io
