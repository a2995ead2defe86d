// Exact validation of a stack of sections.
//
// The first defect in the order (section, contour, vertex) is reported. A contact belongs to
// the vertex that lies on something, a crossing to the start of the earlier edge. Contours
// without an interior and contours with bad coordinates are defects themselves; they take
// part in no contact.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/contacts.hpp"
#include "sections/validation.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::Defect;
using sections::kWholeContour;

const char* coordinate_reason(double x) {
  if (!std::isfinite(x)) return "coordinate is not finite";
  if (!(std::abs(x) < kLargestCoordinate)) return "coordinate is not below 2^1000";
  return nullptr;
}

const char* coordinate_reason(const Point2& p) {
  const char* reason = coordinate_reason(p.x);
  return reason != nullptr ? reason : coordinate_reason(p.y);
}

// Are all vertices on one line? A simple contour has zero area in no other case.
bool is_collinear(const std::vector<Point2>& vertices) {
  const Point2& a = vertices.front();
  const auto b =
      std::find_if(vertices.begin(), vertices.end(), [&](const Point2& p) { return !(p == a); });
  return std::all_of(b, vertices.end(),
                     [&](const Point2& p) { return p == a || orient2d(a, *b, p) == Sign::zero; });
}

// Is the contour usable for contact tests? If not, why.
std::optional<Defect> whole_contour_defect(const Contour& contour, std::size_t c) {
  const std::vector<Point2>& vertices = contour.vertices;
  if (vertices.size() < 3) return Defect{c, kWholeContour, "contour has fewer than three vertices"};
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (const char* reason = coordinate_reason(vertices[v])) return Defect{c, v, reason};
  }
  if (is_collinear(vertices)) return Defect{c, kWholeContour, "contour has zero area"};
  return std::nullopt;
}

// Do a → b and b → c overlap, turning back at b?
bool folds_back(const Point2& a, const Point2& b, const Point2& c) {
  return !(a == b) && !(b == c) && canonical_less(a, b) == canonical_less(c, b) &&
         orient2d(a, b, c) == Sign::zero;
}

// The first vertex of the contour that is wrong among its neighbours.
std::optional<Defect> local_defect(const Contour& contour, std::size_t c) {
  const std::vector<Point2>& vertices = contour.vertices;
  const std::size_t n = vertices.size();
  for (std::size_t v = 0; v < n; ++v) {
    const Point2& p = vertices[v];
    if (v > 0 && p == vertices[v - 1]) return Defect{c, v, "vertex repeats its predecessor"};
    if (v + 1 == n && p == vertices[0]) {
      return Defect{c, v, "first vertex is repeated at the end"};
    }
    if (folds_back(vertices[v == 0 ? n - 1 : v - 1], p, vertices[v + 1 == n ? 0 : v + 1])) {
      return Defect{c, v, "edge folds back on itself (spike)"};
    }
  }
  return std::nullopt;
}

// Only where there is some defect is the first one looked for; where there is none, the contours
// are nested.
std::optional<Defect> contour_defect(const Section& section, Nesting& nesting) {
  std::optional<Defect> first;
  std::vector<bool> usable(section.contours.size(), true);
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    const Contour& contour = section.contours[ContourId(c)];
    std::optional<Defect> defect = whole_contour_defect(contour, c);
    if (defect) {
      usable[c] = false;
    } else if (!first) {
      defect = local_defect(contour, c);
    }
    if (defect && !first) first = std::move(defect);
  }
  if (!first) {
    if (std::optional<Nesting> nested = sections::nest_without_contact(section)) {
      nesting = *std::move(nested);
      return std::nullopt;
    }
  }
  std::optional<Defect> contact = sections::first_contact(section, usable, first);
  TETLOFT_CHECK(contact || first);
  return contact ? contact : first;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// What to do about heights that do not increase.
std::string order_remedy(const std::vector<double>& heights, bool same) {
  if (same) return "put all contours of one height into one section";
  const auto rise = std::adjacent_find(heights.begin(), heights.end(),
                                       [](double a, double b) { return !(a > b); });
  return rise == heights.end() ? "the sections descend; put them in the opposite order"
                               : "the sections are not sorted; put them in the order of their z";
}

std::optional<std::string> height_defect(const std::vector<double>& heights, std::size_t s) {
  const double z = heights[s];
  if (const char* reason = coordinate_reason(z)) {
    return std::string("z: ") + reason + " (" + number(z) + ')';
  }
  if (s == 0) return std::nullopt;
  const double below = heights[s - 1];
  if (z > below) return std::nullopt;
  return "z does not increase (" + number(z) + " after " + number(below) +
         "): " + order_remedy(heights, z == below);
}

Error error_at(const Section& section, std::size_t s, const Defect& defect) {
  Error error{ErrorCode::invalid_input, defect.reason, {}};
  error.where.section = s;
  error.where.contour = defect.contour;
  if (defect.vertex != kWholeContour) {
    const Point2& p = section.contours[ContourId(defect.contour)].vertices[defect.vertex];
    error.where.vertex = defect.vertex;
    error.where.point = Point3{p.x, p.y, section.z};
  }
  return error;
}

}  // namespace

std::optional<Error> sections::height_error(const std::vector<double>& heights, std::size_t s) {
  const auto reason = height_defect(heights, s);
  if (!reason) return std::nullopt;
  Error error{ErrorCode::invalid_input, *reason, {}};
  error.where.section = s;
  return error;
}

Result<Nesting> sections::nest_section_if_valid(const Section& section, std::size_t s) {
  Nesting nesting;
  if (const auto defect = contour_defect(section, nesting)) return error_at(section, s, *defect);
  return nesting;
}

Error sections::no_section_error() {
  return {ErrorCode::invalid_input, "the stack has no section", {}};
}

Error sections::no_contour_error() {
  Error error{ErrorCode::invalid_input, "the stack has no contour: all its sections are empty", {}};
  error.where.section = 0;
  return error;
}

std::size_t SectionStack::contour_count() const {
  std::size_t count = 0;
  for (const Section& section : sections) count += section.contours.size();
  return count;
}

std::size_t SectionStack::vertex_count() const {
  std::size_t count = 0;
  for (const Section& section : sections) {
    for (const Contour& contour : section.contours) count += contour.vertices.size();
  }
  return count;
}

Result<IdVector<SectionId, Nesting>> sections::nest_if_valid(const SectionStack& stack,
                                                             WatchedWork& work) {
  if (Result<void> sound = fp_self_check(); !sound) return sound.error();
  if (stack.sections.empty()) return no_section_error();
  std::vector<double> heights;
  for (const Section& section : stack.sections) heights.push_back(section.z);
  IdVector<SectionId, Nesting> nestings(stack.sections.size());
  // Sections above a faulty one need no look: the lowest is reported.
  std::atomic<std::size_t> lowest{stack.sections.size()};
  std::optional<Error> of_lowest;
  std::mutex told;
  parallel_for(stack.sections.size(), work.execution().threads, [&](std::size_t s) {
    if (s > lowest.load()) return;
    work.go_on();
    std::optional<Error> error = height_error(heights, s);
    if (!error) {
      Result<Nesting> nested = nest_section_if_valid(stack.sections[SectionId(s)], s);
      if (nested) {
        nestings[SectionId(s)] = *std::move(nested);
      } else {
        error = nested.error();
      }
    }
    work.step_done();
    if (!error) return;
    const std::lock_guard lock(told);
    if (s > lowest.load()) return;
    lowest = s;
    of_lowest = std::move(error);
  });
  if (of_lowest) return *std::move(of_lowest);
  if (stack.contour_count() == 0) return no_contour_error();
  return nestings;
}

Result<IdVector<SectionId, Nesting>> nest_if_valid(const SectionStack& stack,
                                                   const Execution& given) {
  return guard_threads(given, [&](const Execution& execution) {
    WatchedWork work(execution, stack.sections.size());
    return sections::nest_if_valid(stack, work);
  });
}

Result<void> sections::validate_within(const SectionStack& stack, WatchedWork& work) {
  const Result<IdVector<SectionId, Nesting>> nested = nest_if_valid(stack, work);
  if (!nested) return nested.error();
  return {};
}

Result<void> validate(const SectionStack& stack, const Execution& given) {
  return guard_threads(given, [&](const Execution& execution) {
    WatchedWork work(execution, stack.sections.size());
    return sections::validate_within(stack, work);
  });
}

Result<ValidStack> ValidStack::of(SectionStack stack, const Execution& given) {
  return guard_threads(given, [&](const Execution& execution) -> Result<ValidStack> {
    WatchedWork work(execution, stack.sections.size());
    Result<IdVector<SectionId, Nesting>> nested = sections::nest_if_valid(stack, work);
    if (!nested) return nested.error();
    return sections::ValidStackMaker::make(std::move(stack), *std::move(nested));
  });
}

}  // namespace tetloft
