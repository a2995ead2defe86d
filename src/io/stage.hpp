// The writers of io.hpp up to the last step: the file is complete, and appears when the caller
// commits it. Errors are those of the writers; lack of room shows at finish().
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "io/pending_file.hpp"

namespace tetloft::io {

[[nodiscard]] Result<PendingFile> stage_vtu(const std::string& path, const Model& model,
                                            Encoding encoding = Encoding::binary,
                                            TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<PendingFile> stage_vtu(const std::string& path,
                                            const std::vector<Point3>& points,
                                            const std::vector<TetVertices>& tets,
                                            Encoding encoding = Encoding::binary,
                                            TemporaryWatcher* watcher = nullptr);

struct StagedSurface {
  PendingFile file;
  std::vector<Warning> warnings;  ///< as of write_surface
};
[[nodiscard]] Result<StagedSurface> stage_surface(const std::string& path, const Model& model,
                                                  Encoding encoding = Encoding::binary,
                                                  TemporaryWatcher* watcher = nullptr);

[[nodiscard]] Result<PendingFile> stage_lines(const std::string& path, const LineSet& lines,
                                              Encoding encoding = Encoding::binary,
                                              TemporaryWatcher* watcher = nullptr);

[[nodiscard]] Result<PendingFile> stage_file(const std::string& path, std::string_view bytes,
                                             TemporaryWatcher* watcher = nullptr);

}  // namespace tetloft::io
