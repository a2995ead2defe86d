// Files of bytes that the caller has.
#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/stage.hpp"

namespace tetloft {

Result<io::PendingFile> io::stage_file(const std::string& path, std::string_view bytes,
                                       TemporaryWatcher* watcher) {
  return guard_internal([&]() -> Result<PendingFile> {
    PendingFile file(path, watcher);
    file.append(bytes);
    return finished(std::move(file));
  });
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  return io::committed(io::stage_file(path, bytes));
}

}  // namespace tetloft
