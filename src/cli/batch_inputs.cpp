// See batch_inputs.hpp.
#include "cli/batch_inputs.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/console.hpp"
#include "cli/read_options.hpp"
#include "core/text.hpp"
#include "io/drawing/text_lines.hpp"
#include "io/files.hpp"
#include "io/formats.hpp"
#include "io/numbers.hpp"
#include "io/output_place.hpp"
#include "io/stack_files.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListExtension = ".list";

bool is_list(const Arguments& arguments) {
  return arguments.has("--list") || io::extension_of(arguments.operand(0)) == kListExtension;
}

Result<BatchInputs> stacks_of_folder(const std::string& folder, const std::string& format) {
  std::error_code code;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, code); !code && at != fs::directory_iterator();
       at.increment(code)) {
    std::error_code ignored;
    const std::string name = at->path().filename().string();
    const bool passed_over = name.starts_with('.') || name == kBatchLog;
    if (!passed_over && at->is_regular_file(ignored)) files.push_back(at->path());
  }
  if (code) return io::io_error(folder, "cannot be read", code.value());
  std::sort(files.begin(), files.end());
  BatchInputs inputs;
  std::set<fs::path> data;
  for (const fs::path& file : files) {
    if (!io::is_stack_file(file.string(), format)) {
      inputs.left_out.push_back(file.string());
      continue;
    }
    inputs.stacks.push_back(file.string());
    const std::vector<std::string> all = io::stack_files(file.string(), format);
    for (std::size_t i = 1; i < all.size(); ++i) data.insert(fs::weakly_canonical(all[i], code));
  }
  const auto is_data = [&](const std::string& file) {
    return data.count(fs::weakly_canonical(file, code)) != 0;
  };
  std::erase_if(inputs.stacks, is_data);
  std::erase_if(inputs.left_out, is_data);
  if (!inputs.stacks.empty()) return inputs;
  return in_file({ErrorCode::invalid_input,
                  "no file in this folder is recognised as a stack (folders in it are not entered)",
                  {}},
                 folder);
}

Result<BatchInputs> stacks_of_list(const std::string& list) {
  const Result<std::string> bytes = io::read_file(input_path(list));
  if (!bytes) return bytes.error();
  BatchInputs inputs;
  std::map<std::string, std::size_t> lines;  // where each path stands
  std::string_view left = io::without_mark(*bytes);
  for (std::size_t number = 1; !left.empty(); ++number) {
    const std::size_t end = std::min(left.find('\n'), left.size());
    std::string line(left.substr(0, end));
    left.remove_prefix(std::min(end + 1, left.size()));
    if (line.ends_with('\r')) line.pop_back();
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    const auto [known, added] = lines.emplace(line, number);
    if (!added) {
      Error error{
          ErrorCode::invalid_input,
          io::in_quotes(line) + " stands in line " + std::to_string(known->second) + " already",
          {}};
      error.where.file = list;
      error.where.line = number;
      return error;
    }
    inputs.stacks.push_back(std::move(line));
  }
  if (!inputs.stacks.empty()) return inputs;
  return in_file({ErrorCode::invalid_input, "the list names no stack", {}}, list);
}

// Less the longest extension that stacks are read by, or else the one that it has.
std::string stem_of(const fs::path& file) {
  std::string name = file.filename().string();
  std::size_t longest = 0;
  for (const io::Format* format : io::format_table()) {
    if (!io::reads(*format, Contents::stack)) continue;
    longest = std::max(longest, io::extension_in(*format, name).size());
  }
  if (longest == 0) return file.stem().string();
  name.resize(name.size() - longest);
  return name;
}

// "last", "before-last", … of the folders of a path, `count` of them, before its name.
std::string with_folders(const fs::path& file, std::string name, std::size_t count) {
  fs::path folder = file.parent_path();
  for (; count > 0 && folder.has_relative_path(); --count, folder = folder.parent_path()) {
    name = folder.filename().string() + '-' + name;
  }
  return name;
}

}  // namespace

bool names_many(const Arguments& arguments) {
  std::error_code code;
  return is_list(arguments) || fs::is_directory(arguments.operand(0), code);
}

Result<BatchInputs> batch_inputs(const Arguments& arguments, const std::string& format) {
  const std::string& operand = arguments.operand(0);
  return is_list(arguments) ? stacks_of_list(operand) : stacks_of_folder(operand, format);
}

Result<std::vector<std::string>> output_stems(const std::vector<std::string>& stacks) {
  std::vector<fs::path> files;
  for (const std::string& stack : stacks) files.push_back(fs::absolute(stack).lexically_normal());
  std::vector<std::string> stems(stacks.size());
  std::vector<std::size_t> unnamed(stacks.size());
  for (std::size_t i = 0; i < stacks.size(); ++i) unnamed[i] = i;
  // Those that share a name are told apart by folders, as few as can be; the last names are whole.
  constexpr std::size_t kMostFolders = 8;
  for (std::size_t folders = 0; folders <= kMostFolders && !unnamed.empty(); ++folders) {
    std::map<std::string, std::size_t> bearers;
    for (const std::size_t i : unnamed) {
      stems[i] = folders < kMostFolders ? with_folders(files[i], stem_of(files[i]), folders)
                                        : files[i].filename().string();
      ++bearers[lower_case(stems[i])];
    }
    std::erase_if(unnamed, [&](std::size_t i) { return bearers[lower_case(stems[i])] == 1; });
  }
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto [other, added] = taken.emplace(lower_case(stems[i]), i);
    if (added) continue;
    return usage_error("the solids of " + io::in_quotes(stacks[other->second]) + " and " +
                       io::in_quotes(stacks[i]) + " would have one name, " +
                       io::in_quotes(stems[i]) + ": make them in two folders");
  }
  return stems;
}

}  // namespace tetloft::cli
