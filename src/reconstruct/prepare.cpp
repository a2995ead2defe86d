#include "reconstruct/prepare.hpp"

#include <utility>

#include "core/unit_of_length.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/scaling.hpp"
#include "slab/work_limit.hpp"

namespace tetloft::internal {

std::optional<Error> PreparedStack::conform_section(SectionId s,
                                                    const IdVector<ContourId, bool>& gabriel,
                                                    const std::vector<Point2>& apart) {
  std::size_t vertices = 0;
  for (const Contour& contour : stack.sections[s].contours) vertices += contour.vertices.size();
  Result<ConformingSection> section = conform(
      stack.sections[s], s,
      {.gabriel = gabriel, .apart = apart, .most_inserted = most_inserted(work_limit, vertices)});
  if (!section) return section.error();
  sections[s] = std::move(*section);
  return std::nullopt;
}

Result<PreparedStack> prepare(const SectionStack& given, Unit unit,
                              const ReconstructOptions& options, WatchedWork& work,
                              Conform conform) {
  if (Result<void> valid = validate(given, untold(options.execution)); !valid) return valid.error();
  PreparedStack prepared;
  prepared.work_limit = options.work_limit;
  if (unit == Unit::of_the_stack) {
    UnitOfLength length = sections::unit_of(given);
    if (given.sections.size() == 1 && options.thickness) length.include(*options.thickness);
    prepared.exponent = length.exponent();
  }
  prepared.stack = sections::scaled(given, prepared.exponent);
  prepared.nestings.resize(prepared.section_count());
  prepared.sections.resize(prepared.section_count());
  auto error = first_error(all_ids<SectionId>(prepared.section_count()), options.execution.threads,
                           work, [&](SectionId s) {
                             prepared.nestings[s] = nest(prepared.stack.sections[s]);
                             auto failed = conform == Conform::all ? prepared.conform_section(s)
                                                                   : std::nullopt;
                             work.step_done();
                             return failed;
                           });
  if (!error) return prepared;
  if (error->where.point) error->where.point = scaled(*error->where.point, -prepared.exponent);
  return *error;
}

}  // namespace tetloft::internal
