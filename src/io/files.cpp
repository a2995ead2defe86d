// Reading whole files; writing through a temporary and a rename.
#include "io/files.hpp"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <tetloft/io.hpp>

#include "core/check.hpp"

namespace tetloft {

namespace io {

namespace {

namespace fs = std::filesystem;

std::string reason(int error_number) {
  return error_number == 0 ? std::string("unknown reason")
                           : std::generic_category().message(error_number);
}

Error io_error(const std::string& path, const std::string& message) {
  Error error{ErrorCode::io, message, {}};
  error.where.file = path;
  return error;
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return io_error(path, "cannot be opened: " + reason(errno));
  // The size is a hint only: pipes have none, and a file may change while it is read.
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  std::error_code ignored;
  const auto hint = fs::is_regular_file(path, ignored) ? fs::file_size(path, ignored) : 0;
  std::string bytes;
  int failure = 0;
  try {
    if (!ignored) bytes.reserve(static_cast<std::size_t>(hint) + 1);
    for (std::size_t size = 0;;) {
      const std::size_t room = bytes.capacity() > size ? bytes.capacity() - size : kChunk;
      bytes.resize(size + room);
      errno = 0;
      const std::size_t got = std::fread(bytes.data() + size, 1, room, file);
      size += got;
      if (got < room) {
        bytes.resize(size);
        if (std::ferror(file) != 0) failure = errno == 0 ? EIO : errno;
        break;
      }
    }
  } catch (...) {
    std::fclose(file);
    throw;
  }
  std::fclose(file);
  if (failure != 0) return io_error(path, "cannot be read: " + reason(failure));
  return bytes;
}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace io

}  // namespace tetloft
