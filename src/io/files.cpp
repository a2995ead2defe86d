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

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
  std::error_code code;
  if (fs::is_symlink(path, code)) target_ = fs::weakly_canonical(path, code).string();
  if (target_.empty()) target_ = path;
  const fs::file_status status = fs::status(target_, code);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    fail(fs::is_directory(status) ? "is a folder" : "is not a regular file", 0);
    return;
  }
  // Exclusive creation settles who owns a name, so that simultaneous runs do not mix.
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts && file_ == nullptr; ++i) {
    temporary_ = target_ + ".tmp" + std::to_string(i);
    errno = 0;
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ == nullptr && errno != EEXIST) break;
  }
  if (file_ == nullptr) {
    temporary_.clear();
    fail("cannot be written", errno);
  }
}

AtomicFile::~AtomicFile() { close_and_remove(); }

void AtomicFile::fail(const std::string& what, int error_number) {
  if (!failure_.empty()) return;
  failure_ = error_number == 0 ? what : what + ": " + reason(error_number);
}

void AtomicFile::close_and_remove() {
  if (file_ != nullptr) std::fclose(file_);
  file_ = nullptr;
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  temporary_.clear();
}

void AtomicFile::append(std::string_view bytes) {
  if (!ok() || bytes.empty()) return;
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    fail("cannot be written", errno == 0 ? EIO : errno);
  }
}

Result<void> AtomicFile::commit() {
  if (ok()) {
    errno = 0;
    const int closed = std::fclose(file_);
    file_ = nullptr;
    if (closed != 0) fail("cannot be written", errno == 0 ? EIO : errno);
  }
  if (ok()) {
    std::error_code code;
    fs::rename(temporary_, target_, code);
    if (code) {
      fail("cannot be replaced: " + code.message(), 0);
    } else {
      temporary_.clear();
    }
  }
  close_and_remove();
  if (!ok()) return io_error(path_, failure_);
  return {};
}

}  // namespace io

Result<void> write_file(const std::string& path, std::string_view bytes) {
  return guard_internal([&]() -> Result<void> {
    io::AtomicFile file(path);
    file.append(bytes);
    return file.commit();
  });
}

}  // namespace tetloft
