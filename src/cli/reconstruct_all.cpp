// A solid of each structure: the file is read anew for each, so that no two need be in memory but
// those in work.
#include "cli/reconstruct_all.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "cli/label_input.hpp"
#include "cli/progress.hpp"
#include "cli/repaired_output.hpp"
#include "cli/structures.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

struct Outcome {
  std::optional<Error> error;
  std::vector<Warning> warnings;
  ModelOutputs outputs;
  ReconstructReport report;
  std::size_t tets = 0;
  std::size_t vertices = 0;
  std::size_t components = 0;
};

class AllStructures {
 public:
  AllStructures(const Arguments& arguments, const ReconstructRequest& request,
                std::vector<Structure> structures)
      : arguments_(arguments),
        request_(request),
        structures_(std::move(structures)),
        outcomes_(structures_.size()) {
    const ModelOutputs& outputs = request.outputs;
    for (auto part : {&ModelOutputs::solid, &ModelOutputs::surface, &ModelOutputs::repaired}) {
      if (!(outputs.*part)) continue;
      const std::vector<std::string> names = outputs_of(*(outputs.*part), structures_);
      for (std::size_t i = 0; i < names.size(); ++i) outcomes_[i].outputs.*part = names[i];
    }
    for (Outcome& outcome : outcomes_) outcome.outputs.encoding = outputs.encoding;
  }

  void run(const std::function<void(std::size_t, std::size_t)>& progress) {
    const unsigned given = request_.options.execution.threads;
    const unsigned threads = given != 0 ? given : std::max(1U, std::thread::hardware_concurrency());
    const auto workers = static_cast<unsigned>(std::min<std::size_t>(threads, structures_.size()));
    threads_each_ = std::max(1U, threads / workers);
    const auto work = [&] {
      for (std::size_t i = next_++; i < structures_.size(); i = next_++) {
        make(i);
        const std::scoped_lock lock(mutex_);
        ++done_;
        if (progress) progress(done_, structures_.size());
      }
    };
    std::vector<std::jthread> others;
    for (unsigned w = 1; w < workers; ++w) others.emplace_back(work);
    work();
  }

  [[nodiscard]] const std::vector<Structure>& structures() const { return structures_; }
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }

 private:
  // Nothing thrown leaves a thread.
  void make(std::size_t i) {
    Console console = Console::keeping();
    Result<void> made;
    try {
      made = reconstruct_one(structures_[i], outcomes_[i], console);
    } catch (const std::bad_alloc&) {
      made = Error{ErrorCode::out_of_memory, "out of memory", {}};
    } catch (const std::exception& e) {
      made = Error{ErrorCode::internal, e.what(), {}};
    }
    if (!made) outcomes_[i].error = in_file(made.error(), request_.input);
    outcomes_[i].warnings = console.warnings();
  }

  Result<void> reconstruct_one(const Structure& structure, Outcome& outcome, Console& console) {
    Preparation preparation = request_.preparation;
    preparation.read.structure = structure.asked;
    preparation.read.execution.threads = threads_each_;
    const auto input = read_stack_input(request_.input, preparation, console);
    if (!input) return input.error();
    ReconstructOptions options = request_.options;
    options.execution.threads = threads_each_;
    const Result<void> labelled = read_label_option(arguments_, *input, options.correspondence);
    if (!labelled) return labelled.error();
    Result<Reconstruction> result =
        std::visit([&](const auto& stack) { return reconstruct(stack, options); }, input->given);
    if (!result) return result.error();
    console.warn_of(request_.input, result->warnings);
    if (request_.verify) {
      if (Result<void> fine = verify(result->model, input->stack(), options); !fine) return fine;
    }
    outcome.report = result->report;
    outcome.tets = result->model.tets.size();
    outcome.vertices = result->model.points.size();
    outcome.components = result->model.component_count;
    // Whoever ends the program learns of temporaries one at a time.
    const std::scoped_lock lock(mutex_);
    auto files = stage_model(result->model, outcome.outputs, console, Tets::proven);
    if (!files) return files.error();
    const Result<void> staged =
        stage_repaired(outcome.outputs.repaired, input->stack(), *files, console);
    if (!staged) return staged.error();
    return io::commit_all(*files);
  }

  const Arguments& arguments_;
  const ReconstructRequest& request_;
  std::vector<Structure> structures_;
  std::vector<Outcome> outcomes_;
  unsigned threads_each_ = 1;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

std::string title(const Structure& structure) {
  return "structure " + structure.number +
         (structure.name.empty() ? "" : ' ' + io::in_quotes(structure.name));
}

void write_outcome(JsonWriter& json, const Structure& structure, const Outcome& outcome) {
  json.begin_object();
  json.member("number", structure.value);
  json.member("name", structure.name);
  if (outcome.error) {
    write_error(json, *outcome.error);
  } else {
    json.member("written", paths_of(outcome.outputs));
    json.member("slices", outcome.report.slices);
    json.member("contours", outcome.report.contours);
    json.member("vertices", outcome.vertices);
    json.member("tets", outcome.tets);
    json.member("components", outcome.components);
    json.member("volume", outcome.report.volume);
  }
  json.end_object();
}

std::string to_json(const AllStructures& all, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.key("structures");
  json.begin_array();
  for (std::size_t i = 0; i < all.structures().size(); ++i) {
    write_outcome(json, all.structures()[i], all.outcomes()[i]);
  }
  json.end_array();
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const AllStructures& all) {
  std::string text;
  for (std::size_t i = 0; i < all.structures().size(); ++i) {
    const Outcome& outcome = all.outcomes()[i];
    if (outcome.error) continue;
    text += title(all.structures()[i]) + ": " + counted(outcome.report.slices, "section") + ", " +
            counted(outcome.tets, "tet") + ", " + counted(outcome.components, "component") +
            ", volume " + readable(outcome.report.volume) + "; " +
            written_line(paths_of(outcome.outputs));
  }
  return text;
}

Result<std::vector<Structure>> listed(const ReconstructRequest& request, Console& console) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(input_path(request.input), code)) {
    return usage_error("all structures are made by reading the input several times: " +
                       io::in_quotes(request.input) + " is no file that can be");
  }
  ReadOptions reading = request.preparation.read;
  reading.structure.clear();
  const Result<FileSummary> file = inspect(request.input, reading);
  if (!file) return file.error();
  console.warn_of(request.input, file->warnings);
  std::vector<Structure> structures = structures_of(*file);
  for (const StructureSummary& structure : file->structures) {
    if (structure.closed > 0) continue;
    console.warn_of(request.input,
                    {{"structure " + std::to_string(structure.number) + ' ' +
                          io::in_quotes(structure.name) + " has no closed contour: left out",
                      {}}});
  }
  if (structures.empty()) {
    return in_file({ErrorCode::invalid_input,
                    "there are no structures or labels with closed contours in this file",
                    {}},
                   request.input);
  }
  return structures;
}

}  // namespace

Result<int> reconstruct_all(const Arguments& arguments, const ReconstructRequest& request,
                            Console& console) {
  if (arguments.has("--labels")) {
    return usage_error("--labels names contours of one structure: choose it with --roi or --label");
  }
  auto structures = listed(request, console);
  if (!structures) return structures.error();
  const std::vector<Warning> of_file = console.warnings();
  AllStructures all(arguments, request, *std::move(structures));
  {
    Progress progress(!console.quiet());
    all.run(progress.callback());
  }
  int exit_code = 0;
  for (std::size_t i = 0; i < all.structures().size(); ++i) {
    const Outcome& outcome = all.outcomes()[i];
    for (Warning warning : outcome.warnings) {
      // What the file itself is odd in has been told.
      const auto same = [&](const Warning& told) {
        return told.message == warning.message && to_string(told) == to_string(warning);
      };
      if (std::any_of(of_file.begin(), of_file.end(), same)) continue;
      warning.message = title(all.structures()[i]) + ": " + warning.message;
      console.warn(warning);
    }
    if (!outcome.error) continue;
    if (exit_code == 0) exit_code = static_cast<int>(outcome.error->code);
    Error error = *outcome.error;
    error.message = title(all.structures()[i]) + ": " + error.message;
    console.say("error: " + to_string(error));
  }
  Result<void> told;
  if (console.json()) {
    told = console.deliver(to_json(all, console));
  } else if (!console.quiet()) {
    told = console.deliver(to_text(all));
  }
  if (!told) return told.error();
  return exit_code;
}

}  // namespace tetloft::cli
