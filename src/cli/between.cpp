// tetloft between: the stack with sections put between the given ones, as a stack of its own.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/between_option.hpp"
#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "cli/label_input.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage between_usage() {
  Usage usage{
      "between",
      "The stack with sections put between the given ones, interpolated.",
      {input_word("IN", Contents::stack)},
      {{"--output", output_word("OUT", Contents::stack),
        "the longer stack: " + described_outputs(Contents::stack), "-o"},
       sections_between("--sections", "auto"),
       {"--labels-out", output_word("FILE", Contents::labels),
        "the decisions on all links of the longer stack, for --labels"}},
      "Given sections stay as they are, bit for bit. The others are those that reconstruct "
      "--between puts between with the same options. So that the longer stack has the components "
      "and voids of the shorter one give it to reconstruct, or check, with the FILE of "
      "--labels-out as --labels, --correspondence overlap, --no-chain, --no-lone, --between none, "
      "and --voids free "
      "if the shorter one had it. --json: slices and contours of the longer stack, inserted "
      "(sections), components, decisions (counts), and sections ([z, inserted, slab or section of "
      "the given stack, component of each contour]). Nothing is written when the command fails."};
  for (const Option& option : stack_options()) usage.options.push_back(option);
  for (const Option& option : {kNoDivideOption, kWorkLimitOption, kThreadsOption, kJsonOption,
                               kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

struct BetweenRequest {
  std::string input, output;
  std::optional<std::string> labels_out;
  BetweenOptions options;
  Preparation preparation;
};

[[nodiscard]] Result<void> read_outputs(const Arguments& arguments, BetweenRequest& request) {
  request.input = arguments.operand(0);
  const auto output = arguments.text("--output");
  if (!output) {
    return usage_error("missing option --output (-o) " + output_word("OUT", Contents::stack));
  }
  request.output = *output;
  request.labels_out = arguments.text("--labels-out");
  std::vector<std::string> taken{request.input};
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  Result<void> checked =
      check_output("--output (-o)", request.output, output_extensions(Contents::stack), taken);
  if (!checked || !request.labels_out) return checked;
  taken.push_back(request.output);
  return check_output("--labels-out", *request.labels_out, output_extensions(Contents::labels),
                      taken);
}

[[nodiscard]] Result<BetweenRequest> between_request_of(const Arguments& arguments,
                                                        Console& console) {
  BetweenRequest request;
  if (Result<void> outputs = read_outputs(arguments, request); !outputs) return outputs.error();
  const auto sections = sections_between_option(arguments, "--sections", std::nullopt);
  if (!sections) return sections.error();
  request.options.sections = *sections;
  request.options.divide_coarse = !arguments.has("--no-divide");
  const auto correspondence = correspondence_options(arguments, console);
  if (!correspondence) return correspondence.error();
  request.options.correspondence = *correspondence;
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  request.preparation = *prepared;
  const auto work = work_limit_option(arguments, kDefaultWorkLimit);
  if (!work) return work.error();
  request.options.work_limit = *work;
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  request.options.execution.threads = *threads;
  return request;
}

Labels labels_of(const LongStack& made) {
  Labels labels;
  labels.decisions = made.correspondence.decisions;
  labels.void_decisions = made.correspondence.voids.decisions;
  return labels;
}

Result<StagedFiles> stage_stack_of(const BetweenRequest& request, const LongStack& made,
                                   Console& console) {
  StagedFiles files;
  Result<void> taken = take_staged(
      io::stage_stack(request.output, made.stack, {}, temporary_watcher()), files, console);
  if (!taken) return taken.error();
  if (!request.labels_out) return files;
  const auto lines = format_labels(labels_of(made));
  if (!lines) return lines.error();
  taken =
      take_staged(io::stage_file(*request.labels_out, *lines, temporary_watcher()), files, console);
  if (!taken) return taken.error();
  return files;
}

std::size_t inserted_sections(const LongStack& made) {
  return static_cast<std::size_t>(
      std::count_if(made.source.begin(), made.source.end(),
                    [](const SectionSource& source) { return source.inserted; }));
}

std::size_t joined_of(const std::vector<LinkDecision>& decisions) {
  return static_cast<std::size_t>(
      std::count_if(decisions.begin(), decisions.end(),
                    [](const LinkDecision& decision) { return decision.join; }));
}

void write_decisions(JsonWriter& json, const CorrespondenceOptions& decided) {
  const std::size_t joined = joined_of(decided.decisions);
  const std::size_t opened = joined_of(decided.voids.decisions);
  json.key("decisions");
  json.begin_object();
  json.member("join", joined);
  json.member("part", decided.decisions.size() - joined);
  json.member("open", opened);
  json.member("close", decided.voids.decisions.size() - opened);
  json.end_object();
}

void write_sections(JsonWriter& json, const LongStack& made) {
  json.key("sections");
  json.begin_array();
  for (const SectionId s : made.source.ids()) {
    const SectionSource& source = made.source[s];
    json.begin_object();
    json.member("z", made.stack.sections[s].z);
    json.member("inserted", source.inserted);
    if (source.inserted) {
      json.member("slab", source.slab.index());
    } else {
      json.member("section", source.section.index());
    }
    json.key("components");
    json.begin_array();
    for (const ComponentId component : made.component[s]) json.value(component.index());
    json.end_array();
    json.end_object();
  }
  json.end_array();
}

std::string to_json(const LongStack& made, const StackInput& input, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("slices", made.stack.sections.size());
  json.member("inserted", inserted_sections(made));
  json.member("contours", made.stack.contour_count());
  json.member("components", made.components);
  write_decisions(json, made.correspondence);
  write_sections(json, made);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const LongStack& made, const StackInput& input, const BetweenRequest& request) {
  std::string text = describe_preparation(input) + counted(made.stack.sections.size(), "section") +
                     ", " + std::to_string(inserted_sections(made)) + " of them put between, " +
                     counted(made.stack.contour_count(), "contour") + ", " +
                     counted(made.components, "component") +
                     "\nwritten: " + printable(request.output);
  if (request.labels_out) text += ", " + printable(*request.labels_out);
  return text + '\n';
}

Result<int> run_between(const Arguments& arguments, Console& console) {
  Result<BetweenRequest> request = between_request_of(arguments, console);
  if (!request) return request.error();
  const auto input = read_stack_input(request->input, request->preparation, console);
  if (!input) return input.error();
  const Result<void> labelled =
      read_label_option(arguments, *input, request->options.correspondence);
  if (!labelled) return labelled.error();
  const Result<LongStack> made = [&] {
    Progress progress(!console.quiet());
    request->options.execution.progress = progress.callback();
    return between(input->stack(), request->options);
  }();
  if (!made) return in_file(made.error(), request->input);
  console.warn_of(request->input, made->warnings);
  auto files = stage_stack_of(*request, *made, console);
  if (!files) return files.error();
  std::string told;
  if (console.json()) {
    told = to_json(*made, *input, console);
  } else if (!console.quiet()) {
    told = to_text(*made, *input, *request);
  }
  const Result<void> done = deliver_with(*files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command between_command() { return {between_usage(), run_between}; }

}  // namespace tetloft::cli
