// See reconstruct_piece.hpp.
#include "cli/reconstruct_piece.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/read_options.hpp"
#include "cli/signals.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_source.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// Everything else that shapes a solid was decided by the plan.
constexpr std::array<std::string_view, 9> kTaken{"--plan",    "--slabs", "--output",
                                                 "--threads", "--ascii", "--compress",
                                                 "--json",    "--quiet", "--help"};

Result<void> check_options(const Arguments& arguments, const std::vector<Option>& options) {
  for (const std::string_view option : {"--plan", "--slabs", "--output"}) {
    if (!arguments.has(option)) {
      return usage_error("a piece takes --plan PLAN, --slabs A:B and --output PIECE.vtu: " +
                         std::string(option) + " is missing");
    }
  }
  for (const Option& option : options) {
    if (!arguments.has(option.name)) continue;
    if (std::find(kTaken.begin(), kTaken.end(), option.name) != kTaken.end()) continue;
    return usage_error("option " + std::string(option.name) +
                       " does not go with --plan: that is decided by the plan, or said of the "
                       "joined solid");
  }
  return {};
}

Result<SlabRange> slabs_of(const std::string& text) {
  const auto number = [](std::string_view word) -> std::optional<std::size_t> {
    std::size_t value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
  };
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const auto first = number(std::string_view(text).substr(0, colon));
    const auto end = number(std::string_view(text).substr(colon + 1));
    if (first && end) return SlabRange{*first, *end};
  }
  return usage_error("option --slabs: " + io::in_quotes(text) +
                     " is no range of slabs A:B, those from A to B - 1");
}

Error another_stack(const std::string& input, const PlanSource& planned) {
  Error error{ErrorCode::invalid_input,
              "it is not the stack of the plan, which was read from " +
                  io::in_quotes(planned.name) + " of " + std::to_string(planned.bytes) + " bytes",
              {}};
  error.where.file = input;
  return error;
}

// The sections come from the plan: another stack would go unnoticed. None may be given.
Result<void> check_input(const std::optional<std::string>& given, const std::string& plan) {
  if (!given || *given == "-") return {};
  const std::string& input = *given;
  const Result<PlanSummary> planned = read_plan(plan);
  if (!planned) return planned.error();
  if (planned->source == PlanSource{}) return {};
  std::error_code code;
  const auto bytes = std::filesystem::file_size(input_path(input), code);
  if (!code && bytes != planned->source.bytes) return another_stack(input, planned->source);
  // Of more, reading all would cost many pieces more than building them.
  constexpr std::uint64_t kCheap = std::uint64_t{1} << 26;
  if (!code && bytes > kCheap) {
    const Result<std::uint64_t> sampled =
        internal::pieces::sampled_checksum(input_path(input), bytes);
    if (!sampled) return sampled.error();
    if (*sampled != planned->source.sampled) return another_stack(input, planned->source);
    return {};
  }
  const Result<PlanSource> source = plan_source(input_path(input));
  if (!source) return source.error();
  if (source->checksum != planned->source.checksum) return another_stack(input, planned->source);
  return {};
}

std::string text_of(const internal::pieces::StagedPiece& piece, const std::string& path) {
  const PieceSummary& of = piece.summary;
  std::string text = "slabs " + std::to_string(of.first) + ':' + std::to_string(of.end) + " of " +
                     std::to_string(of.sections - 1) + ": " + counted(piece.report.tets, "tet") +
                     ", " + std::to_string(piece.report.vertices) + " vertices\n";
  if (!of.open.empty()) {
    text += counted(of.open.size(), "slab") +
            " left open, which need finer contours beyond the piece: joining builds them from the "
            "plan\n";
  }
  return text + written_line({path});
}

std::string json_of(const internal::pieces::StagedPiece& piece, const std::string& path,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("slabs", std::array{piece.summary.first, piece.summary.end});
  json.member("of", piece.summary.sections - 1);
  json.member("open", piece.summary.open);
  json.member("tets", piece.report.tets);
  json.member("vertices", piece.report.vertices);
  json.member("work", piece.report.work);
  json.member("written", path);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

}  // namespace

Result<PlanSource> source_of(const std::string& input) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(input, code);
  const bool stream = std::filesystem::exists(status) &&
                      !std::filesystem::is_regular_file(status) &&
                      !std::filesystem::is_directory(status);
  if (input == "-" || stream) return PlanSource{};  // it was read, once, as the stack
  return plan_source(input_path(input));
}

Result<int> reconstruct_piece(const Arguments& arguments, const std::vector<Option>& known,
                              Console& console) {
  if (Result<void> fine = check_options(arguments, known); !fine) return fine.error();
  const Result<SlabRange> slabs = slabs_of(*arguments.text("--slabs"));
  if (!slabs) return slabs.error();
  std::optional<std::string> input;
  if (arguments.operand_count() > 0) input = arguments.operand(0);
  const std::string plan = *arguments.text("--plan");
  const std::string output = *arguments.text("--output");
  std::vector<std::string> taken{plan};
  if (input) taken.insert(taken.begin(), *input);
  Result<void> fine = check_output("--output (-o)", output, {".vtu"}, taken);
  if (!fine) return fine.error();
  PieceOptions options;
  const auto encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  options.encoding = *encoding;
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  options.execution.threads = *threads;
  if (fine = check_input(input, plan); !fine) return fine.error();
  Result<internal::pieces::StagedPiece> piece = [&] {
    Progress progress(!console.quiet());
    options.execution.progress = progress.callback();
    return internal::pieces::stage_piece(output, plan, *slabs, options, temporary_watcher());
  }();
  if (!piece) return in_file(piece.error(), plan);
  console.warn_of(input.value_or(plan), piece->warnings);
  std::string told;
  if (console.json()) {
    told = json_of(*piece, output, console);
  } else if (!console.quiet()) {
    told = text_of(*piece, output);
  }
  const Result<void> done = deliver_with(piece->files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace tetloft::cli
