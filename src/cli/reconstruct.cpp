// tetloft reconstruct: from a stack of contours to a solid.
#include <optional>
#include <utility>

#include "cli/batch_inputs.hpp"
#include "cli/batch_request.hpp"
#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/geiger_method.hpp"
#include "cli/label_input.hpp"
#include "cli/link_report.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/reconstruct_all.hpp"
#include "cli/reconstruct_batch.hpp"
#include "cli/reconstruct_piece.hpp"
#include "cli/reconstruct_request.hpp"
#include "cli/repaired_output.hpp"
#include "cli/signals.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "pieces/piece_file.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage reconstruct_usage() {
  Usage usage{
      "reconstruct",
      "From a stack of contours to a tetrahedral solid.",
      {input_word("IN", Contents::stack)},
      {{"--output", output_word("OUT", Contents::model),
        "the solid: " + described_outputs(Contents::model), "-o"},
       {"--surface", "FILE",
        "its boundary: " + described_outputs(Contents::surface) +
            "; this or --output must be given"},
       repaired_option()},
      "A single section is made into a solid of --thickness, or of a tenth of the larger "
      "side of its bounding box, with a warning. Nothing is written when the command "
      "fails. Where IN is a folder, all stacks in it are made into solids, several at once, "
      "by the same options, and of IN.list those that it names: OUT is then a folder, too, "
      "in which a log of JSON lines tells of each. Run again, it goes on: what the log "
      "knows as done, input, options and output by their contents, is skipped. Those that "
      "fail keep none from being made; the exit code is that of the first."};
  usage.spared = "--plan";
  for (const Option& option : stack_options()) usage.options.push_back(option);
  for (const Option& option : solid_options()) usage.options.push_back(option);
  for (const Option& option : batch_options()) usage.options.push_back(option);
  for (const Option& option :
       {Option{"--method",
               "NAME",
               "nonato (default), or geiger: the older algorithm that it is compared with, which "
               "keeps none of the guarantees (--verify tells which it broke)",
               {},
               {"nonato", "geiger"}},
        Option{"--plan", "PLAN",
               "build a piece of this plan (tetloft plan), as it was decided there; IN, if given, "
               "must be the "
               "stack of the plan"},
        Option{
            "--slabs", "A:B",
            "with --plan: the piece's slabs, A to B - 1; slab k is between sections k and k + 1"},
        Option{"--stream", "",
               "for solids that are too large for memory: slabs are built, written and forgotten, "
               "some at a time; the same file, a .vtu"},
        Option{"--verify", "", "check the result; write nothing and exit with 70 if it fails"},
        kAsciiOption, kCompressOption, kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

// Wall-clock seconds of what the command line does around the reconstruction.
struct Seconds {
  double read = 0;
  double verify = 0;
  double write = 0;
  double total = 0;
};

std::string to_json(const Reconstruction& result, const StackInput& input, const Seconds& seconds,
                    const Console& console) {
  const ReconstructReport& report = result.report;
  JsonWriter json;
  json.begin_object();
  json.member("slices", report.slices);
  json.member("sections_between", report.sections_between);
  json.member("sections_given_up", report.sections_given_up);
  json.member("contours", report.contours);
  json.member("input_vertices", report.input_vertices);
  json.member("split_vertices", report.split_vertices);
  json.member("dividing_vertices", report.dividing_vertices);
  json.member("vertices", report.vertices);
  json.member("tets", report.tets);
  json.member("components", report.components);
  json.member("volume", report.volume);
  json.member("smallest_lift", report.smallest_lift);
  json.member("work", report.work);
  json.key("rules");
  json.begin_object();
  for (int r = 0; r < kRules; ++r) {
    json.member(name_of(static_cast<Rule>(r)), report.rules[static_cast<std::size_t>(r)]);
  }
  json.end_object();
  json.key("seconds");
  json.begin_object();
  json.member("read", seconds.read);
  for (int s = 0; s < kSteps; ++s) {
    json.member(name_of(static_cast<Step>(s)), report.seconds[static_cast<std::size_t>(s)]);
  }
  json.member("reconstruct", report.seconds_total);
  json.member("verify", seconds.verify);
  json.member("write", seconds.write);
  json.member("total", seconds.total);
  json.end_object();
  write_link_summary(json, result.model);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const Reconstruction& result, const StackInput& input, const Seconds& seconds,
                    const ReconstructRequest& request) {
  const ReconstructReport& report = result.report;
  std::string text;
  text += describe_preparation(input);
  text += counted(report.slices, "section") + ", " +
          (report.sections_between == 0
               ? std::string()
               : counted(report.sections_between, "section") + " put between" +
                     (report.sections_given_up == 0
                          ? std::string()
                          : " and " + std::to_string(report.sections_given_up) + " given up") +
                     ", ") +
          counted(report.contours, "contour") + ", " + std::to_string(report.input_vertices) +
          " input vertices and " + std::to_string(report.split_vertices) + " inserted on contours" +
          (report.dividing_vertices > 0
               ? ", " + std::to_string(report.dividing_vertices) + " of them to divide coarse ones"
               : "") +
          '\n';
  text += counted(report.tets, "tet") + ", " + std::to_string(report.vertices) + " vertices, " +
          counted(report.components, "component") + ", volume " + readable(report.volume) + '\n';
  text += describe_links(result.model.links, result.model.void_links);
  text += "smallest lift " + readable(report.smallest_lift) + '\n';
  std::string rules;
  for (int r = 0; r < kRules; ++r) {
    const auto count = report.rules[static_cast<std::size_t>(r)];
    if (count == 0) continue;
    rules += (rules.empty() ? "" : ", ") + std::string(name_of(static_cast<Rule>(r))) + ' ' +
             std::to_string(count);
  }
  text += "rules fired: " + (rules.empty() ? "none" : rules) + '\n';
  text += "seconds: read " + readable_seconds(seconds.read);
  for (int s = 0; s < kSteps; ++s) {
    text += std::string(", ") + name_of(static_cast<Step>(s)) + ' ' +
            readable_seconds(report.seconds[static_cast<std::size_t>(s)]);
  }
  if (request.verify) text += ", verify " + readable_seconds(seconds.verify);
  text += ", write " + readable_seconds(seconds.write) + ", total " +
          readable_seconds(seconds.total) + '\n';
  if (request.verify) text += "verified: all guarantees hold\n";
  return text + written_line(paths_of(request.outputs));
}

// What needs the whole solid at once.
Result<void> check_stream(const Arguments& arguments, const ReconstructRequest& request) {
  for (const std::string_view option : {"--surface", "--verify"}) {
    if (arguments.has(option)) {
      return usage_error("option " + std::string(option) +
                         " does not go with --stream: it needs all of the solid in memory");
    }
  }
  if (request.preparation.read.structure == kAllStructures) {
    return usage_error("a stream is of one structure: choose it");
  }
  const std::string& path = *request.outputs.solid;
  const std::string& format = request.outputs.format;
  if (io::extension_of(path) != ".vtu" || !(format.empty() || format == "vtu")) {
    return usage_error("option --stream writes .vtu alone, not " + io::in_quotes(path));
  }
  return {};
}

// The solid and its files, which have not appeared. Of a stream the model has its tables alone.
struct Made {
  Reconstruction solid;
  StagedFiles files;
};

Result<Made> make_streamed(const StackInput& input, ReconstructRequest& request, Seconds& seconds,
                           Console& console) {
  const Stopwatch making;
  Result<internal::pieces::StagedStream> made = [&] {
    Progress progress(!console.quiet());
    request.options.execution.progress = progress.callback();
    return with_given(input, [&](const auto& given) {
      return internal::pieces::stage_streamed(*request.outputs.solid, given, request.options,
                                              request.outputs.encoding, temporary_watcher());
    });
  }();
  if (!made) return in_file(made.error(), request.input);
  console.warn_of(request.input, made->warnings);
  seconds.write = making.seconds() - made->report.seconds_total;
  Made all;
  all.solid.model = std::move(made->rest);
  all.solid.report = made->report;
  all.files = std::move(made->files);
  return all;
}

Result<Made> make_whole(const StackInput& input, ReconstructRequest& request, Seconds& seconds,
                        Console& console) {
  Result<Reconstruction> result = [&] {
    Progress progress(!console.quiet());
    request.options.execution.progress = progress.callback();
    return std::visit([&](const auto& stack) { return reconstruct(stack, request.options); },
                      input.given);
  }();
  if (!result) return in_file(result.error(), request.input);
  console.warn_of(request.input, result->warnings);
  if (request.verify) {
    const Stopwatch verifying;
    Result<void> verified = verify(result->model, input.stack(), request.options);
    if (!verified) return verified.error();
    seconds.verify = verifying.seconds();
  }
  const Stopwatch writing;
  auto files = stage_model(result->model, request.outputs, console, Tets::proven);
  if (!files) return files.error();
  seconds.write = writing.seconds();
  return Made{std::move(*result), std::move(*files)};
}

Result<int> run_reconstruct(const Arguments& arguments, Console& console) {
  if (arguments.operand_count() > 0 && names_many(arguments)) {
    return reconstruct_batch(arguments, reconstruct_usage().options, console);
  }
  if (Result<void> fine = check_no_batch_options(arguments); !fine) return fine.error();
  if (arguments.has("--plan") || arguments.has("--slabs")) {
    return reconstruct_piece(arguments, reconstruct_usage().options, console);
  }
  const auto method = arguments.choice("--method");
  if (!method) return method.error();
  const bool stream = arguments.has("--stream");
  if (method->value_or(0) == 1 && stream) {
    return usage_error("option --stream does not go with --method geiger");
  }
  if (method->value_or(0) == 1) return reconstruct_by_geiger(arguments, console);
  const Stopwatch all;
  Result<ReconstructRequest> request = reconstruct_request_of(arguments, console);
  if (!request) return request.error();
  if (stream) {
    if (Result<void> fine = check_stream(arguments, *request); !fine) return fine.error();
  }
  if (request->preparation.read.structure == kAllStructures) {
    return reconstruct_all(arguments, *request, console);
  }
  Seconds seconds;
  Stopwatch reading;
  const auto input =
      stream ? open_stack_input(arguments, request->input, request->preparation, console)
             : read_stack_input(request->input, request->preparation, console);
  if (!input) return input.error();
  const Result<void> labelled =
      read_label_option(arguments, *input, request->options.correspondence);
  if (!labelled) return labelled.error();
  seconds.read = reading.seconds();
  if (request->options.thickness && input->section_count() > 1) {
    console.warn({"--thickness has no effect on more than one section", {}});
  }

  Result<Made> made = stream ? make_streamed(*input, *request, seconds, console)
                             : make_whole(*input, *request, seconds, console);
  if (!made) return made.error();
  if (!input->opened) {
    const Result<void> staged =
        stage_repaired(request->outputs.repaired, input->stack(), made->files, console);
    if (!staged) return staged.error();
  }
  seconds.total = all.seconds();
  std::string told;
  if (console.json()) {
    told = to_json(made->solid, *input, seconds, console);
  } else if (!console.quiet()) {
    told = to_text(made->solid, *input, seconds, *request);
  }
  const Result<void> done = deliver_with(made->files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command reconstruct_command() { return {reconstruct_usage(), run_reconstruct}; }

}  // namespace tetloft::cli
