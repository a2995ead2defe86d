// tetloft delaunay: the Delaunay triangulation of points in space.
#include <tetloft/tetloft.hpp>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/read_options.hpp"
#include "cli/signals.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage delaunay_usage() {
  return {
      "delaunay",
      "The Delaunay triangulation of points in space.",
      {"POINTS"},
      {{"--output", output_word("OUT", Contents::model),
        "write the tets: " + described_outputs(Contents::model), "-o"},
       format_option("--format", "POINTS", Contents::points),
       {"--engine",
        "NAME",
        "auto (default): slab where all points lie on two planes of constant z, else "
        "incremental; or one of these. The tets are the same",
        {},
        engine_words()},
       {"--threads", "N",
        "0 (default: all processors) to 1024; the slab engine uses two at most, the incremental "
        "one; the result is the same"},
       {"--work-limit", "N",
        "tets per point that may be made before the points are refused with exit code 7 (default "
        "1000; under 2^15 points as for 2^15)"},
       kAsciiOption,
       kCompressOption,
       kJsonOption,
       kQuietOption,
       kHelpOption},
      "The seconds told are those of the triangulation alone."};
}

// Two skew lines of 8,000 points each have as many tets as fit, in some gigabytes.
constexpr double kTetsPerPoint = 1000;
constexpr std::size_t kFewPoints = std::size_t{1} << 15;

std::size_t most_tets(double limit, std::size_t points) {
  const double most = limit * static_cast<double>(std::max(points, kFewPoints));
  // 0 would mean no limit; what is beyond 2^30 is refused in any case.
  return static_cast<std::size_t>(std::clamp(most, 1.0, 0x1p31));
}

void warn_if_flat(const Delaunay3& delaunay, Console& console) {
  if (delaunay.dimension >= 3) return;
  const char* const shape = delaunay.dimension == 2   ? "coplanar"
                            : delaunay.dimension == 1 ? "collinear"
                            : delaunay.dimension == 0 ? "all the same"
                                                      : "missing";
  console.warn({std::string("the points are ") + shape + ": there are no tets", {}});
}

IdVector<TetId, TetVertices> tets_of(const TetMesh& mesh) {
  IdVector<TetId, TetVertices> tets;
  tets.reserve(mesh.tet_count());
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    if (mesh.is_live(TetId(t))) tets.push_back(mesh.vertices(TetId(t)));
  }
  return tets;
}

Result<int> run_delaunay(const Arguments& arguments, Console& console) {
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  const auto limit = work_limit_option(arguments, kTetsPerPoint);
  if (!limit) return limit.error();
  const auto engine = engine_option(arguments, "--engine");
  if (!engine) return engine.error();
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  const auto output = arguments.text("--output");
  if (output) {
    Result<void> checked = check_output("--output (-o)", *output,
                                        output_extensions(Contents::model), {arguments.operand(0)});
    if (!checked) return checked.error();
  }
  const auto format = chosen_format(arguments, "--format", Contents::points);
  if (!format) return format.error();
  ReadOptions reading;
  reading.format = *format;
  auto read = read_points(input_path(arguments.operand(0)), reading);
  if (!read) return read.error();
  for (const Warning& warning : read->warnings) console.warn(warning);
  const std::size_t points = read->points.size();
  const Stopwatch triangulating;
  const Result<Delaunay3> delaunay =
      delaunay3(read->points, {.engine = *engine,
                               .most_tets = most_tets(*limit, points),
                               .execution = {.threads = *threads}});
  const double seconds = triangulating.seconds();
  if (!delaunay) return in_file(delaunay.error(), arguments.operand(0));
  warn_if_flat(*delaunay, console);
  StagedFiles files;
  if (output) {
    Model mesh;
    mesh.points = IdVector<VertexId, Point3>(std::move(read->points));
    mesh.tets = tets_of(delaunay->mesh);
    Result<void> staged = take_staged(
        io::stage_model(*output, mesh, {*encoding, {}}, temporary_watcher()), files, console);
    if (!staged) return staged.error();
  }
  std::string told;
  if (console.json()) {
    JsonWriter json;
    json.begin_object();
    json.member("points", points);
    json.member("tets", delaunay->mesh.tet_count());
    json.member("seconds", seconds);
    json.member("duplicates", delaunay->duplicates);
    json.member("dimension", delaunay->dimension);
    json.member("engine", name_of(delaunay->engine));
    write_warnings(json, console.warnings());
    json.end_object();
    told = json.text();
  } else if (!console.quiet()) {
    told = counted(points, "point") + " (" + counted(delaunay->duplicates, "duplicate") + "), " +
           counted(delaunay->mesh.tet_count(), "tet") + ", " + readable_seconds(seconds) +
           " seconds\n";
    if (output) told += written_line(paths_of(files));
  }
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command delaunay_command() { return {delaunay_usage(), run_delaunay}; }

}  // namespace tetloft::cli
