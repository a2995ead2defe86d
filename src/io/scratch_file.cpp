// On Linux a scratch file never has a name (O_TMPFILE); elsewhere it loses it as soon as it is
// open.
#include "io/scratch_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kScratchBuffer = std::size_t{1} << 16;

int open_scratch(const std::string& folder) {
#ifdef O_TMPFILE
  const int unnamed = open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
  if (unnamed >= 0) return unnamed;
#endif
  std::string name = folder + "/.tetloft.XXXXXX";
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) return descriptor;
  unlink(name.c_str());
  fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  return descriptor;
}

std::string temporary_folder() {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(ignored);
  return folder.empty() ? "/tmp" : folder.string();
}

}  // namespace

struct ScratchFile::State {
  std::string path;
  int descriptor = -1;
  std::uint64_t written = 0;
  std::string buffer;  // what follows
  std::optional<Error> failure;

  ~State() {
    if (descriptor >= 0) close(descriptor);
  }

  void fail(int error_number) {
    if (!failure) failure = io_error(path, "there is no room for temporaries", error_number);
  }

  void flush() {
    std::string_view rest = buffer;
    while (!rest.empty() && !failure) {
      errno = 0;
      const ssize_t count =
          pwrite(descriptor, rest.data(), rest.size(), static_cast<off_t>(written));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        fail(errno == 0 ? EIO : errno);
        break;
      }
      rest.remove_prefix(static_cast<std::size_t>(count));
      written += static_cast<std::uint64_t>(count);
    }
    written += rest.size();  // which is lost, but counts: what reads back finds zeros in its place
    buffer.clear();
  }
};

ScratchFile::ScratchFile(const std::string& path) : state_(std::make_unique<State>()) {
  state_->path = path;
  const Result<OutputPlace> place = find_output(path);
  if (!place) {
    state_->failure = place.error();
    return;
  }
  // What is no file, a pipe say, has no folder with room: there is none beside it to fill.
  const std::string folder = place->direct ? temporary_folder() : folder_of(place->target);
  errno = 0;
  state_->descriptor = open_scratch(folder);
  if (state_->descriptor < 0) state_->fail(errno);
}

ScratchFile::~ScratchFile() = default;
ScratchFile::ScratchFile(ScratchFile&&) noexcept = default;
ScratchFile& ScratchFile::operator=(ScratchFile&&) noexcept = default;

void ScratchFile::append(std::string_view bytes) {
  if (!ok()) return;
  state_->buffer += bytes;
  if (state_->buffer.size() >= kScratchBuffer) state_->flush();
}

const std::optional<Error>& ScratchFile::failure() const { return state_->failure; }

std::uint64_t ScratchFile::size() const { return state_->written + state_->buffer.size(); }

void ScratchFile::cut(std::uint64_t size) {
  state_->flush();
  if (!ok() || size >= state_->written) return;
  errno = 0;
  if (ftruncate(state_->descriptor, static_cast<off_t>(size)) != 0) state_->fail(errno);
  state_->written = size;
}

void ScratchFile::read(std::uint64_t at, std::span<char> bytes) {
  state_->flush();
  while (!bytes.empty() && ok()) {
    errno = 0;
    const ssize_t count =
        pread(state_->descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      state_->fail(errno == 0 ? EIO : errno);
      break;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    at += static_cast<std::uint64_t>(count);
  }
  std::fill(bytes.begin(), bytes.end(), '\0');
}

}  // namespace tetloft::internal::io
