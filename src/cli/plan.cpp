// tetloft plan: what has to be decided over a whole stack, as a file that pieces are built from.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/label_input.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/reconstruct_piece.hpp"
#include "cli/reconstruct_request.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "cli/structures.hpp"
#include "pieces/piece_file.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage plan_usage() {
  Usage usage{"plan",
              "Decides what has to be decided over the whole stack, for building it in pieces.",
              {input_word("STACK", Contents::stack)},
              {{"--output", "PLAN", "the plan", "-o"}},
              "A piece of the stack is built by `tetloft reconstruct --plan PLAN --slabs A:B "
              "-o PIECE.vtu`, on any machine, in any order; `tetloft join PIECES... -o OUT` makes "
              "of all pieces the solid that `tetloft reconstruct STACK -o OUT` makes with the "
              "options of the plan, bit for bit, however the stack was cut. The plan has the "
              "sections in it; `tetloft info PLAN` tells about it. --json: sections, slabs, "
              "components, cavities and identity."};
  for (const Option& option : stack_options()) usage.options.push_back(option);
  for (const Option& option : solid_options()) usage.options.push_back(option);
  for (const Option& option : {kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

std::string to_json(const PlanSummary& plan, const StackInput& input, const std::string& path,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("sections", plan.sections);
  json.member("slabs", plan.sections - 1);
  json.member("contours", plan.contours);
  json.member("components", plan.components);
  json.member("cavities", plan.cavities);
  json.member("identity", in_hex(plan.identity));
  json.member("written", path);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const PlanSummary& plan, const StackInput& input, const std::string& path) {
  return describe_preparation(input) + counted(plan.sections, "section") +
         ", slabs 0:" + std::to_string(plan.sections - 1) + ", " +
         counted(plan.components, "component") + '\n' + written_line({path});
}

Result<int> run_plan(const Arguments& arguments, Console& console) {
  const auto output = arguments.text("--output");
  if (!output) return usage_error("missing option --output (-o) PLAN");
  Result<ReconstructRequest> request = solid_request_of(arguments, console);
  if (!request) return request.error();
  if (request->preparation.read.structure == kAllStructures) {
    return usage_error("a plan is of one structure: choose it");
  }
  std::vector<std::string> taken{request->input};
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  const Result<void> fine = check_output("--output (-o)", *output, {}, taken);
  if (!fine) return fine.error();
  const auto input = open_stack_input(arguments, request->input, request->preparation, console);
  if (!input) return input.error();
  const Result<void> labelled =
      read_label_option(arguments, *input, request->options.correspondence);
  if (!labelled) return labelled.error();
  const Result<PlanSource> source = source_of(request->input);
  if (!source) return source.error();
  Result<internal::pieces::StagedPlan> plan = [&] {
    Progress progress(!console.quiet());
    request->options.execution.progress = progress.callback();
    return with_given(*input, [&](const auto& given) {
      return internal::pieces::stage_plan(*output, given, request->options, *source,
                                          temporary_watcher());
    });
  }();
  if (!plan) return in_file(plan.error(), request->input);
  console.warn_of(request->input, plan->warnings);
  std::string told;
  if (console.json()) {
    told = to_json(plan->summary, *input, *output, console);
  } else if (!console.quiet()) {
    told = to_text(plan->summary, *input, *output);
  }
  const Result<void> done = deliver_with(plan->files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command plan_command() { return {plan_usage(), run_plan}; }

}  // namespace tetloft::cli
