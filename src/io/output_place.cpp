// Following links by hand: the system's own functions stop at a link that dangles.
#include "io/output_place.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

namespace fs = std::filesystem;

// As many as Linux follows.
constexpr int kLongestChain = 40;

constexpr const char* kUnwritable = "cannot be written";

// The descriptor that a path such as /proc/self/fd/1 names, where /dev/stdout leads.
std::optional<int> own_descriptor(const std::string& path) {
  const auto number = parse_integer(fs::path(path).filename().string());
  if (!number || *number < 0 || *number > INT_MAX) return std::nullopt;
  const std::unique_ptr<char, void (*)(void*)> folder(::realpath(folder_of(path).c_str(), nullptr),
                                                      std::free);
  if (!folder) return std::nullopt;
  const std::string own = "/proc/" + std::to_string(getpid()) + "/fd";
  const int descriptor = static_cast<int>(*number);
  if (own != folder.get() || fcntl(descriptor, F_GETFD) < 0) return std::nullopt;
  return descriptor;
}

// One step along a link.
Result<std::string> link_target(const std::string& link, const std::string& path) {
  std::error_code code;
  const fs::path target = fs::read_symlink(link, code);
  if (code) return io_error(path, kUnwritable, code.value());
  return target.is_absolute() ? target.string() : (fs::path(folder_of(link)) / target).string();
}

}  // namespace

Error io_error(const std::string& path, const std::string& message, int error_number) {
  Error error{ErrorCode::io, message, {}};
  if (error_number != 0) error.message += ": " + std::generic_category().message(error_number);
  error.where.file = path;
  return error;
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::optional<FileAccess> access_of(const std::string& target) {
  struct stat status {};
  if (lstat(target.c_str(), &status) != 0) return std::nullopt;
  return FileAccess{status.st_mode & 07777U, status.st_uid, status.st_gid};
}

Result<OutputPlace> find_output(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return io_error(path, "cannot be written: it is a folder", 0);
    if (S_ISBLK(status.st_mode) || S_ISSOCK(status.st_mode)) {
      return io_error(path, "cannot be written: it is not a regular file", 0);
    }
    if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
      return io_error(path, kUnwritable, errno);
    }
  }
  const bool device = S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode);
  std::string at = path;
  for (int links = 0; links <= kLongestChain; ++links) {
    if (lstat(at.c_str(), &status) != 0) {
      if (errno != ENOENT) return io_error(path, kUnwritable, errno);
      return OutputPlace{device ? path : at, device, {}};
    }
    if (!S_ISLNK(status.st_mode)) return OutputPlace{at, device, {}};
    if (const auto descriptor = own_descriptor(at)) return OutputPlace{at, true, descriptor};
    Result<std::string> next = link_target(at, path);
    if (!next) return next.error();
    at = *std::move(next);
  }
  return io_error(path, kUnwritable, ELOOP);
}

}  // namespace tetloft::internal::io
