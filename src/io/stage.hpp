// The writers of formats.hpp up to the last step: the file is complete, and appears when the caller
// commits it. Errors are those of the writers; lack of room shows when it is staged.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

#include "io/format.hpp"
#include "io/pending_file.hpp"

namespace tetloft::internal::io {

struct Staged {
  /// The file that was asked for, then its companions.
  std::vector<PendingFile> files;
  std::vector<Warning> warnings;
};

[[nodiscard]] Result<Staged> stage_stack(const std::string& path, const SectionStack& stack,
                                         const WriteOptions& options,
                                         TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<Staged> stage_model(const std::string& path, const Model& model,
                                         const WriteOptions& options,
                                         TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<Staged> stage_surface(const std::string& path, const Model& model,
                                           const WriteOptions& options,
                                           TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<Staged> stage_lines(const std::string& path, const LineSet& lines,
                                         const WriteOptions& options,
                                         TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<Staged> stage_polyhedra(const std::string& path,
                                             const PolyhedronSet& polyhedra, Encoding encoding,
                                             TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<Staged> stage_file(const std::string& path, std::string_view bytes,
                                        TemporaryWatcher* watcher = nullptr);

/// What `write` appends, at `path`. Nothing is opened before it appends. Throws what `write`
/// throws.
[[nodiscard]] Result<Staged> stage(const std::string& path, TemporaryWatcher* watcher,
                                   const std::function<Written(Sink&)>& write);
/// Commits what could be staged.
[[nodiscard]] Written committed(Result<Staged> staged);

}  // namespace tetloft::internal::io
