// Checking output paths.
#include "cli/outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "cli/arguments.hpp"
#include "cli/file_formats.hpp"
#include "cli/repaired_output.hpp"
#include "cli/signals.hpp"
#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/formats.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

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

// The file, and what a model of its format has beside it.
std::vector<std::string> written_with(const std::string& path) {
  std::vector<std::string> all{path};
  const auto format = io::choose_writer(io::format_table(), Contents::model, path, {});
  if (!format) return all;
  const std::vector<std::string> companions = io::companion_paths(**format, path);
  all.insert(all.end(), companions.begin(), companions.end());
  return all;
}

}  // namespace

Result<void> check_output(std::string_view option, const std::string& path,
                          const std::vector<std::string_view>& extensions,
                          const std::vector<std::string>& taken) {
  const std::string extension = io::extension_of(path);
  if (!extensions.empty() &&
      std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
    return usage_error("option " + std::string(option) + ": " + io::in_quotes(path) +
                       " must end in " + list_of(extensions) + did_you_mean(extension, extensions));
  }
  for (const std::string& written : written_with(path)) {
    for (const std::string& other : taken) {
      if (!same_file(written, other)) continue;
      return usage_error("option " + std::string(option) + ": " + io::in_quotes(written) +
                         " would overwrite another file of this command, " + io::in_quotes(other));
    }
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

Result<Encoding> encoding_of(const Arguments& arguments) {
  const bool ascii = arguments.has("--ascii");
  const bool compress = arguments.has("--compress");
  if (ascii && compress) return usage_error("options --ascii and --compress exclude each other");
  return ascii ? Encoding::ascii : compress ? Encoding::compressed : Encoding::binary;
}

Result<ModelOutputs> model_outputs(const Arguments& arguments) {
  ModelOutputs outputs;
  outputs.solid = arguments.text("--output");
  outputs.surface = arguments.text("--surface");
  if (!outputs.solid && !outputs.surface) {
    return usage_error("missing option --output (-o) " + output_word("OUT", Contents::model) +
                       ", or --surface FILE");
  }
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  outputs.encoding = *encoding;
  std::vector<std::string> taken;
  for (std::size_t k = 0; k < arguments.operand_count(); ++k) taken.push_back(arguments.operand(k));
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  Result<void> checked;
  if (outputs.solid) {
    checked =
        check_output("--output (-o)", *outputs.solid, output_extensions(Contents::model), taken);
    taken.push_back(*outputs.solid);
  }
  if (checked && outputs.surface) {
    checked =
        check_output("--surface", *outputs.surface, output_extensions(Contents::surface), taken);
    taken.push_back(*outputs.surface);
  }
  if (!checked) return checked.error();
  auto repaired = repaired_output(arguments, taken);
  if (!repaired) return repaired.error();
  outputs.repaired = *std::move(repaired);
  return outputs;
}

namespace {

// Other programs have such tets; and placing points rounds them, where their planes are oblique:
// what is thinner than that turns over.
void warn_of_turned(const Model& model, Tets tets, Console& console) {
  const bool rounded = !is_exact(model.frame);
  if (tets == Tets::proven && !rounded) return;
  const auto at = [&](VertexId v) {
    return rounded ? place(model.frame, model.points[v]) : model.points[v];
  };
  std::size_t turned = 0;
  for (const TetVertices& t : model.tets) {
    if (orient3d(at(t[0]), at(t[1]), at(t[2]), at(t[3])) != Sign::positive) ++turned;
  }
  if (turned == 0) return;
  const char* const why =
      rounded ? " where the planes lie in the file: its coordinates are oblique, and rounded; the "
                "guarantees hold in those of the stack, which a .vtu keeps as stack_point"
              : ": simulations refuse such tets";
  console.warn({std::to_string(turned) + " of " + counted(model.tets.size(), "tet") +
                    (turned == 1 ? " is" : " are") + " flat or turned over" + why,
                {}});
}

}  // namespace

Result<void> take_staged(Result<io::Staged> staged, StagedFiles& files, Console& console) {
  if (!staged) return staged.error();
  for (const Warning& warning : staged->warnings) console.warn(warning);
  std::move(staged->files.begin(), staged->files.end(), std::back_inserter(files));
  return {};
}

Result<StagedFiles> stage_model(const Model& model, const ModelOutputs& outputs, Console& console,
                                Tets tets) {
  warn_of_turned(model, tets, console);
  StagedFiles files;
  const auto stage = [&](const std::optional<std::string>& path, auto writer) -> Result<void> {
    if (!path) return {};
    return take_staged(
        writer(*path, model, WriteOptions{outputs.encoding, outputs.format}, temporary_watcher()),
        files, console);
  };
  Result<void> staged = stage(outputs.surface, io::stage_surface);
  if (staged) staged = stage(outputs.solid, io::stage_model);
  if (!staged) return staged.error();
  return files;
}

std::vector<std::string> paths_of(const ModelOutputs& outputs) {
  std::vector<std::string> paths;
  if (outputs.solid) paths = written_with(*outputs.solid);
  if (outputs.surface) paths.push_back(*outputs.surface);
  if (outputs.repaired) paths.push_back(*outputs.repaired);
  return paths;
}

std::vector<std::string> paths_of(const StagedFiles& files) {
  std::vector<std::string> paths;
  for (const io::PendingFile& file : files) paths.push_back(file.path());
  return paths;
}

std::string written_line(const std::vector<std::string>& paths) {
  std::string files;
  for (const std::string& path : paths) files += (files.empty() ? "" : ", ") + printable(path);
  return "written: " + files + '\n';
}

Result<void> deliver_with(StagedFiles& files, const std::string& result, Console& console) {
  if (!result.empty()) {
    Result<void> told = console.deliver(result);
    if (!told) return told;
  }
  return io::commit_all(files);
}

}  // namespace tetloft::cli
