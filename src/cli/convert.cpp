// tetloft convert: what a file holds, written in another format.
#include <optional>
#include <string>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/convert_model.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage convert_usage() {
  Usage usage{
      "convert",
      "From one format to another: a stack, mended on the way, or a model, whole or by components.",
      {"IN"},
      {{"--output", "OUT",
        "where it goes; a stack: " + described_outputs(Contents::stack) +
            "; a model as a solid: " + described_outputs(Contents::model) +
            "; its boundary: " + described_outputs(Contents::surface) + "; this or OUT is required",
        "-o"},
       {"--labels-out", "FILE",
        "the labels that the input gives its contours, as lines that --labels takes"}},
      "Numbers are written with the digits that read back exactly. Contours and sections keep "
      "their order; planes that are not z = const are turned to it, for formats that know no "
      "other, with a warning. Models lie in the space of the file that their stack came from; "
      "names of structures and components, and units, go along where a format has a place for "
      "them."};
  usage.further = {"OUT"};
  for (const Option& option : model_conversion_options()) usage.options.push_back(option);
  for (const Option& option : preparation_options()) usage.options.push_back(option);
  for (const Option& option : {kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

// By -o, or as the last word.
Result<std::string> output_of(const Arguments& arguments) {
  const auto given = arguments.text("--output");
  const bool as_operand = arguments.operand_count() > 1;
  if (given && as_operand) {
    return usage_error("the output is given twice: " + io::in_quotes(*given) + " and " +
                       io::in_quotes(arguments.operand(1)));
  }
  if (given) return *given;
  if (as_operand) return arguments.operand(1);
  return usage_error("missing OUT, or option --output (-o) OUT");
}

struct ConvertRequest {
  std::string output;
  std::optional<std::string> labels_out;
  Encoding encoding = Encoding::binary;
};

Result<ConvertRequest> convert_request_of(const Arguments& arguments, const std::string& output) {
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  ConvertRequest request{output, arguments.text("--labels-out"), *encoding};
  std::vector<std::string> taken{arguments.operand(0)};
  Result<void> checked =
      check_output("--output (-o)", request.output, output_extensions(Contents::stack), taken);
  if (checked && request.labels_out) {
    taken.push_back(request.output);
    checked = check_output("--labels-out", *request.labels_out, output_extensions(Contents::labels),
                           taken);
  }
  if (!checked) return checked.error();
  return request;
}

bool has_any(const Labels& labels) {
  return !labels.labels.empty() || !labels.decisions.empty() || !labels.hole_labels.empty() ||
         !labels.void_decisions.empty();
}

Result<StagedFiles> stage_converted(const ConvertRequest& request, const StackInput& input,
                                    Console& console) {
  StagedFiles files;
  Result<void> taken = take_staged(
      io::stage_stack(request.output, input.stack(), {request.encoding, {}}, temporary_watcher()),
      files, console);
  if (!taken) return taken.error();
  if (has_any(input.labels) && !request.labels_out) {
    console.warn({"the input has labels, which --labels-out FILE would keep", {}});
  }
  if (!request.labels_out) return files;
  const auto lines = format_labels(input.labels);
  if (!lines) return lines.error();
  taken =
      take_staged(io::stage_file(*request.labels_out, *lines, temporary_watcher()), files, console);
  if (!taken) return taken.error();
  return files;
}

std::string to_json(const StackInput& input, const ConvertRequest& request,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("slices", input.stack().sections.size());
  json.member("contours", input.stack().contour_count());
  json.member("vertices", input.stack().vertex_count());
  json.member("name", input.name);
  json.member("unit", input.unit);
  json.member("written", request.output);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const StackInput& input, const ConvertRequest& request) {
  std::string text = describe_preparation(input) +
                     counted(input.stack().sections.size(), "section") + ", " +
                     counted(input.stack().contour_count(), "contour") + ", " +
                     std::to_string(input.stack().vertex_count()) +
                     " vertices\nwritten: " + printable(request.output);
  if (request.labels_out) text += ", " + printable(*request.labels_out);
  return text + '\n';
}

Result<int> run_convert(const Arguments& arguments, Console& console) {
  const auto output = output_of(arguments);
  if (!output) return output.error();
  if (converts_model(arguments, *output)) return convert_model(arguments, *output, console);
  const auto request = convert_request_of(arguments, *output);
  if (!request) return request.error();
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  const auto input = read_stack_input(arguments.operand(0), *prepared, console);
  if (!input) return input.error();
  auto files = stage_converted(*request, *input, console);
  if (!files) return files.error();
  std::string told;
  if (console.json()) {
    told = to_json(*input, *request, console);
  } else if (!console.quiet()) {
    told = to_text(*input, *request);
  }
  const Result<void> done = deliver_with(*files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command convert_command() { return {convert_usage(), run_convert}; }

}  // namespace tetloft::cli
