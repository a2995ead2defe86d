// tetloft delaunay: the Delaunay triangulation of points in space.
#include <tetloft/tetloft.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/point_questions.hpp"
#include "cli/read_options.hpp"
#include "cli/signals.hpp"
#include "cli/triangulated_once.hpp"
#include "cli/voronoi_output.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage delaunay_usage() {
  std::vector<Option> options{{"--output", output_word("OUT", Contents::model),
                               "write the tets: " + described_outputs(Contents::model), "-o"}};
  for (Option& option : point_question_options()) options.push_back(std::move(option));
  options.push_back(voronoi_option());
  const std::vector<Option> others{
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
      kHelpOption};
  options.insert(options.end(), others.begin(), others.end());
  return {"delaunay",
          "The Delaunay triangulation of points in space.",
          {"POINTS"},
          std::move(options),
          "The seconds told are those of the triangulation alone. With --nearest or --locate "
          "--engine and --work-limit are those of what --output writes."};
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

struct DelaunayRequest {
  std::string input;
  std::string format;
  std::optional<PointQuestion> question;
  std::optional<std::string> output;
  std::optional<std::string> voronoi;
  Encoding encoding = Encoding::binary;
  DelaunayEngine engine = DelaunayEngine::automatic;
  double limit = kTetsPerPoint;
  unsigned threads = 0;
};

Result<DelaunayRequest> delaunay_request_of(const Arguments& arguments) {
  DelaunayRequest request;
  request.input = arguments.operand(0);
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  request.threads = *threads;
  const auto limit = work_limit_option(arguments, kTetsPerPoint);
  if (!limit) return limit.error();
  request.limit = *limit;
  const auto engine = engine_option(arguments, "--engine");
  if (!engine) return engine.error();
  request.engine = *engine;
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  request.encoding = *encoding;
  const auto question = point_question(arguments);
  if (!question) return question.error();
  request.question = *question;
  request.output = arguments.text("--output");
  request.voronoi = arguments.text("--voronoi");
  std::vector<std::string> inputs{request.input};
  if (request.question) inputs.push_back(request.question->queries);
  if (request.voronoi) {
    Result<void> checked = check_output("--voronoi", *request.voronoi, {kVoronoiExtension}, inputs);
    if (!checked) return checked.error();
    inputs.push_back(*request.voronoi);
  }
  if (request.output) {
    Result<void> checked =
        check_output("--output (-o)", *request.output, output_extensions(Contents::model), inputs);
    if (!checked) return checked.error();
  }
  const auto format = chosen_format(arguments, "--format", Contents::points);
  if (!format) return format.error();
  request.format = *format;
  return request;
}

void write_common(JsonWriter& json, std::size_t tets, double seconds, std::size_t duplicates,
                  int dimension) {
  json.member("tets", tets);
  json.member("seconds", seconds);
  json.member("duplicates", duplicates);
  json.member("dimension", dimension);
}

// The result of a command that only triangulates.
std::string summary_of(const Delaunay3& delaunay, std::size_t points, double seconds,
                       const StagedFiles& files, const Console& console) {
  if (console.json()) {
    JsonWriter json;
    json.begin_object();
    json.member("points", points);
    write_common(json, delaunay.mesh.tet_count(), seconds, delaunay.duplicates, delaunay.dimension);
    json.member("engine", name_of(delaunay.engine));
    write_warnings(json, console.warnings());
    json.end_object();
    return json.text();
  }
  if (console.quiet()) return {};
  std::string told = counted(points, "point") + " (" + counted(delaunay.duplicates, "duplicate") +
                     "), " + counted(delaunay.mesh.tet_count(), "tet") + ", " +
                     readable_seconds(seconds) + " seconds\n";
  if (!files.empty()) told += written_line(paths_of(files));
  return told;
}

// That of one that answers questions, too: answers are the result, --quiet or not.
std::string answered(const PointAnswers& answers, std::size_t points, const Console& console) {
  if (!console.json()) return lines_of(answers);
  JsonWriter json;
  json.begin_object();
  json.member("points", points);
  write_common(json, answers.tets, answers.seconds, points - answers.vertices, answers.dimension);
  write_answers(json, answers);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

// Triangulates, and completes the output if there is one.
Result<std::string> triangulate(const DelaunayRequest& request, std::vector<Point3> points,
                                StagedFiles& files, Console& console) {
  const std::size_t count = points.size();
  const Stopwatch triangulating;
  const Result<Delaunay3> delaunay =
      delaunay3(points, {.engine = request.engine,
                         .most_tets = most_tets(request.limit, count),
                         .execution = {.threads = request.threads}});
  const double seconds = triangulating.seconds();
  if (!delaunay) return in_file(delaunay.error(), request.input);
  warn_if_flat(*delaunay, console);
  if (request.output) {
    Model mesh;
    mesh.points = IdVector<VertexId, Point3>(std::move(points));
    mesh.tets = tets_of(delaunay->mesh);
    Result<void> staged = take_staged(
        io::stage_model(*request.output, mesh, {request.encoding, {}}, temporary_watcher()), files,
        console);
    if (!staged) return staged.error();
  }
  return summary_of(*delaunay, count, seconds, files, console);
}

Result<int> run_delaunay(const Arguments& arguments, Console& console) {
  const auto request = delaunay_request_of(arguments);
  if (!request) return request.error();
  ReadOptions reading;
  reading.format = request->format;
  auto read = read_points(input_path(request->input), reading);
  if (!read) return read.error();
  for (const Warning& warning : read->warnings) console.warn(warning);
  const std::size_t points = read->points.size();
  std::optional<PointAnswers> answers;
  StagedFiles files;
  {
    // Gone, with its memory, before the output is triangulated.
    TriangulatedOnce triangulated(read->points, request->threads);
    if (request->question) {
      Result<PointAnswers> found = answer(*request->question, triangulated, console);
      if (!found) return in_file(found.error(), request->input);
      answers = *std::move(found);
    }
    if (request->voronoi) {
      const auto cells = voronoi_polyhedra(triangulated);
      if (!cells) return in_file(cells.error(), request->input);
      Result<void> staged = take_staged(
          io::stage_polyhedra(*request->voronoi, *cells, request->encoding, temporary_watcher()),
          files, console);
      if (!staged) return staged.error();
    }
  }
  std::string told;
  if (!answers || request->output) {
    Result<std::string> summary = triangulate(*request, std::move(read->points), files, console);
    if (!summary) return summary.error();
    told = *std::move(summary);
  }
  if (answers) told = answered(*answers, points, console);
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command delaunay_command() { return {delaunay_usage(), run_delaunay}; }

}  // namespace tetloft::cli
