// What may be asked of the points of `delaunay`: which is nearest, which simplex holds a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/json.hpp"
#include "cli/triangulated_once.hpp"

namespace tetloft::cli {

struct PointQuestion {
  enum class Kind : std::uint8_t { nearest, locate };
  Kind kind = Kind::nearest;
  std::string queries;  ///< a file of points, or "-"
};

struct PointAnswers {
  PointQuestion::Kind kind = PointQuestion::Kind::nearest;
  std::vector<DelaunayVertex> nearest;  ///< by query; indices are those of the points
  std::vector<Location3> locations;     ///< by query; the same
  std::size_t vertices = 0;             ///< distinct points
  std::size_t tets = 0;
  int dimension = -1;
  double seconds = 0;  ///< of the triangulation alone
};

/// --nearest and --locate.
[[nodiscard]] std::vector<Option> point_question_options();
/// The one that was given. Usage error where both were, or standard input is to be read twice.
[[nodiscard]] Result<std::optional<PointQuestion>> point_question(const Arguments& arguments);

/// Reads the queries and answers them.
[[nodiscard]] Result<PointAnswers> answer(const PointQuestion& question, TriangulatedOnce& points,
                                          Console& console);

/// A line for each query.
[[nodiscard]] std::string lines_of(const PointAnswers& answers);
/// The member "nearest" or "locations", an array.
void write_answers(JsonWriter& json, const PointAnswers& answers);

}  // namespace tetloft::cli
