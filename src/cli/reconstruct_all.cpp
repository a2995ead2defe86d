// A solid of each structure: the file is read anew for each, so that no two need be in memory but
// those in work.
#include "cli/reconstruct_all.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "cli/many_solids.hpp"
#include "cli/progress.hpp"
#include "cli/structures.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

class AllStructures {
 public:
  AllStructures(const Arguments& arguments, const ReconstructRequest& request,
                std::vector<Structure> structures)
      : arguments_(arguments),
        request_(request),
        structures_(std::move(structures)),
        outputs_(structures_.size(), request.outputs),
        outcomes_(structures_.size()) {
    const ModelOutputs& outputs = request.outputs;
    for (auto part : {&ModelOutputs::solid, &ModelOutputs::surface, &ModelOutputs::repaired}) {
      if (!(outputs.*part)) continue;
      const std::vector<std::string> names = outputs_of(*(outputs.*part), structures_);
      for (std::size_t i = 0; i < names.size(); ++i) outputs_[i].*part = names[i];
    }
  }

  void run(const std::function<void(std::size_t, std::size_t)>& progress) {
    std::mutex staging;
    const auto make = [&](std::size_t i, unsigned threads) {
      ReconstructRequest request = request_;
      request.preparation.read.structure = structures_[i].asked;
      request.preparation.read.execution.threads = threads;
      request.options.execution.threads = threads;
      request.outputs = outputs_[i];
      outcomes_[i] = make_solid(arguments_, request, staging);
      return true;
    };
    share_out(structures_.size(), request_.options.execution.threads, make, progress);
  }

  [[nodiscard]] const std::vector<Structure>& structures() const { return structures_; }
  [[nodiscard]] const std::vector<SolidOutcome>& outcomes() const { return outcomes_; }

 private:
  const Arguments& arguments_;
  const ReconstructRequest& request_;
  std::vector<Structure> structures_;
  std::vector<ModelOutputs> outputs_;
  std::vector<SolidOutcome> outcomes_;
};

std::string title(const Structure& structure) {
  return "structure " + structure.number +
         (structure.name.empty() ? "" : ' ' + io::in_quotes(structure.name));
}

void write_outcome(JsonWriter& json, const Structure& structure, const SolidOutcome& outcome) {
  json.begin_object();
  json.member("number", structure.value);
  json.member("name", structure.name);
  if (outcome.error) {
    write_error(json, *outcome.error);
  } else {
    json.member("written", paths_of(outcome.outputs));
    write_counts(json, outcome);
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
    const SolidOutcome& outcome = all.outcomes()[i];
    if (outcome.error) continue;
    text += title(all.structures()[i]) + ": " + described_counts(outcome) + "; " +
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
    const SolidOutcome& outcome = all.outcomes()[i];
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
