// See batch_request.hpp.
#include "cli/batch_request.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/batch_inputs.hpp"
#include "cli/batch_log.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "io/output_place.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

namespace fs = std::filesystem;

// They name one file, or contours of one stack.
constexpr std::array<std::string_view, 6> kOfOne{"--surface", "--repaired", "--labels",
                                                 "--plan",    "--slabs",    "--stream"};
// They say where, how fast and how loud, and nothing about a solid.
constexpr std::array<std::string_view, 7> kOfNoSolid{"--output", "--threads", "--json", "--quiet",
                                                     "--help",   "--list",    "--log"};

Result<void> check_of_many(const Arguments& arguments) {
  for (const std::string_view option : kOfOne) {
    if (!arguments.has(option)) continue;
    return usage_error("option " + std::string(option) + " is of one stack, and " +
                       io::in_quotes(arguments.operand(0)) + " stands for many");
  }
  const auto method = arguments.choice("--method");
  if (!method) return method.error();
  if (method->value_or(0) != 0) return usage_error("--method geiger takes one stack at a time");
  return {};
}

std::string digest_of_options(const Arguments& arguments, const std::vector<Option>& options) {
  std::set<std::string> given;
  for (const Option& option : options) {
    const bool plays =
        std::find(kOfNoSolid.begin(), kOfNoSolid.end(), option.name) == kOfNoSolid.end();
    const auto value = arguments.text(option.name);
    if (plays && value) given.insert(option.name + '=' + *value + '\n');
  }
  std::string text;
  for (const std::string& line : given) text += line;
  return digest_of(text);
}

bool names_model(const std::string& path) {
  const std::string extension = io::extension_of(path);
  for (const Contents contents : {Contents::model, Contents::surface}) {
    const auto all = output_extensions(contents);
    if (std::find(all.begin(), all.end(), extension) != all.end()) return true;
  }
  return false;
}

// It is there, or can be made.
Result<void> check_folder(const std::string& folder) {
  std::error_code code;
  if (fs::is_directory(folder, code)) {
    return check_output("--output (-o)", (fs::path(folder) / kBatchLog).string(), {}, {});
  }
  // A name for one solid is more likely a folder taken for a file than the name of a folder.
  if (fs::exists(folder, code) || names_model(folder)) {
    return usage_error("option --output (-o): " + io::in_quotes(folder) +
                       " is no folder, which the solids of many stacks need");
  }
  return check_output("--output (-o)", folder, {}, {});
}

}  // namespace

std::vector<Option> batch_options() {
  const auto names = model_targets();
  return {
      {"--list", "",
       "IN is a text file that names stacks, a path in each line (# begins a comment), as every "
       "IN.list is: OUT is a folder, as for a folder IN"},
      {"--to",
       "NAME",
       "of many stacks: the format of each solid, or boundary (default vtu)",
       {},
       {names.begin(), names.end()}},
      {"--log", "FILE",
       "of many stacks: the log, by which what is done is known (default: tetloft.jsonl in the "
       "folder OUT)"}};
}

Result<void> check_no_batch_options(const Arguments& arguments) {
  for (const char* option : {"--to", "--log"}) {
    if (!arguments.has(option)) continue;
    return usage_error(std::string("option ") + option +
                       " is of many stacks, a folder or a list of them, and one is given");
  }
  return {};
}

fs::path place_of(const std::string& path) {
  std::error_code code;
  return fs::weakly_canonical(path, code);
}

Result<BatchRequest> batch_request_of(const Arguments& arguments,
                                      const std::vector<Option>& options, Console& console) {
  if (Result<void> fine = check_of_many(arguments); !fine) return fine.error();
  const auto folder = arguments.text("--output");
  if (!folder) return usage_error("missing option --output (-o) FOLDER");
  Result<ReconstructRequest> request = solid_request_of(arguments, console);
  if (!request) return request.error();
  if (request->preparation.read.structure == kAllStructures) {
    return usage_error("of many files one structure each is made: name it with --roi or --label");
  }
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  request->outputs.encoding = *encoding;
  const auto to = arguments.choice("--to");
  if (!to) return to.error();
  request->outputs.format = *to ? std::string(model_targets()[**to]) : "vtu";
  BatchRequest batch;
  for (const FormatInfo& format : formats()) {
    if (format.name == request->outputs.format) batch.extension = format.extensions.front();
  }
  batch.solids = writes_solid({}, request->outputs.format);
  batch.folder = *folder;
  while (batch.folder.size() > 1 && batch.folder.back() == '/') batch.folder.pop_back();
  Result<void> fine = check_folder(batch.folder);
  batch.log = (fs::path(batch.folder) / kBatchLog).string();
  if (const auto log = arguments.text("--log")) {
    batch.log = *log;
    // The folder of the solids may be one that is made later.
    const bool beside = place_of(io::folder_of(*log)) == place_of(batch.folder);
    if (fine && !beside) fine = check_output("--log", *log, {}, {arguments.operand(0)});
  }
  if (!fine) return fine.error();
  batch.digest = digest_of_options(arguments, options);
  batch.request = *std::move(request);
  return batch;
}

}  // namespace tetloft::cli
