// Reading whole files, up to a size that is said.
#include "io/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "core/text.hpp"
#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// Reads until `room` bytes more are there or the file ends; the system's error number, or 0.
int read_up_to(int descriptor, std::size_t room, std::string& bytes) {
  std::size_t size = bytes.size();
  const std::size_t goal = size + room;
  bytes.resize(goal);
  int failure = 0;
  while (size < goal) {
    const ssize_t got = read(descriptor, bytes.data() + size, goal - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) failure = errno == 0 ? EIO : errno;
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return failure;
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

// A file of known size. What is appended meanwhile is not waited for: the size bounds memory.
Result<std::string> read_regular(int descriptor, std::uint64_t size, const std::string& path,
                                 const ReadLimits& limits) {
  if (size > limits.file) {
    return io_error(path,
                    "is too large to be read: " + mebibytes(size) + ", where at most " +
                        mebibytes(limits.file) + " are",
                    0);
  }
  std::string bytes;
  const int failure = read_up_to(descriptor, static_cast<std::size_t>(size), bytes);
  if (failure != 0) return io_error(path, "cannot be read", failure);
  char more = 0;
  if (read(descriptor, &more, 1) > 0) return io_error(path, "changes while it is read", 0);
  return bytes;
}

// A pipe, a device, or a file that does not tell its size.
Result<std::string> read_stream(int descriptor, const std::string& path, const ReadLimits& limits) {
  constexpr std::size_t kFirst = std::size_t{1} << 16;
  std::string bytes;
  for (std::size_t room = kFirst;; room = bytes.size()) {
    const std::size_t before = bytes.size();
    // One byte more than the limit tells that there is more.
    room = std::min(room, static_cast<std::size_t>(limits.stream) + 1 - before);
    const int failure = read_up_to(descriptor, room, bytes);
    if (failure != 0) return io_error(path, "cannot be read", failure);
    if (bytes.size() > limits.stream) {
      return io_error(path,
                      "is a stream that goes on after " + mebibytes(limits.stream) +
                          ", the most that is read of one; save it as a file first",
                      0);
    }
    if (bytes.size() - before < room) return bytes;
  }
}

}  // namespace

Result<std::string> read_file(const std::string& path, const ReadLimits& limits) {
  errno = 0;
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  if (file.number() < 0) return io_error(path, "cannot be opened", errno);
  struct stat status {};
  if (fstat(file.number(), &status) != 0) return io_error(path, "cannot be read", errno);
  if (S_ISDIR(status.st_mode)) return io_error(path, "cannot be read: it is a folder", 0);
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    return read_regular(file.number(), static_cast<std::uint64_t>(status.st_size), path, limits);
  }
  return read_stream(file.number(), path, limits);
}

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace tetloft::internal::io
