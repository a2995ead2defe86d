// tetloft check: the five guarantees, exactly.
#include <optional>
#include <span>
#include <utility>

#include "cli/check_options.hpp"
#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/label_input.hpp"
#include "cli/progress.hpp"
#include "cli/stack_input.hpp"
#include "cli/verdicts.hpp"

namespace tetloft::cli {

namespace {

Usage check_usage() {
  Usage usage{"check",
              "The guarantees of a model, checked exactly against its input.",
              {input_word("MODEL", Contents::model), input_word("IN", Contents::stack)},
              stack_options(),
              "Give the options of correspondence, and --snap, as they were given to "
              "reconstruct. Exits with 1 if a guarantee fails."};
  for (const Option& option : check_option_list()) usage.options.push_back(option);
  for (const Option& option : {kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

std::string to_json(const CheckReport& report, const StackInput& input, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("pass", report.pass());
  json.key("guarantees");
  json.begin_array();
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    json.begin_object();
    json.member("number", verdict.number);
    json.member("name", verdict.name);
    json.member("pass", verdict.pass);
    json.member("not_asked", verdict.not_asked);
    write_failures(json, verdict.failures);
    json.end_object();
  }
  json.end_array();
  json.member("components", report.components);
  json.member("genus", report.genus);
  json.member("volume", report.volume);
  json.member("overshoot", report.overshoot);
  json.member("smallest_dihedral_degrees", report.smallest_dihedral_degrees);
  json.member("largest_split_ulps", report.largest_split_ulps);
  json.member("inner_vertices", report.inner_vertices);
  json.member("dropped_links", report.dropped_links);
  json.member("cavities", report.cavities);
  json.member("expected_cavities", report.expected_cavities);
  json.member("least_genus", report.least_genus);
  json.member("most_genus", report.most_genus);
  json.member("deviations", report.deviations);
  json.member("forced_voids", report.forced_voids);
  json.member("unrealisable_voids", report.unrealisable_voids);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string genus_text(const std::vector<long>& genus) {
  constexpr std::size_t kFew = 20;
  std::string text;
  for (std::size_t i = 0; i < genus.size() && i < kFew; ++i) {
    if (i != 0) text += ' ';
    text += std::to_string(genus[i]);
  }
  if (genus.size() > kFew) text += " …";
  return text.empty() ? "none" : text;
}

std::string cavities_text(const CheckReport& report) {
  const auto cavities = [](std::size_t n) {
    return std::to_string(n) + (n == 1 ? " cavity" : " cavities");
  };
  std::string text;
  if (report.cavities.has_value()) text += cavities(*report.cavities) + '\n';
  if (report.expected_cavities.has_value()) {
    const long least = report.least_genus.value_or(0);
    const long most = report.most_genus.value_or(0);
    text += "expected: " + cavities(*report.expected_cavities) + ", genus of all surfaces " +
            std::to_string(least) + (most == least ? "" : " to " + std::to_string(most)) + '\n';
  }
  if (report.deviations > 0) {
    text += counted(report.deviations, "place") + " where topology deviates, as the model says\n";
  }
  if (report.forced_voids + report.unrealisable_voids > 0) {
    text += "links of voids, as the model says: " + std::to_string(report.forced_voids) +
            " forced, " + std::to_string(report.unrealisable_voids) + " left out\n";
  }
  return text;
}

std::string to_text(const CheckReport& report, const StackInput& input) {
  std::string text;
  text += describe_preparation(input);
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    text += std::to_string(verdict.number) + ' ' + verdict.name + ": " +
            (verdict.pass ? "PASS" : "FAIL");
    if (!verdict.not_asked.empty()) text += " (not asked: " + verdict.not_asked + ')';
    text += '\n';
    for (const CheckFailure& failure : verdict.failures) {
      text += "    " + failure.what + ": " + std::to_string(failure.count) + '\n';
      for (const std::string& place : failure.places) text += "        " + place + '\n';
    }
  }
  text += counted(report.components, "component") +
          ", genus of boundary surfaces: " + genus_text(report.genus) + ", volume " +
          readable(report.volume) + '\n';
  text += cavities_text(report);
  text += "overshoot " + readable(report.overshoot) + " gaps, smallest dihedral angle " +
          readable(report.smallest_dihedral_degrees) + " degrees, inserted vertices at most " +
          readable(report.largest_split_ulps) + " ulps off their edges\n";
  if (report.dropped_links > 0) {
    text += counted(report.dropped_links, "link") +
            " left out, as the model says: no tets could "
            "realise " +
            (report.dropped_links == 1 ? "it\n" : "them\n");
  }
  if (report.inner_vertices > 0) {
    text += "not as reconstruct makes it: " + std::to_string(report.inner_vertices) +
            (report.inner_vertices == 1 ? " vertex" : " vertices") + " inside sections\n";
  }
  return text;
}

Result<int> run_check(const Arguments& arguments, Console& console) {
  auto chosen = check_options(arguments, console);
  if (!chosen) return chosen.error();
  CheckOptions options = *std::move(chosen);
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  const auto format = chosen_model_format(arguments);
  if (!format) return format.error();

  const std::string& path = arguments.operand(0);
  std::optional<Model> model;
  if (!is_index(path, *format)) {
    Result<Model> read = read_model_input(path, *format, console);
    if (!read) return read.error();
    model = std::move(*read);
  }
  const auto input = read_stack_input(arguments.operand(1), *prepared, console);
  if (!input) return input.error();
  const SectionStack& stack = input->stack();
  if (!model) {
    // Pieces stay where they are, unless they have to be moved.
    const Result<bool> moved = lies_elsewhere(path, stack);
    if (!moved) return moved.error();
    if (*moved) {
      Result<Model> joined = read_model_input(path, *format, console);
      if (!joined) return joined.error();
      model = std::move(*joined);
    }
  }
  if (model) put_into_frame(*model, stack, console);
  const Result<void> labelled = read_label_option(arguments, *input, options.correspondence);
  if (!labelled) return labelled.error();

  const Result<CheckReport> report = [&] {
    Progress progress(!console.quiet());
    options.execution.progress = progress.callback();
    if (model) return check(*model, stack, options);
    const std::string index = input_path(path);
    return check_pieces(std::span(&index, 1), stack, options);
  }();
  if (!report) return report.error();
  Result<void> told;
  if (console.json()) {
    told = console.deliver(to_json(*report, *input, console));
  } else if (!console.quiet()) {
    told = console.deliver(to_text(*report, *input));
  }
  if (!told) return told.error();
  if (report->pass()) return 0;
  console.say(failed_guarantees(report->guarantees));
  return kGuaranteeFails;
}

}  // namespace

Command check_command() { return {check_usage(), run_check}; }

}  // namespace tetloft::cli
