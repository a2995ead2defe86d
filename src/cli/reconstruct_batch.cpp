// See reconstruct_batch.hpp.
#include "cli/reconstruct_batch.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/batch_inputs.hpp"
#include "cli/batch_log.hpp"
#include "cli/file_formats.hpp"
#include "cli/many_solids.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "io/output_place.hpp"
#include "io/stack_files.hpp"

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

struct BatchRequest {
  std::string folder;  // without a slash at its end
  std::string log;
  std::string extension;
  std::string digest;          // of the options
  ReconstructRequest request;  // the outputs without paths
  bool solids = true;          // or boundaries
};

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

fs::path place_of(const std::string& path) {
  std::error_code code;
  return fs::weakly_canonical(path, code);
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

enum class Fate : std::uint8_t { untouched, done, skipped, failed };

std::string_view name_of(Fate fate) {
  return fate == Fate::done ? "done" : fate == Fate::skipped ? "skipped" : "failed";
}

struct BatchStack {
  std::string input;
  ModelOutputs outputs;
  Fate fate = Fate::untouched;
  SolidOutcome outcome = {};
};

class Batch {
 public:
  Batch(const Arguments& arguments, const BatchRequest& batch, BatchLog& log,
        std::vector<BatchStack> stacks)
      : arguments_(arguments), batch_(batch), log_(log), stacks_(std::move(stacks)) {}

  /// Error io where the log cannot be written: what is being made then ends, and no more is begun.
  Result<void> run(const std::function<void(std::size_t, std::size_t)>& progress) {
    const auto make = [&](std::size_t i, unsigned threads) { return treat(stacks_[i], threads); };
    share_out(stacks_.size(), batch_.request.options.execution.threads, make, progress);
    if (unlogged_) return *unlogged_;
    return {};
  }

  [[nodiscard]] const std::vector<BatchStack>& stacks() const { return stacks_; }
  [[nodiscard]] std::size_t count(Fate fate) const {
    return static_cast<std::size_t>(
        std::count_if(stacks_.begin(), stacks_.end(),
                      [&](const BatchStack& stack) { return stack.fate == fate; }));
  }

 private:
  // Whether the log could be written.
  bool treat(BatchStack& stack, unsigned threads) {
    const Stopwatch watch;
    BatchKey key{{}, batch_.digest, paths_of(stack.outputs)};
    Result<std::vector<FileSum>> read =
        sums_of(io::stack_files(stack.input, batch_.request.preparation.read.format));
    if (read) {
      key.read = *std::move(read);
      const std::vector<FileSum>* const done = log_.find(key);
      if (done != nullptr && still_so(key.written, *done)) {
        stack.fate = Fate::skipped;
        return true;
      }
      make(stack, threads);
    } else {
      stack.outcome.error = in_file(read.error(), stack.input);
    }
    std::vector<FileSum> written;
    if (!stack.outcome.error) {
      Result<std::vector<FileSum>> sums = sums_of(key.written);
      if (sums) written = *std::move(sums);
      if (!sums) stack.outcome.error = sums.error();
    }
    stack.fate = stack.outcome.error ? Fate::failed : Fate::done;
    return log(line_of(stack, key, written, watch.seconds()));
  }

  void make(BatchStack& stack, unsigned threads) {
    ReconstructRequest request = batch_.request;
    request.input = stack.input;
    request.outputs = stack.outputs;
    request.options.execution.threads = threads;
    request.preparation.read.execution.threads = threads;
    stack.outcome = make_solid(arguments_, request, staging_);
  }

  static std::string line_of(const BatchStack& stack, const BatchKey& key,
                             const std::vector<FileSum>& written, double seconds) {
    JsonWriter json;
    json.begin_object();
    write_key(json, key);
    json.member("input", stack.input);
    json.member("outcome", name_of(stack.fate));
    json.member("seconds", seconds);
    if (stack.outcome.error) {
      write_error(json, *stack.outcome.error);
    } else {
      write_sums(json, "written", written);
      write_counts(json, stack.outcome);
    }
    write_warnings(json, stack.outcome.warnings);
    json.end_object();
    return json.text();
  }

  bool log(const std::string& line) {
    Result<void> appended = log_.append(line);
    if (appended) return true;
    const std::scoped_lock lock(staging_);
    unlogged_ = appended.error();
    return false;
  }

  const Arguments& arguments_;
  const BatchRequest& batch_;
  BatchLog& log_;
  std::vector<BatchStack> stacks_;
  std::mutex staging_;
  std::optional<Error> unlogged_;
};

// With its outputs, none of which is an input, the list, or the log.
Result<std::vector<BatchStack>> batch_stacks(const BatchRequest& batch,
                                             const std::vector<std::string>& inputs) {
  const Result<std::vector<std::string>> stems = output_stems(inputs);
  if (!stems) return stems.error();
  std::set<fs::path> taken{place_of(batch.request.input)};
  for (const std::string& input : inputs) taken.insert(place_of(input));
  if (taken.count(place_of(batch.log)) != 0) {
    return usage_error("the log " + io::in_quotes(batch.log) + " is one of the inputs");
  }
  taken.insert(place_of(batch.log));
  std::vector<BatchStack> stacks;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    BatchStack stack{inputs[i], batch.request.outputs};
    const fs::path path = fs::path(batch.folder) / ((*stems)[i] + batch.extension);
    (batch.solids ? stack.outputs.solid : stack.outputs.surface) = path.string();
    for (const std::string& written : paths_of(stack.outputs)) {
      if (taken.insert(place_of(written)).second) continue;
      return usage_error(io::in_quotes(written) + ", the solid of " + io::in_quotes(inputs[i]) +
                         ", would overwrite another file of this command");
    }
    stacks.push_back(std::move(stack));
  }
  return stacks;
}

std::string to_json(const Batch& batch, const BatchRequest& request, const BatchInputs& inputs,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  for (const Fate fate : {Fate::done, Fate::skipped, Fate::failed}) {
    json.member(name_of(fate), batch.count(fate));
  }
  json.key("stacks");
  json.begin_array();
  for (const BatchStack& stack : batch.stacks()) {
    json.begin_object();
    json.member("input", stack.input);
    json.member("outcome", name_of(stack.fate));
    if (stack.outcome.error) {
      write_error(json, *stack.outcome.error);
    } else {
      json.member("written", paths_of(stack.outputs));
    }
    if (stack.fate == Fate::done) write_counts(json, stack.outcome);
    json.end_object();
  }
  json.end_array();
  json.member("left_out", inputs.left_out);
  json.member("log", request.log);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const Batch& batch, const BatchRequest& request, const BatchInputs& inputs) {
  std::string text = counted(batch.stacks().size(), "stack") + ": " +
                     std::to_string(batch.count(Fate::done)) + " done, " +
                     std::to_string(batch.count(Fate::skipped)) + " skipped (done before), " +
                     std::to_string(batch.count(Fate::failed)) + " failed\n";
  if (!inputs.left_out.empty()) {
    text += counted(inputs.left_out.size(), "file") + " of the folder left out: no stack\n";
  }
  return text + "written: " + printable(request.folder) + ", log: " + printable(request.log) + '\n';
}

// Warnings and failures in the order of the stacks. Returns the exit code.
int tell(const Batch& batch, Console& console) {
  int exit_code = 0;
  for (const BatchStack& stack : batch.stacks()) {
    console.warn_of(stack.input, stack.outcome.warnings);
    if (!stack.outcome.error) continue;
    console.say("error: " + to_string(*stack.outcome.error));
    if (exit_code == 0) exit_code = static_cast<int>(stack.outcome.error->code);
  }
  return exit_code;
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

Result<int> reconstruct_batch(const Arguments& arguments, const std::vector<Option>& options,
                              Console& console) {
  const Result<BatchRequest> request = batch_request_of(arguments, options, console);
  if (!request) return request.error();
  const Result<BatchInputs> inputs =
      batch_inputs(arguments, request->request.preparation.read.format);
  if (!inputs) return inputs.error();
  Result<std::vector<BatchStack>> stacks = batch_stacks(*request, inputs->stacks);
  if (!stacks) return stacks.error();
  std::error_code code;
  fs::create_directory(request->folder, code);
  if (code) return io::io_error(request->folder, "cannot be made", code.value());
  BatchLog log;
  if (Result<void> opened = log.open(request->log); !opened) return opened.error();
  Batch batch(arguments, *request, log, *std::move(stacks));
  Result<void> ran;
  {
    Progress progress(!console.quiet());
    ran = batch.run(progress.callback());
  }
  const int exit_code = tell(batch, console);
  if (!ran) return ran.error();
  Result<void> told;
  if (console.json()) {
    told = console.deliver(to_json(batch, *request, *inputs, console));
  } else if (!console.quiet()) {
    told = console.deliver(to_text(batch, *request, *inputs));
  }
  if (!told) return told.error();
  return exit_code;
}

}  // namespace tetloft::cli
