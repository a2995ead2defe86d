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

// Points are computed from the edge's lower end, whichever way the contour runs.
void append_parts(const Point2& a, const Point2& b, double parts, std::vector<Point2>& points) {
  const bool forward = canonical_less(a, b);
  const Point2& low = forward ? a : b;
  const Point2& high = forward ? b : a;
  points.push_back(a);
  const auto n = static_cast<std::size_t>(parts);
  for (std::size_t k = 1; k < n; ++k) {
    const double t = static_cast<double>(forward ? k : n - k) / parts;
    const Point2 p{low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)};
    // Parts below the spacing of doubles are none.
    if (p != points.back() && p != b) points.push_back(p);
  }
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
        append_parts(a, b, parts_of(a, b, length), points);
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
