// Reading stacks, labels and the options of correspondence.
#include "cli/stack_input.hpp"

#include <algorithm>
#include <cmath>

#include "io/numbers.hpp"

namespace tetloft::cli {

std::vector<Option> stack_options() {
  return {
      {"--correspondence", "RULE",
       "which contours form one component: overlap (default) or reverse (reverse tetrahedra)"},
      {"--overlap", "TAU",
       "overlap unites two regions above this ratio of areas, from 0 to below 1 (default 0.02)"},
      {"--labels", "FILE", "lines \"section contour label\", zero-based, # comments"},
      {"--snap", "BITS",
       "first round x and y to a lattice of 2^-BITS (1 to 50) of the largest coordinate"},
  };
}

Result<CorrespondenceOptions> correspondence_options(const Arguments& arguments, Console& console) {
  CorrespondenceOptions options;
  if (const auto rule = arguments.text("--correspondence")) {
    if (*rule != "overlap" && *rule != "reverse") {
      return usage_error("option --correspondence: " + io::in_quotes(*rule) +
                         " is neither overlap nor reverse");
    }
    options.criterion = *rule == "overlap" ? Criterion::overlap : Criterion::reverse;
  }
  const auto tau = arguments.number("--overlap");
  if (!tau) return tau.error();
  if (tau->has_value()) {
    if (**tau < 0 || **tau >= 1) {
      return usage_error("option --overlap: " + io::in_quotes(*arguments.text("--overlap")) +
                         " is not from 0 to below 1");
    }
    options.tau = **tau;
    if (options.criterion == Criterion::reverse) {
      console.warn({"--overlap has no effect with --correspondence reverse", {}});
    }
  }
  return options;
}

Result<std::optional<int>> snap_bits(const Arguments& arguments) {
  const auto bits = arguments.integer("--snap", 1, 50);
  if (!bits) return bits.error();
  return bits->has_value() ? std::optional(static_cast<int>(**bits)) : std::nullopt;
}

namespace {

SnapReport report_of(const Snapped& snapped, std::size_t vertices_before) {
  constexpr std::size_t kFew = 5;
  SnapReport report;
  report.bits = snapped.bits;
  report.lattice = snapped.lattice;
  report.moved = snapped.moved.size();
  report.removed = vertices_before - snapped.stack.vertex_count();
  for (const MovedVertex& m : snapped.moved) {
    report.largest_move =
        std::max(report.largest_move, std::hypot(m.to.x - m.from.x, m.to.y - m.from.y));
    if (report.first.size() < kFew) report.first.push_back(m);
  }
  return report;
}

}  // namespace

Result<StackInput> read_stack_input(const std::string& path, std::optional<int> snap,
                                    Console& console) {
  Result<ReadStack> read = read_cnt(path);
  if (!read) return read.error();
  for (const Warning& warning : read->warnings) console.warn(warning);
  StackInput input{std::move(read->stack), {}};
  if (!snap) return input;

  Result<Snapped> snapped = tetloft::snap(input.stack, *snap);
  if (!snapped) {
    Error error = snapped.error();
    if (error.where.file.empty()) error.where.file = path;
    return error;
  }
  input.snapped = report_of(*snapped, input.stack.vertex_count());
  input.stack = std::move(snapped->stack);
  if (input.snapped->bits != *snap) {
    console.warn({std::string("a lattice of ") + std::to_string(*snap) +
                      " bits makes contours touch or degenerate; " +
                      std::to_string(input.snapped->bits) + " bits were taken",
                  {}});
  }
  return input;
}

Result<std::vector<Label>> read_label_option(const Arguments& arguments,
                                             const SectionStack& stack) {
  const auto path = arguments.text("--labels");
  if (!path) return std::vector<Label>();
  Result<std::vector<Label>> labels = read_labels(*path);
  if (!labels) return labels;
  for (const Label& label : *labels) {
    const bool known = label.section.index() < stack.sections.size() &&
                       label.contour.index() < stack.sections[label.section].contours.size();
    if (known) continue;
    Error error{ErrorCode::invalid_input, "the label names a contour that the stack lacks", {}};
    error.where.file = *path;
    error.where.section = label.section.index();
    error.where.contour = label.contour.index();
    return error;
  }
  return labels;
}

void write_snap(JsonWriter& json, const SnapReport& report) {
  json.key("snap");
  json.begin_object();
  json.member("bits", report.bits);
  json.member("lattice", report.lattice);
  json.member("moved", report.moved);
  json.member("removed", report.removed);
  json.member("largest_move", report.largest_move);
  json.key("first_moved");
  json.begin_array();
  for (const MovedVertex& m : report.first) {
    json.begin_object();
    json.member("section", m.section.index());
    json.member("contour", m.contour.index());
    json.member("vertex", m.vertex);
    for (const auto& [name, p] : {std::pair{"from", m.from}, std::pair{"to", m.to}}) {
      json.key(name);
      json.begin_array();
      json.value(p.x);
      json.value(p.y);
      json.end_array();
    }
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

std::string describe_snap(const SnapReport& report) {
  std::string text =
      "snapped to multiples of " + readable(report.lattice) + " (" + std::to_string(report.bits) +
      " bits): " + (report.moved == 1 ? "1 vertex" : std::to_string(report.moved) + " vertices") +
      " moved, by " + readable(report.largest_move) + " at most; " +
      std::to_string(report.removed) + " of them removed\n";
  for (const MovedVertex& m : report.first) {
    text += "  section " + std::to_string(m.section.index()) + ", contour " +
            std::to_string(m.contour.index()) + ", vertex " + std::to_string(m.vertex) + ": (";
    io::append_number(text, m.from.x);
    text += ", ";
    io::append_number(text, m.from.y);
    text += ") to (";
    io::append_number(text, m.to.x);
    text += ", ";
    io::append_number(text, m.to.y);
    text += ")\n";
  }
  if (report.moved > report.first.size()) {
    text += "  and ";
    text += std::to_string(report.moved - report.first.size()) + " more\n";
  }
  return text;
}

}  // namespace tetloft::cli
