// Bytes of memory and of files, read in pieces.
#include "io/bytes/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

class FileBytes final : public ByteSource {
 public:
  FileBytes(int descriptor, std::uint64_t size, std::string path)
      : descriptor_(descriptor), size_(size), path_(std::move(path)) {}
  ~FileBytes() override { close(descriptor_); }
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] Result<std::size_t> read_at(std::uint64_t offset,
                                            std::span<char> to) const override {
    std::size_t done = 0;
    while (done < to.size() && offset + done < size_) {
      const ssize_t got =
          pread(descriptor_, to.data() + done, to.size() - done, static_cast<off_t>(offset + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return io_error(path_, "cannot be read", errno);
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  int descriptor_;
  std::uint64_t size_;
  std::string path_;
};

}  // namespace

Result<std::size_t> MemoryBytes::read_at(std::uint64_t offset, std::span<char> to) const {
  if (offset >= bytes_.size()) return std::size_t{0};
  const std::string_view rest = bytes_.substr(static_cast<std::size_t>(offset), to.size());
  std::copy(rest.begin(), rest.end(), to.begin());
  return rest.size();
}

Result<std::unique_ptr<ByteSource>> open_bytes(const std::string& path) {
  struct stat status {};
  // A pipe must not be opened twice: what is no regular file is left to who reads it whole.
  if (stat(path.c_str(), &status) != 0) return io_error(path, "cannot be opened", errno);
  if (!S_ISREG(status.st_mode)) return std::unique_ptr<ByteSource>();
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return io_error(path, "cannot be opened", errno);
  if (fstat(descriptor, &status) != 0 || status.st_size < 0) {
    const int failure = errno;
    close(descriptor);
    return io_error(path, "cannot be read", failure);
  }
  try {
    return std::unique_ptr<ByteSource>(
        new FileBytes(descriptor, static_cast<std::uint64_t>(status.st_size), path));
  } catch (...) {
    close(descriptor);
    throw;
  }
}

}  // namespace tetloft::internal::io
