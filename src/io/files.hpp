// Whole files in, and files out that appear complete or not at all.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

namespace tetloft::io {

/// The bytes of a file. Error io, with the system's reason.
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Lower-case extension of the last path component with its dot (".vtu"), or "".
[[nodiscard]] std::string extension_of(const std::string& path);

/// A file under construction: bytes go to a temporary beside `path`, which commit() renames
/// to `path`. Without a successful commit() the temporary is removed and what was at `path`
/// before is untouched. A symbolic link is followed, so that the link survives.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends; a failure is remembered and told by commit().
  void append(std::string_view bytes);
  /// Whether nothing has failed so far: lets long writers stop early.
  [[nodiscard]] bool ok() const { return failure_.empty(); }
  [[nodiscard]] Result<void> commit();

 private:
  void fail(const std::string& what, int error_number);
  void close_and_remove();

  std::string path_;       // as given, for messages
  std::string target_;     // links followed
  std::string temporary_;  // empty while there is none
  std::FILE* file_ = nullptr;
  std::string failure_;  // the first failure; empty while all is well
};

}  // namespace tetloft::io
