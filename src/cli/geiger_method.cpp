#include "cli/geiger_method.hpp"

#include <string>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "cli/engine_option.hpp"
#include "cli/json.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/repaired_output.hpp"
#include "cli/stack_input.hpp"
#include "cli/verdicts.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Result<void> refuse_other_options(const Arguments& arguments) {
  for (const char* option :
       {"--correspondence", "--overlap", "--no-chain", "--no-lone", "--no-divide", "--voids",
        "--labels", "--between", "--ends", "--thickness", "--delaunay"}) {
    if (arguments.text(option)) {
      return usage_error(std::string("option ") + option + " has no meaning with --method geiger");
    }
  }
  return {};
}

Result<void> tell_broken_guarantees(const Model& model, const SectionStack& stack, unsigned threads,
                                    Console& console) {
  CheckOptions options;
  options.execution.threads = threads;
  const Result<CheckReport> report = check(model, stack, options);
  if (!report) return report.error();
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      console.warn({"broken: " + describe(verdict, failure), {}});
    }
  }
  return {};
}

std::string to_json(const GeigerModel& made, const StackInput& input, double seconds,
                    const Console& console) {
  const GeigerReport& report = made.report;
  JsonWriter json;
  json.begin_object();
  json.member("method", "geiger");
  json.member("slices", input.stack().sections.size());
  json.member("contours", input.stack().contour_count());
  json.member("input_vertices", report.input_vertices);
  json.member("split_vertices", report.split_vertices);
  json.member("foot_vertices", report.foot_vertices);
  json.member("projected_vertices", report.projected_vertices);
  json.member("external_tets", report.external_tets);
  json.member("singular_tets", report.singular_tets);
  json.member("lost_contours", report.lost_contours);
  json.member("vertices", made.model.points.size());
  json.member("tets", made.model.tets.size());
  json.member("components", made.model.component_count);
  json.member("volume", volume(made.model));
  json.member("seconds", seconds);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const GeigerModel& made, const StackInput& input, double seconds,
                    const ModelOutputs& outputs) {
  const GeigerReport& report = made.report;
  std::string text = describe_preparation(input);
  text += counted(input.stack().sections.size(), "section") + ", " +
          counted(input.stack().contour_count(), "contour") + ", " +
          std::to_string(report.input_vertices) + " input vertices, " +
          std::to_string(report.split_vertices) + " and " + std::to_string(report.foot_vertices) +
          " feet inserted on contours, " + std::to_string(report.projected_vertices) +
          " projected into regions\n";
  text += "eliminated: " + std::to_string(report.external_tets) + " external and " +
          counted(report.singular_tets, "singular tet") + "; " +
          counted(report.lost_contours, "contour") + " lost\n";
  text += counted(made.model.tets.size(), "tet") + ", " + std::to_string(made.model.points.size()) +
          " vertices, " + counted(made.model.component_count, "component") + ", volume " +
          readable(volume(made.model)) + ", " + readable_seconds(seconds) + " seconds\n";
  return text + written_line(paths_of(outputs));
}

}  // namespace

Result<int> reconstruct_by_geiger(const Arguments& arguments, Console& console) {
  const auto outputs = model_outputs(arguments);
  if (!outputs) return outputs.error();
  if (Result<void> fine = refuse_other_options(arguments); !fine) return fine.error();
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  const auto limit = work_limit_option(arguments, kDefaultWorkLimit);
  if (!limit) return limit.error();
  const auto input = read_stack_input(arguments.operand(0), *prepared, console);
  if (!input) return input.error();
  const Stopwatch watch;
  const Result<GeigerModel> made = [&] {
    Progress progress(!console.quiet());
    GeigerOptions options;
    options.execution.threads = *threads;
    options.execution.progress = progress.callback();
    options.work_limit = *limit;
    return reconstruct_geiger(input->stack(), options);
  }();
  const double seconds = watch.seconds();
  if (!made) return in_file(made.error(), arguments.operand(0));
  if (arguments.has("--verify")) {
    Result<void> told = tell_broken_guarantees(made->model, input->stack(), *threads, console);
    if (!told) return told.error();
  }
  auto files = stage_model(made->model, *outputs, console);
  if (!files) return files.error();
  const Result<void> staged = stage_repaired(outputs->repaired, input->stack(), *files, console);
  if (!staged) return staged.error();
  std::string told;
  if (console.json()) {
    told = to_json(*made, *input, seconds, console);
  } else if (!console.quiet()) {
    told = to_text(*made, *input, seconds, *outputs);
  }
  const Result<void> done = deliver_with(*files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace tetloft::cli
