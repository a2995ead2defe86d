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
       kThreadsOption,
       kAsciiOption,
       kCompressOption,
       kJsonOption,
       kQuietOption,
       kHelpOption},
      "Pieces are given in any order, all of one plan, and each slab in one of them; what "
      "is wrong, missing, doubled, damaged or foreign is named. Nothing is written when the "
      "command fails."};
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

std::string to_text(const StagedJoin& joined, const ModelOutputs& outputs, std::size_t pieces) {
  return counted(pieces, "piece") +
         (joined.settled == 0 ? std::string()
                              : ", " + counted(joined.settled, "slab") + " built from the plan") +
         ": " + counted(joined.report.tets, "tet") + ", " + std::to_string(joined.report.vertices) +
         " vertices, " + counted(joined.report.components, "component") + ", volume " +
         readable(joined.report.volume) + '\n' + written_line(paths_of(outputs));
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
  const auto outputs = model_outputs(arguments);
  if (!outputs) return outputs.error();
  JoinOptions options;
  options.plan = arguments.text("--plan").value_or(std::string());
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  options.execution.threads = *threads;
  std::vector<std::string> pieces;
  for (std::size_t k = 0; k < arguments.operand_count(); ++k) {
    pieces.push_back(arguments.operand(k));
  }
  auto joined = staged_join(pieces, options, *outputs, console);
  if (!joined) return joined.error();
  std::string told;
  if (console.json()) {
    told = to_json(*joined, *outputs, pieces.size(), console);
  } else if (!console.quiet()) {
    told = to_text(*joined, *outputs, pieces.size());
  }
  const Result<void> done = deliver_with(joined->files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command join_command() { return {join_usage(), run_join}; }

}  // namespace tetloft::cli
