// See reconstruct_batch.hpp.
#include "cli/reconstruct_batch.hpp"

#include <algorithm>
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
#include "cli/batch_request.hpp"
#include "cli/many_solids.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/output_place.hpp"
#include "io/stack_files.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

namespace fs = std::filesystem;

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

// With its outputs, none of which is an input or its data, the list, or the log.
Result<std::vector<BatchStack>> batch_stacks(const BatchRequest& batch,
                                             const std::vector<std::string>& inputs) {
  const Result<std::vector<std::string>> stems = output_stems(inputs);
  if (!stems) return stems.error();
  std::set<fs::path> taken{place_of(batch.request.input)};
  const std::string& format = batch.request.preparation.read.format;
  for (const std::string& input : inputs) {
    for (const std::string& file : io::stack_files(input, format)) taken.insert(place_of(file));
  }
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
