// tetloft join: the pieces of a planned stack become one solid.
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/signals.hpp"
#include "pieces/piece_file.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

using internal::pieces::StagedJoin;

Usage join_usage() {
  Usage usage{
      "join",
      "Pieces of a planned stack become one solid.",
      {"PIECE"},
      {{"--output", output_word("OUT", Contents::model),
        "the solid: " + described_outputs(Contents::model), "-o"},
       {"--surface", "FILE",
        "its boundary: " + described_outputs(Contents::surface) +
            "; this or --output must be given"},
       {"--plan", "PLAN",
        "the plan of the pieces: needed where slabs were left open at the ends of pieces, "
        "which are built from it now"},
       {"--index", "",
        "write OUT.pvtu, which lists the pieces and leaves the solid in them; pieces with slabs "
        "left open are written anew beside it (OUT_0.vtu, ...)"},
       kThreadsOption,
       kAsciiOption,
       kCompressOption,
       kJsonOption,
       kQuietOption,
       kHelpOption},
      "Pieces are given in any order, all of one plan, and each slab in one of them; what "
      "is wrong, missing, doubled, damaged or foreign is named. A .pvtu stands for the pieces that "
      "it lists. Nothing is written when the command fails."};
  usage.repeats = true;
  return usage;
}

std::string to_json(const StagedJoin& joined, const ModelOutputs& outputs, std::size_t pieces,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("pieces", pieces);
  json.member("settled", joined.settled);
  json.member("slices", joined.report.slices);
  json.member("vertices", joined.report.vertices);
  json.member("tets", joined.report.tets);
  json.member("components", joined.report.components);
  json.member("volume", joined.report.volume);
  json.member("written", paths_of(outputs));
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string settled_text(std::size_t slabs) {
  if (slabs == 0) return {};
  return ", " + counted(slabs, "slab") + " built from the plan";
}

std::string to_text(const StagedJoin& joined, const ModelOutputs& outputs, std::size_t pieces) {
  return counted(pieces, "piece") + settled_text(joined.settled) + ": " +
         counted(joined.report.tets, "tet") + ", " + std::to_string(joined.report.vertices) +
         " vertices, " + counted(joined.report.components, "component") + ", volume " +
         readable(joined.report.volume) + '\n' + written_line(paths_of(outputs));
}

std::string index_json(const internal::pieces::StagedIndex& staged, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("pieces", staged.index.pieces.size());
  json.member("settled", staged.index.settled);
  json.member("tets", staged.index.tets);
  json.member("components", staged.index.components);
  json.member("listed", staged.index.pieces);
  json.member("written", paths_of(staged.files));
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string index_text(const internal::pieces::StagedIndex& staged) {
  return counted(staged.index.pieces.size(), "piece") + settled_text(staged.index.settled) + ": " +
         counted(staged.index.tets, "tet") + ", " + counted(staged.index.components, "component") +
         '\n' + written_line(paths_of(staged.files));
}

// Those that indices list, too.
Result<std::vector<std::string>> pieces_of(const Arguments& arguments) {
  std::vector<std::string> paths;
  for (std::size_t k = 0; k < arguments.operand_count(); ++k) {
    paths.push_back(arguments.operand(k));
  }
  return internal::pieces::listed_pieces(paths);
}

// What no output may overwrite.
std::vector<std::string> inputs_of(const Arguments& arguments,
                                   const std::vector<std::string>& pieces) {
  std::vector<std::string> inputs = pieces;
  for (std::size_t k = 0; k < arguments.operand_count(); ++k) {
    inputs.push_back(arguments.operand(k));
  }
  if (const auto plan = arguments.text("--plan")) inputs.push_back(*plan);
  return inputs;
}

Result<void> check_against(const std::vector<std::string>& inputs, const ModelOutputs& outputs) {
  if (outputs.solid) {
    Result<void> fine = check_output("--output (-o)", *outputs.solid, {}, inputs);
    if (!fine) return fine;
  }
  if (!outputs.surface) return {};
  return check_output("--surface", *outputs.surface, {}, inputs);
}

Result<JoinOptions> options_of(const Arguments& arguments) {
  JoinOptions options;
  options.plan = arguments.text("--plan").value_or(std::string());
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  options.execution.threads = *threads;
  const auto encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  options.encoding = *encoding;
  return options;
}

Result<int> run_index(const Arguments& arguments, Console& console) {
  const auto output = arguments.text("--output");
  if (!output) return usage_error("--index needs --output (-o) OUT.pvtu");
  if (arguments.has("--surface")) {
    return usage_error("option --surface does not go with --index: the solid stays in its pieces");
  }
  const Result<std::vector<std::string>> pieces = pieces_of(arguments);
  if (!pieces) return pieces.error();
  const Result<void> fine =
      check_output("--output (-o)", *output, {".pvtu"}, inputs_of(arguments, *pieces));
  if (!fine) return fine.error();
  const Result<JoinOptions> options = options_of(arguments);
  if (!options) return options.error();
  Result<internal::pieces::StagedIndex> staged =
      internal::pieces::stage_index(*output, *pieces, *options, temporary_watcher());
  if (!staged) return staged.error();
  console.warn_of({}, staged->index.warnings);
  std::string told;
  if (console.json()) {
    told = index_json(*staged, console);
  } else if (!console.quiet()) {
    told = index_text(*staged);
  }
  const Result<void> done = deliver_with(staged->files, told, console);
  if (!done) return done.error();
  return 0;
}

// A solid alone need not be in memory; its boundary is found in memory.
Result<StagedJoin> staged_join(const std::vector<std::string>& pieces, const JoinOptions& options,
                               const ModelOutputs& outputs, Console& console) {
  if (!outputs.surface) {
    Result<StagedJoin> joined = internal::pieces::stage_joined(
        *outputs.solid, pieces, options, {outputs.encoding, outputs.format}, temporary_watcher());
    if (joined) console.warn_of({}, joined->warnings);
    return joined;
  }
  Result<Joined> joined = join_pieces(pieces, options);
  if (!joined) return joined.error();
  console.warn_of({}, joined->warnings);
  auto files = stage_model(joined->model, outputs, console, Tets::proven);
  if (!files) return files.error();
  return StagedJoin{joined->report, joined->settled, {}, std::move(*files)};
}

Result<int> run_join(const Arguments& arguments, Console& console) {
  if (arguments.has("--index")) return run_index(arguments, console);
  const auto outputs = model_outputs(arguments);
  if (!outputs) return outputs.error();
  const Result<JoinOptions> options = options_of(arguments);
  if (!options) return options.error();
  const Result<std::vector<std::string>> pieces = pieces_of(arguments);
  if (!pieces) return pieces.error();
  const Result<void> fine = check_against(inputs_of(arguments, *pieces), *outputs);
  if (!fine) return fine.error();
  Result<StagedJoin> joined = staged_join(*pieces, *options, *outputs, console);
  if (!joined) return joined.error();
  std::string told;
  if (console.json()) {
    told = to_json(*joined, *outputs, pieces->size(), console);
  } else if (!console.quiet()) {
    told = to_text(*joined, *outputs, pieces->size());
  }
  const Result<void> done = deliver_with(joined->files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command join_command() { return {join_usage(), run_join}; }

}  // namespace tetloft::cli
