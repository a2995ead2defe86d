// Checking output paths.
#include "cli/outputs.hpp"

#include <cstdio>

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

Result<ModelOutputs> model_outputs(const Arguments& arguments) {
  ModelOutputs outputs;
  const auto solid = arguments.text("--output");
  if (!solid) return usage_error("missing option --output (-o) OUT.vtu");
  outputs.solid = *solid;
  outputs.surface = arguments.text("--surface");
  if (arguments.has("--ascii")) outputs.encoding = Encoding::ascii;
  std::vector<std::string> taken{arguments.operand(0)};
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  Result<void> checked = check_output("--output (-o)", outputs.solid, {".vtu"}, taken);
  if (checked && outputs.surface) {
    taken.push_back(outputs.solid);
    checked = check_output("--surface", *outputs.surface, {".obj", ".ply", ".vtp", ".stl"}, taken);
  }
  if (!checked) return checked.error();
  return outputs;
}

// The surface first: it is the one that can fail for what it is (coordinates beyond STL),
// and the solid at the same place must then stay as it was.
Result<void> write_model(const Model& model, const ModelOutputs& outputs, Console& console) {
  if (outputs.surface) {
    const auto warnings = write_surface(*outputs.surface, model, outputs.encoding);
    if (!warnings) return warnings.error();
    for (const Warning& warning : *warnings) console.warn(warning);
  }
  Result<void> written = write_vtu(outputs.solid, model, outputs.encoding);
  // A command that fails leaves no output, also where one of two files was fine.
  if (!written && outputs.surface) std::remove(outputs.surface->c_str());
  return written;
}

std::string describe(const ModelOutputs& outputs) {
  return "written: " + outputs.solid + (outputs.surface ? ", " + *outputs.surface : "") + '\n';
}

}  // namespace tetloft::cli
