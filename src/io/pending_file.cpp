// Writing through a temporary. On Linux the temporary has no name (O_TMPFILE) until it takes
// that of the file: in one step where nothing is there, else over a name of its own that lives
// for two system calls, because a link cannot replace a file. Signals wait meanwhile.
#include "io/pending_file.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "core/guard.hpp"
#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16;
constexpr int kNames = 1000;
constexpr mode_t kNewFile = 0666;  // less what the umask takes

// The thread's signals wait for the end of the block. None is handled or lost.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t all;
    sigfillset(&all);
    blocked_ = pthread_sigmask(SIG_SETMASK, &all, &before_) == 0;
  }
  ~SignalsWait() {
    if (blocked_) pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_{};
  bool blocked_ = false;
};

// An open descriptor by name, which linkat can give a place.
std::string name_of_descriptor(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

// A file without a name, or −1 where there are none, or where none could be named later.
int open_unnamed(const std::string& folder) {
#ifdef O_TMPFILE
  const int descriptor = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewFile);
  if (descriptor < 0) return -1;
  if (access(name_of_descriptor(descriptor).c_str(), F_OK) == 0) return descriptor;
  close(descriptor);
#else
  static_cast<void>(folder);
#endif
  return -1;
}

}  // namespace

struct PendingFile::State {
  std::string path;       // as given, for messages
  std::string target;     // links followed
  std::string temporary;  // empty while there is none with a name
  bool direct = false;
  bool existed = false;  // at commit()
  int descriptor = -1;
  std::string buffer;
  std::optional<Error> failure;  // the first one
  TemporaryWatcher* watcher = nullptr;

  ~State() { discard(); }

  void fail(const std::string& message, int error_number) {
    if (!failure) failure = io_error(path, message, error_number);
  }

  void open_place(Waiting waiting) {
    Result<OutputPlace> place = find_output(path);
    if (!place) {
      failure = place.error();
      return;
    }
    target = place->target;
    direct = place->direct;
    if (direct) {
      errno = 0;
      descriptor = place->inherited ? fcntl(*place->inherited, F_DUPFD_CLOEXEC, 0)
                                    : open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
      if (descriptor < 0) fail("cannot be written", errno);
      return;
    }
    if (waiting == Waiting::unnamed) descriptor = open_unnamed(folder_of(target));
    if (descriptor < 0) open_named();
  }

  // Exclusive creation settles who owns a name, so that simultaneous runs do not mix.
  void open_named() {
    const SignalsWait wait;
    for (int i = 0; i < kNames; ++i) {
      std::string name = target + ".tmp" + std::to_string(i);
      errno = 0;
      descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFile);
      if (descriptor >= 0) {
        own(std::move(name));
        return;
      }
      if (errno != EEXIST) break;
    }
    fail("cannot be written", errno);
  }

  void own(std::string name) {
    temporary = std::move(name);
    if (watcher != nullptr) watcher->created(temporary);
  }

  void disown() {
    if (watcher != nullptr) watcher->gone(temporary);
    temporary.clear();
  }

  // Writes the buffer out.
  void flush() {
    std::string_view rest = buffer;
    while (!rest.empty() && !failure) {
      errno = 0;
      const ssize_t written = write(descriptor, rest.data(), rest.size());
      if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot be written", errno == 0 ? EIO : errno);
    }
    buffer.clear();
  }

  void close_descriptor() {
    if (descriptor < 0) return;
    errno = 0;
    if (close(descriptor) != 0 && errno != EINTR) fail("cannot be written", errno);
    descriptor = -1;
  }

  // A named file is closed before it is renamed: some systems report lack of room only then.
  void finish() {
    if (failure || descriptor < 0) return;
    flush();
    if (direct || temporary.empty()) return;
    keep_access();
    close_descriptor();
  }

  // The earlier file's owner and permissions. Owner first: changing it clears permissions.
  void keep_access() {
    const auto earlier = access_of(target);
    if (!earlier) return;
    const auto now = access_of(temporary.empty() ? name_of_descriptor(descriptor) : temporary);
    if (!now || now->owner != earlier->owner || now->group != earlier->group) {
      if (fchown(descriptor, earlier->owner, earlier->group) != 0) errno = 0;  // as allowed
    }
    if (fchmod(descriptor, earlier->mode) != 0) fail("cannot take the earlier permissions", errno);
  }

  // Gives the unnamed file the target's name; where that is taken, one of its own to rename.
  void link_unnamed() {
    const std::string from = name_of_descriptor(descriptor);
    const auto link = [&](const std::string& name) {
      errno = 0;
      return linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (!existed && link(target)) return;
    for (int i = 0; i < kNames; ++i) {
      std::string name = target + ".tmp" + std::to_string(i);
      if (link(name)) {
        own(std::move(name));
        return;
      }
      if (errno != EEXIST) break;
    }
    fail("cannot be replaced", errno);
  }

  void commit() {
    finish();
    if (!failure && !direct) {
      const SignalsWait wait;
      existed = access_of(target).has_value();
      if (temporary.empty()) {
        keep_access();
        if (!failure) link_unnamed();
      }
      if (!failure && !temporary.empty()) {
        errno = 0;
        if (std::rename(temporary.c_str(), target.c_str()) != 0) {
          fail("cannot be replaced", errno);
        } else {
          disown();
        }
      }
    }
    close_descriptor();
    discard();
  }

  void discard() {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
    if (temporary.empty()) return;
    const SignalsWait wait;
    unlink(temporary.c_str());
    disown();
  }
};

PendingFile::PendingFile(const std::string& path, TemporaryWatcher* watcher, Waiting waiting)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->watcher = watcher;
  state_->open_place(waiting);
}

PendingFile::~PendingFile() = default;
PendingFile::PendingFile(PendingFile&&) noexcept = default;
PendingFile& PendingFile::operator=(PendingFile&&) noexcept = default;

void PendingFile::append(std::string_view bytes) {
  if (!ok()) return;
  state_->buffer += bytes;
  if (state_->buffer.size() >= kBuffer) state_->flush();
}

bool PendingFile::ok() const { return !state_->failure; }

const std::string& PendingFile::path() const { return state_->path; }

Result<void> PendingFile::finish() {
  return guard_internal([&]() -> Result<void> {
    state_->finish();
    if (state_->failure) return *state_->failure;
    return {};
  });
}

Result<void> PendingFile::commit() {
  return guard_internal([&]() -> Result<void> {
    state_->commit();
    if (state_->failure) return *state_->failure;
    return {};
  });
}

Result<void> commit_all(std::vector<PendingFile>& files) {
  for (PendingFile& file : files) {
    if (Result<void> finished = file.finish(); !finished) return finished;
  }
  std::vector<std::string> appeared;
  for (PendingFile& file : files) {
    const Result<OutputPlace> place = find_output(file.path());
    const bool fresh = place.ok() && !place->direct && !access_of(place->target);
    if (Result<void> committed = file.commit(); !committed) {
      for (const std::string& name : appeared) unlink(name.c_str());
      return committed;
    }
    if (fresh) appeared.push_back(place->target);
  }
  return {};
}

}  // namespace tetloft::internal::io
