// Long contour edges in equal parts.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>

#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/equal_parts.hpp"
#include "sections/validation.hpp"

namespace tetloft {

using namespace internal;

namespace {

// More parts than this in all are a slip in the unit of length.
constexpr double kMostInserted = 0x1p26;

// Equal parts no longer than `length`; a double, since there may be too many to count.
double parts_of(const Point2& a, const Point2& b, double length) {
  return std::max(1.0, std::ceil(std::hypot(b.x - a.x, b.y - a.y) / length));
}

template <class Visit>
void for_each_edge(const Contour& contour, const Visit& visit) {
  const std::size_t n = contour.vertices.size();
  for (std::size_t k = 0; k < n; ++k) visit(contour.vertices[k], contour.vertices[(k + 1) % n]);
}

Result<Refined> refine_all(const SectionStack& stack, double length, const Execution& execution) {
  if (auto good = check_length(length, "the length to refine to"); !good) return good.error();
  WatchedWork work(execution, 2 * stack.sections.size() + 1);
  const Result<void> valid = sections::validate_within(stack, work);
  if (!valid) return valid.error();
  double inserted = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for_each_edge(contour, [&](const Point2& a, const Point2& b) {
        inserted += parts_of(a, b, length) - 1;
      });
    }
  }
  if (!(inserted <= kMostInserted)) {
    return Error{
        ErrorCode::usage,
        "refining to this length would insert more than 2^26 vertices: is its unit that of "
        "the contours?",
        {}};
  }
  Refined result{stack, 0};
  for (Section& section : result.stack.sections) {
    for (Contour& contour : section.contours) {
      std::vector<Point2> points;
      for_each_edge(contour, [&](const Point2& a, const Point2& b) {
        sections::append_parts(a, b, static_cast<std::size_t>(parts_of(a, b, length)), points);
      });
      result.inserted += points.size() - contour.vertices.size();
      contour.vertices = std::move(points);
    }
  }
  work.step_done_go_on();
  const Result<void> still = sections::validate_within(result.stack, work);
  if (!accepted(still)) {
    Error error = still.error();
    error.message = "refined contours, bent by rounding, are not valid: " + error.message;
    return error;
  }
  return result;
}

}  // namespace

Result<Refined> refine(const SectionStack& stack, double length, const Execution& given) {
  return guard_threads(
      given, [&](const Execution& execution) { return refine_all(stack, length, execution); });
}

}  // namespace tetloft
