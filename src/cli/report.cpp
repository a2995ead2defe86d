// tetloft report: one page about a model, to be handed on.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/check_options.hpp"
#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/label_input.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/report_json.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "cli/verdicts.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage report_usage() {
  Usage usage{
      "report",
      "One page about a model to hand on: pictures, sections, guarantees, figures, plots.",
      {input_word("MODEL", Contents::model)},
      {{"--output", "OUT.html", "the page; required", "-o"},
       {"--title", "TEXT", "of the page (default: the name of the structure, or the file)"},
       {"--date", "TEXT", "a date to show (default: none)"},
       {"--sections", "N", "show at most so many sections, 1 to 12 (default 8)"}},
      "With the stack that the model was made of all guarantees are checked, as check does, "
      "with the same options; without it the two that need none. Exits with 1 if a "
      "guarantee fails: the page is written all the same, and says so."};
  usage.further = {input_word("IN", Contents::stack)};
  for (const Option& option : stack_options()) usage.options.push_back(option);
  for (const Option& option : check_option_list()) usage.options.push_back(option);
  for (const Option& option : {kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

// As a shell takes it.
std::string quoted_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+,./:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + '\'';
}

std::string command_line(const Arguments& arguments) {
  std::string line = "tetloft report";
  for (const std::string& word : arguments.line()) line += ' ' + quoted_word(word);
  return line;
}

std::string file_name(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

Result<void> check_nothing_of_stack(const Arguments& arguments) {
  for (const Option& option : stack_options()) {
    if (arguments.has(option.name)) return usage_error("option " + option.name + " needs IN");
  }
  return {};
}

struct ReportRequest {
  std::string output;
  ReportOptions options;
  Preparation preparation;
  std::string model_format;
  std::optional<std::string> stack;  ///< its operand
};

// What the page shows, and how it is checked.
Result<ReportOptions> report_options(const Arguments& arguments, Console& console) {
  ReportOptions options;
  auto check = check_options(arguments, console);
  if (!check) return check.error();
  options.check = *std::move(check);
  options.execution.threads = options.check.execution.threads;
  const auto sections =
      arguments.integer("--sections", 1, static_cast<std::int64_t>(kMostReportSections));
  if (!sections) return sections.error();
  if (*sections) options.sections = static_cast<std::size_t>(**sections);
  options.title = arguments.text("--title").value_or("");
  options.date = arguments.text("--date").value_or("");
  options.command = command_line(arguments);
  options.model_file = file_name(arguments.operand(0));
  if (arguments.operand_count() > 1) options.stack_file = file_name(arguments.operand(1));
  return options;
}

Result<ReportRequest> report_request_of(const Arguments& arguments, Console& console) {
  ReportRequest request;
  const auto output = arguments.text("--output");
  if (!output) return usage_error("missing option --output (-o) OUT.html");
  request.output = *output;
  std::vector<std::string> taken{arguments.operand(0)};
  if (arguments.operand_count() > 1) {
    request.stack = arguments.operand(1);
    taken.push_back(*request.stack);
  }
  if (!request.stack) {
    if (Result<void> none = check_nothing_of_stack(arguments); !none) return none.error();
  }
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  Result<void> checked = check_output("--output (-o)", *output, {".html"}, taken);
  if (!checked) return checked.error();

  auto options = report_options(arguments, console);
  if (!options) return options.error();
  request.options = *std::move(options);
  auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  request.preparation = *std::move(prepared);
  auto format = chosen_model_format(arguments);
  if (!format) return format.error();
  request.model_format = *std::move(format);
  return request;
}

std::string report_text(const Report& report, const std::string& output) {
  std::string text;
  for (const ReportGuarantee& guarantee : report.guarantees) {
    text +=
        std::to_string(guarantee.number) + ' ' + guarantee.name + ": " + name_of(guarantee.verdict);
    if (!guarantee.why.empty()) text += " (" + guarantee.why + ')';
    text += '\n';
  }
  return text + "written: " + printable(output) + '\n';
}

std::string report_json(const Report& report, const std::string& output,
                        const std::optional<StackInput>& input, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("written", output);
  json.member("bytes", report.html.size());
  write_report(json, report);
  if (input) write_preparation(json, *input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

// As check names them.
std::string failures_of(const Report& report) {
  std::vector<GuaranteeVerdict> failed;
  for (const ReportGuarantee& guarantee : report.guarantees) {
    if (guarantee.verdict != ReportVerdict::fails) continue;
    failed.push_back({guarantee.number, guarantee.name, false, {}, {}});
  }
  return failed_guarantees(failed);
}

Result<int> run_report(const Arguments& arguments, Console& console) {
  auto request = report_request_of(arguments, console);
  if (!request) return request.error();
  ReportOptions& options = request->options;
  auto model = read_model_input(arguments.operand(0), request->model_format, console);
  if (!model) return model.error();
  std::optional<StackInput> input;
  if (request->stack) {
    auto read = read_stack_input(*request->stack, request->preparation, console);
    if (!read) return read.error();
    input = *std::move(read);
    put_into_frame(*model, input->stack(), console);
    const Result<void> labelled =
        read_label_option(arguments, *input, options.check.correspondence);
    if (!labelled) return labelled.error();
  }
  const bool named = !model->about.name.empty() || (input && !input->stack().about.name.empty());
  if (options.title.empty() && !named) {
    options.title = std::filesystem::path(arguments.operand(0)).stem().string();
  }
  // The page is for others: where the files lie here says nothing to them.
  options.warnings = console.warnings();
  for (Warning& warning : options.warnings) {
    if (!warning.where.file.empty()) warning.where.file = file_name(warning.where.file);
  }
  const Result<Report> report = [&] {
    Progress progress(!console.quiet());
    options.execution.progress = progress.callback();
    return render_report(*model, input ? &input->stack() : nullptr, options);
  }();
  if (!report) return in_file(report.error(), arguments.operand(0));

  StagedFiles files;
  const auto staged = take_staged(
      io::stage_file(request->output, report->html, temporary_watcher()), files, console);
  if (!staged) return staged.error();
  std::string told;
  if (console.json()) {
    told = report_json(*report, request->output, input, console);
  } else if (!console.quiet()) {
    told = report_text(*report, request->output);
  }
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  if (report->pass()) return 0;
  console.say(failures_of(*report));
  return kGuaranteeFails;
}

}  // namespace

Command report_command() { return {report_usage(), run_report}; }

}  // namespace tetloft::cli
