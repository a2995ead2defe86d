// Checking output paths.
#include "cli/outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/arguments.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code code;
  if (fs::equivalent(a, b, code)) return true;
  // Files that do not exist yet have only their names.
  const fs::path full_a = fs::weakly_canonical(a, code);
  const fs::path full_b = fs::weakly_canonical(b, code);
  return !full_a.empty() && full_a == full_b;
}

}  // namespace

Result<void> check_output(std::string_view option, const std::string& path,
                          const std::vector<std::string_view>& extensions,
                          const std::vector<std::string>& taken) {
  const std::string extension = io::extension_of(path);
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
    std::string list;
    for (const std::string_view e : extensions) {
      if (!list.empty()) list += e == extensions.back() ? " or " : ", ";
      list += e;
    }
    return usage_error("option " + std::string(option) + ": " + io::in_quotes(path) +
                       " must end in " + list);
  }
  for (const std::string& other : taken) {
    if (!same_file(path, other)) continue;
    return usage_error("option " + std::string(option) + ": " + io::in_quotes(path) +
                       " would overwrite another file of this command, " + io::in_quotes(other));
  }
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  Error error{ErrorCode::io, {}, {}};
  error.where.file = path;
  std::error_code code;
  if (!fs::is_directory(folder, code)) {
    error.message = "cannot be written: its folder does not exist";
    return error;
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    error.message = "cannot be written: " + std::generic_category().message(errno);
    return error;
  }
  if (fs::is_directory(path, code)) {
    error.message = "cannot be written: it is a folder";
    return error;
  }
  return {};
}

}  // namespace tetloft::cli
