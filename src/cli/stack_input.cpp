// Reading stacks, labels and the options of correspondence.
#include "cli/stack_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "cli/file_formats.hpp"
#include "cli/progress.hpp"
#include "core/option_rules.hpp"
#include "core/spelling.hpp"
#include "io/numbers.hpp"
#include "io/stack_files.hpp"
#include "io/vtu_frame.hpp"
#include "pieces/piece_file.hpp"

namespace tetloft::cli {

using namespace internal;

std::vector<Option> stack_options() {
  std::vector<Option> options{
      {"--correspondence",
       "RULE",
       "which contours form one component: moved (default: they overlap as their surroundings move "
       "from section to section), overlap (as they lie), or reverse (reverse tetrahedra)",
       {},
       {"overlap", "reverse", "moved"}},
      {"--overlap", "TAU",
       "overlap and moved unite two regions above this ratio of areas, from 0 to below 1 (default "
       "0.02, 0.1)"},
      {"--no-chain", "",
       "do not continue oblique parts, whose neighbouring sections do not overlap, as they came"},
      {"--no-lone", "",
       "leave regions alone that nothing links, where the default joins them to the nearest one: "
       "for particles"},
      {"--voids",
       "RULE",
       "which holes form one cavity or tunnel, and what opens to the outside: overlap (default: "
       "they "
       "overlap, lean on, or come within a quarter of a gap of the outside), near or near=K (in "
       "place of the last, what nothing links goes to the nearest hole, or the outside, within K "
       "gaps; default 0.5; 0: nowhere), or free (nothing is decided)",
       {},
       {"overlap", "near", "free"}},
      {"--labels", "FILE", described_inputs(Contents::labels)},
  };
  for (const Option& option : preparation_options()) options.push_back(option);
  return options;
}

std::vector<Option> preparation_options() {
  std::vector<Option> options = read_option_list();
  for (const Option& option : mending_options()) options.push_back(option);
  options.push_back(
      {"--snap", "BITS",
       "first round x and y to a lattice of 2^-BITS (1 to 50) of the largest coordinate"});
  options.push_back(
      {"--refine", "LENGTH",
       "then divide contour edges longer than this: coarse contours can close a tunnel"});
  return options;
}

Option model_format_option() {
  return format_option("--model-format", input_word("MODEL", Contents::model), Contents::model);
}

Result<std::string> chosen_model_format(const Arguments& arguments) {
  return chosen_format(arguments, "--model-format", Contents::model);
}

namespace {

// The pieces that an index lists are all in memory here.
Result<Model> joined_model(const std::string& index, Console& console) {
  JoinOptions options;
  options.execution.threads = 1;
  Result<Joined> joined = join_pieces(std::span(&index, 1), options);
  if (!joined) return joined.error();
  console.warn_of(index, joined->warnings);
  return std::move(joined->model);
}

}  // namespace

Result<Model> read_model_input(const std::string& path, const std::string& format,
                               Console& console) {
  if (is_index(path, format)) {
    return joined_model(input_path(path), console);
  }
  ReadOptions reading;
  reading.format = format;
  Result<ReadModel> read = read_model(input_path(path), reading);
  if (!read) return read.error();
  for (const Warning& warning : read->warnings) console.warn(warning);
  return std::move(read->model);
}

bool is_index(const std::string& path, const std::string& format) {
  return format.empty() && internal::pieces::is_index(input_path(path));
}

Result<bool> lies_elsewhere(const std::string& path, const SectionStack& stack) {
  const std::string index = input_path(path);
  const auto listed = internal::pieces::listed_pieces(std::span(&index, 1));
  if (!listed) return listed.error();
  // All are of one plan, so one tells.
  const Result<Model> first = read_vtu(listed->front());
  if (!first) return first.error();
  return first->frame != stack.frame;
}

void put_into_frame(Model& model, const SectionStack& stack, Console& console) {
  if (model.frame == stack.frame) return;
  const bool told = !(model.frame == Frame{});
  if (!told && is_exact(stack.frame) && io::take_back(stack.frame, {}, model.points)) {
    model.frame = stack.frame;
    return;
  }
  console.warn({told ? "the planes of model and stack lie differently in their files"
                     : "the planes of the stack are turned in its file, and the model's does not "
                       "tell how: a .vtu does",
                {}});
}

namespace {

// "near=K", too.
Result<void> read_voids_option(const Arguments& arguments, VoidOptions& options) {
  const auto given = arguments.text("--voids");
  if (!given) return {};
  const std::vector<std::string_view> rules{"overlap", "near", "free"};
  const std::size_t equals = given->find('=');
  const std::string word = given->substr(0, equals);
  const auto rule = std::find(rules.begin(), rules.end(), word);
  if (rule == rules.end()) {
    return usage_error("option --voids: " + io::in_quotes(word) + " is not " + list_of(rules) +
                       did_you_mean(word, rules));
  }
  options.rule = static_cast<VoidRule>(rule - rules.begin());
  if (equals == std::string::npos) return {};
  if (options.rule != VoidRule::near) {
    return usage_error("option --voids: " + word + " takes no reach, near does");
  }
  const std::string value = given->substr(equals + 1);
  const io::ParsedNumber number = io::parse_number(value);
  if (!number.ok()) {
    return usage_error("option --voids: " + io::complaint(value, number.status));
  }
  if (!is_void_reach(number.value)) {
    return usage_error("option --voids: the reach " + io::in_quotes(value) + " is below 0");
  }
  options.reach = number.value;
  return {};
}

}  // namespace

Result<CorrespondenceOptions> correspondence_options(const Arguments& arguments, Console& console) {
  CorrespondenceOptions options;
  const auto rule = arguments.choice("--correspondence");
  if (!rule) return rule.error();
  if (rule->has_value()) options.criterion = static_cast<Criterion>(**rule);
  const auto tau = arguments.number("--overlap");
  if (!tau) return tau.error();
  if (tau->has_value()) {
    if (!is_overlap_ratio(**tau)) {
      return usage_error("option --overlap: " + io::in_quotes(*arguments.text("--overlap")) +
                         " is not from 0 to below 1");
    }
    options.tau = **tau;
    if (options.criterion == Criterion::reverse) {
      console.warn({"--overlap has no effect with --correspondence reverse", {}});
    }
  }
  options.chain = !arguments.has("--no-chain");
  options.lone = !arguments.has("--no-lone");
  const Result<void> voids = read_voids_option(arguments, options.voids);
  if (!voids) return voids.error();
  return options;
}

Result<Preparation> preparation(const Arguments& arguments) {
  Preparation result;
  auto read = read_options(arguments);
  if (!read) return read.error();
  result.read = *std::move(read);
  const auto bits = arguments.integer("--snap", kFewestSnapBits, kMostSnapBits);
  if (!bits) return bits.error();
  if (bits->has_value()) result.snap = static_cast<int>(**bits);
  const auto length = arguments.number("--refine");
  if (!length) return length.error();
  if (length->has_value() && !is_length(**length)) {
    return usage_error("option --refine: " + io::in_quotes(*arguments.text("--refine")) +
                       " is not above 0");
  }
  result.refine = *length;
  const auto mending = mending_of(arguments);
  if (!mending) return mending.error();
  result.mending = *mending;
  return result;
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

Result<StackInput> read_valid(const std::string& path, const ReadOptions& reading,
                              Console& console) {
  Result<ReadValidStack> read = read_valid_stack(path, reading);
  if (!read) return with_remedy(read.error());
  warn_of_reader(read->warnings, {}, console);
  StackInput input;
  input.name = read->stack.stack().about.name;
  input.unit = read->stack.stack().about.unit;
  input.given = std::move(read->stack);
  input.labels = std::move(read->labels);
  return input;
}

Result<StackInput> read_to_mend(const std::string& path, ReadOptions reading,
                                const Mending& mending, Console& console) {
  reading.validity = Validity::unchecked;
  Result<ReadStack> read = read_stack(path, reading);
  if (!read) return with_remedy(read.error());
  Result<MendedStack> mended = mend_read(*read, path, mending, console);
  if (!mended) return mended.error();
  StackInput input;
  input.name = read->stack.about.name;
  input.unit = read->stack.about.unit;
  input.given = std::move(mended->stack);
  input.planes = mended->planes;
  input.repaired = std::move(mended->repair);
  return input;
}

Result<StackInput> read_and_mend(const std::string& path, const Preparation& preparation,
                                 Console& console) {
  const Mending& mending = preparation.mending;
  ReadOptions reading = preparation.read;
  Progress progress(!console.quiet());
  reading.execution.progress = progress.callback();
  return mending.any() ? read_to_mend(path, reading, mending, console)
                       : read_valid(path, reading, console);
}

Result<void> snap_input(StackInput& input, int bits, Console& console) {
  Result<Snapped> snapped = snap(input.stack(), bits);
  if (!snapped) return snapped.error();
  input.snapped = report_of(*snapped, input.stack().vertex_count());
  input.given = std::move(snapped->stack);
  if (input.snapped->bits != bits) {
    console.warn({std::string("a lattice of ") + std::to_string(bits) +
                      " bits makes contours touch or degenerate; " +
                      std::to_string(input.snapped->bits) + " bits were taken",
                  {}});
  }
  return {};
}

Result<void> refine_input(StackInput& input, double length) {
  Result<Refined> refined = refine(input.stack(), length);
  if (!refined) return refined.error();
  input.inserted = refined->inserted;
  input.given = std::move(refined->stack);
  return {};
}

}  // namespace

Result<StackInput> read_stack_input(const std::string& operand, const Preparation& preparation,
                                    Console& console) {
  if (preparation.read.structure == kAllStructures) {
    return usage_error(
        "reconstruct alone takes all structures: choose one with --roi or --label (tetloft info "
        "lists them)");
  }
  const std::string path = input_path(operand);
  Result<StackInput> read = read_and_mend(path, preparation, console);
  if (!read) return read;
  StackInput input = std::move(read.value());
  Result<void> done;
  if (preparation.snap) done = snap_input(input, *preparation.snap, console);
  if (done && preparation.refine) done = refine_input(input, *preparation.refine);
  if (!done) return in_file(done.error(), path);
  return input;
}

Result<StackInput> open_stack_input(const Arguments& arguments, const std::string& operand,
                                    const Preparation& preparation, Console& console) {
  const std::string path = input_path(operand);
  const bool whole = preparation.mending.any() || preparation.snap || preparation.refine ||
                     arguments.has("--labels") || arguments.has("--repaired");
  if (whole || !io::is_read_by_section(path, preparation.read)) {
    return read_stack_input(operand, preparation, console);
  }
  Result<OpenedSections> opened = open_sections(path, preparation.read);
  if (!opened) return with_remedy(opened.error());
  warn_of_reader(opened->warnings, {}, console);
  StackInput input;
  input.opened = *std::move(opened);
  return input;
}

namespace {

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
      json.member(name, std::array{p.x, p.y});
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

}  // namespace

void write_preparation(JsonWriter& json, const StackInput& input) {
  write_mending(json, input.planes, input.repaired);
  if (input.snapped) write_snap(json, *input.snapped);
  if (input.inserted) {
    json.key("refine");
    json.begin_object();
    json.member("inserted", *input.inserted);
    json.end_object();
  }
}

std::string describe_preparation(const StackInput& input) {
  std::string text = describe_mending(input.planes, input.repaired);
  if (input.snapped) text += describe_snap(*input.snapped);
  if (input.inserted) {
    text += "refined: " + std::to_string(*input.inserted) + " vertices inserted on contours\n";
  }
  return text;
}

}  // namespace tetloft::cli
