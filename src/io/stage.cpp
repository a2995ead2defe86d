#include "io/stage.hpp"

#include <optional>
#include <utility>

#include "core/guard.hpp"

namespace tetloft::internal::io {

namespace {

// A writer may refuse before its first byte: until then there is no file, and no one at the other
// end of a pipe is waited for.
class LateFile final : public Sink {
 public:
  LateFile(const std::string& path, TemporaryWatcher* watcher) : path_(path), watcher_(watcher) {}

  void append(std::string_view bytes) override { file().append(bytes); }
  [[nodiscard]] bool ok() const override { return !file_ || file_->ok(); }
  PendingFile& file() {
    if (!file_) file_.emplace(path_, watcher_);
    return *file_;
  }

 private:
  const std::string& path_;
  TemporaryWatcher* watcher_;
  std::optional<PendingFile> file_;
};

}  // namespace

Result<Staged> stage(const std::string& path, TemporaryWatcher* watcher,
                     const std::function<Written(Sink&)>& write) {
  LateFile late(path, watcher);
  Written warnings = write(late);
  if (!warnings) return warnings.error();
  if (Result<void> finished = late.file().finish(); !finished) return finished.error();
  Staged staged{{}, *std::move(warnings)};
  staged.files.push_back(std::move(late.file()));
  return staged;
}

Written committed(Result<Staged> staged) {
  return guard_internal([&]() -> Written {
    if (!staged) return staged.error();
    if (Result<void> done = commit_all(staged->files); !done) return done.error();
    return std::move(staged->warnings);
  });
}

}  // namespace tetloft::internal::io
