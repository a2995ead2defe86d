// Files that appear complete or not at all, in two steps: first all bytes reach the system,
// then a name. Between the two a caller may still change its mind, or finish other files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/sink.hpp"

namespace tetloft::internal::io {

/// Told which temporaries have a name, so that a program which a signal ends can remove them.
/// The calls come with the thread's signals blocked: a name is known before it can be left.
class TemporaryWatcher {
 public:
  virtual ~TemporaryWatcher() = default;
  virtual void created(const std::string& name) = 0;
  virtual void gone(const std::string& name) = 0;
};

/// Where the bytes wait. An unnamed temporary vanishes with the process, whatever ends it; a
/// named one is taken where the file system has no unnamed ones.
enum class Waiting : std::uint8_t { unnamed, named };

/// A file under construction, to appear at `path`:
/// - Symbolic links are followed, dangling ones too: the file they name is written.
/// - A file that is there keeps its permissions, and its owner where the system allows that.
/// - Pipes, terminals and other character devices, and what a link to /dev/stdout stands for,
///   are written directly, as bytes come; everything else appears with commit().
/// Without a successful commit() no file is left behind, and what was at `path` is untouched.
class PendingFile final : public Sink {
 public:
  explicit PendingFile(const std::string& path, TemporaryWatcher* watcher = nullptr,
                       Waiting waiting = Waiting::unnamed);
  ~PendingFile() override;
  PendingFile(PendingFile&&) noexcept;
  PendingFile& operator=(PendingFile&&) noexcept;

  /// Appends; a failure is remembered and told by finish() and commit().
  void append(std::string_view bytes) override;
  /// Whether nothing has failed so far: lets long writers stop early.
  [[nodiscard]] bool ok() const override;
  /// All bytes are with the system: nothing that can fail for want of room is left to commit().
  [[nodiscard]] Result<void> finish();
  /// finish(), and the file appears, in place of an earlier one.
  [[nodiscard]] Result<void> commit();

  /// As given to the constructor.
  [[nodiscard]] const std::string& path() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All of them or none: every file is finished before the first appears. Should one then not
/// take its name, those that appeared where nothing was are removed again.
[[nodiscard]] Result<void> commit_all(std::vector<PendingFile>& files);

}  // namespace tetloft::internal::io
