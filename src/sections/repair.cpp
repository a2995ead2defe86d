// Repair: section by section (section_repair.hpp), each in a unit of length of its own.
#include <algorithm>
#include <cmath>
#include <utility>

#include <tetloft/repair.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/scaling.hpp"
#include "sections/section_repair.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The first coordinate that is not usable is left to validate() to name.
bool is_usable(const Section& section) {
  return sections::largest_magnitude(section) < kLargestCoordinate &&
         std::all_of(section.contours.begin(), section.contours.end(), [](const Contour& c) {
           return std::all_of(c.vertices.begin(), c.vertices.end(), [](const Point2& p) {
             return std::isfinite(p.x) && std::isfinite(p.y);
           });
         });
}

// In a unit of length of its own, unless what is made has finer bits than the one given.
Result<Section> repair_section(const Section& section, std::size_t number,
                               const sections::SectionRepair::Options& options, Repaired& result) {
  UnitOfLength unit;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) unit.include(p);
  }
  unit.include(options.distance);
  if (options.keyholes) unit.include(*options.keyholes);
  for (const int exponent : {unit.exponent(), 0}) {
    sections::SectionRepair repair(section, number, options, exponent);
    Result<Section> repaired = repair.run();
    if (!repaired) return repaired;
    const bool exact = std::all_of(
        repaired->contours.begin(), repaired->contours.end(), [&](const Contour& contour) {
          return std::all_of(contour.vertices.begin(), contour.vertices.end(),
                             [&](const Point2& p) { return is_scaled_exactly(p, -exponent); });
        });
    if (!exact) continue;
    repair.report(result);
    return sections::scaled_in_plane(*repaired, -exponent);
  }
  TETLOFT_CHECK(false);
}

Result<void> check_repair_options(const RepairOptions& options) {
  if (!is_enumerator(options.fill, FillRule::winding)) {
    return Error{ErrorCode::usage, "there is no such fill rule", {}};
  }
  if (options.distance) {
    const Result<void> good = check_length(*options.distance, "the repair distance");
    if (!good) return good;
  }
  if (options.keyholes) return check_length(*options.keyholes, "the width of keyholes");
  return {};
}

Result<Repaired> repair_all(const SectionStack& stack, const RepairOptions& options) {
  if (Result<void> good = check_repair_options(options); !good) return good.error();
  WatchedWork work(options.execution, stack.sections.size() + 1);
  Repaired result;
  result.stack = stack;
  result.changes = mend(result.stack);
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    work.go_on();
    Section& section = result.stack.sections[SectionId(s)];
    if (is_usable(section)) {
      const double distance =
          options.distance.value_or(0x1p-20 * sections::largest_magnitude(section));
      Result<Section> repaired =
          repair_section(section, s, {distance, options.fill, options.keyholes}, result);
      if (!repaired) return repaired.error();
      section = std::move(repaired.value());
    }
    work.step_done();
  }
  // Where contours cancel nothing may be left, which only who wants a solid must refuse.
  const bool nothing_left = result.stack.contour_count() == 0 && stack.contour_count() > 0;
  if (!nothing_left) {
    const Result<void> valid = validate(result.stack, untold(options.execution));
    if (!valid) return valid.error();
  }
  work.step_done();
  return result;
}

}  // namespace

Result<Repaired> repair(const SectionStack& stack, const RepairOptions& given) {
  return guard_threads(given,
                       [&](const RepairOptions& options) { return repair_all(stack, options); });
}

}  // namespace tetloft
