// See point_questions.hpp.
#include "cli/point_questions.hpp"

#include <tetloft/formats.hpp>

#include "cli/read_options.hpp"

namespace tetloft::cli {

namespace {

constexpr const char* kNearest = "--nearest";
constexpr const char* kLocate = "--locate";

std::vector<std::uint32_t> indices_of(const Location3& location) {
  std::vector<std::uint32_t> indices;
  for (const DelaunayVertex v : location.vertices) {
    if (v.valid()) indices.push_back(v.index);
  }
  return indices;
}

}  // namespace

std::vector<Option> point_question_options() {
  return {
      {kNearest, "QUERIES",
       "print, instead of a summary, a line for each point of this file (a format of POINTS; - is "
       "standard input): the index, from 0, of the nearest of POINTS, the lowest of equally near "
       "ones; none where there are no POINTS"},
      {kLocate, "QUERIES",
       "print a line for each point of this file: the smallest simplex that holds it, as vertex, "
       "edge, facet or tet and the increasing indices of its vertices, or outside; of duplicates "
       "the lowest index counts"},
  };
}

Result<std::optional<PointQuestion>> point_question(const Arguments& arguments) {
  const auto nearest = arguments.text(kNearest);
  const auto located = arguments.text(kLocate);
  if (nearest && located) {
    return usage_error("--nearest and --locate both choose what is printed; give one of them");
  }
  if (!nearest && !located) return std::optional<PointQuestion>();
  PointQuestion question;
  question.kind = nearest ? PointQuestion::Kind::nearest : PointQuestion::Kind::locate;
  question.queries = nearest ? *nearest : *located;
  if (question.queries == "-" && arguments.operand(0) == "-") {
    return usage_error(std::string("option ") + (nearest ? kNearest : kLocate) +
                       ": standard input holds POINTS already");
  }
  return std::optional(question);
}

Result<PointAnswers> answer(const PointQuestion& question, TriangulatedOnce& points,
                            Console& console) {
  const auto queries = read_points(input_path(question.queries));
  if (!queries) return queries.error();
  console.warn_of(question.queries, queries->warnings);
  const Execution& execution = points.execution();
  const auto made = points.get();
  if (!made) return made.error();
  const DelaunayTriangulation3* const triangulation = *made;
  PointAnswers answers;
  answers.seconds = points.seconds();
  answers.kind = question.kind;
  answers.vertices = triangulation->vertex_count();
  answers.tets = triangulation->tet_count();
  answers.dimension = triangulation->dimension();
  if (question.kind == PointQuestion::Kind::nearest) {
    auto nearest = triangulation->nearest_vertex(queries->points, execution);
    if (!nearest) return in_file(nearest.error(), question.queries);
    answers.nearest = *std::move(nearest);
  } else {
    auto locations = triangulation->locate(queries->points, execution);
    if (!locations) return in_file(locations.error(), question.queries);
    answers.locations = *std::move(locations);
  }
  return answers;
}

std::string lines_of(const PointAnswers& answers) {
  std::string lines;
  for (const DelaunayVertex v : answers.nearest) {
    lines += v.valid() ? std::to_string(v.index) : "none";
    lines += '\n';
  }
  for (const Location3& location : answers.locations) {
    lines += name_of(location.kind);
    for (const std::uint32_t index : indices_of(location)) lines += ' ' + std::to_string(index);
    lines += '\n';
  }
  return lines;
}

void write_answers(JsonWriter& json, const PointAnswers& answers) {
  if (answers.kind == PointQuestion::Kind::nearest) {
    json.key("nearest");
    json.begin_array();
    for (const DelaunayVertex v : answers.nearest) {
      json.value(v.valid() ? std::optional(v.index) : std::nullopt);
    }
  } else {
    json.key("locations");
    json.begin_array();
    for (const Location3& location : answers.locations) {
      json.begin_object();
      json.member("kind", name_of(location.kind));
      json.member("vertices", indices_of(location));
      json.end_object();
    }
  }
  json.end_array();
}

}  // namespace tetloft::cli
