#include "reconstruct/prepare.hpp"

#include <string>
#include <utility>

#include "core/guard.hpp"
#include "core/unit_of_length.hpp"
#include "reconstruct/divide.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/coarse_edges.hpp"
#include "sections/conforming_section.hpp"
#include "sections/scaling.hpp"
#include "sections/validation.hpp"
#include "slab/work_limit.hpp"

namespace tetloft::internal {

std::optional<Error> PreparedStack::conform_section(SectionId s,
                                                    const IdVector<ContourId, bool>& gabriel,
                                                    const std::vector<Point2>& apart,
                                                    const std::vector<EdgeDivision>& divided) {
  std::size_t vertices = 0;
  for (const Contour& contour : stack.sections[s].contours) vertices += contour.vertices.size();
  Result<ConformingSection> section =
      sections::conform_nested(stack.sections[s], s, nestings[s],
                               {.gabriel = gabriel,
                                .apart = apart,
                                .divided = divided,
                                .most_inserted = most_inserted(work_limit, vertices)});
  if (!section) return section.error();
  sections[s] = std::move(*section);
  return std::nullopt;
}

void PreparedStack::release_triangulation(SectionId s) {
  ConformingSection& section = sections[s];
  section.triangulation.triangles = {};
  section.triangulation.neighbours = {};
  section.edges = {};
  section.first_edge = {};
}

namespace {

// Conforms the sections, coarse contours divided where that can be done.
class Conforming {
 public:
  Conforming(PreparedStack& prepared, bool divide)
      : prepared_(prepared),
        divide_(divide),
        least_long_(divide ? sections::least_long_edge(prepared.stack) : 0),
        refused_(prepared.section_count()) {
    prepared.divisions.resize(prepared.section_count());
  }

  std::optional<Error> conform(SectionId s) {
    if (!divide_) return prepared_.conform_section(s);
    SectionDivision division = divide_section(prepared_.stack, s, least_long_);
    refused_[s] = std::move(division.refused);
    auto error = prepared_.conform_section(s, {}, {}, division.edges);
    if (!error) {
      prepared_.divisions[s] = std::move(division.edges);
      return std::nullopt;
    }
    if (division.edges.empty() || !is_refusal(error->code)) return error;
    refused_[s] = error->message;
    return prepared_.conform_section(s);
  }

  void warn() {
    for (const SectionId s : refused_.ids()) {
      if (refused_[s]) prepared_.warnings.push_back(not_divided(s, *refused_[s]));
    }
  }

 private:
  PreparedStack& prepared_;
  bool divide_;
  double least_long_;
  IdVector<SectionId, std::optional<std::string>> refused_;  // by section: why it is not divided
};

Result<IdVector<SectionId, Nesting>> nestings_of(const GivenStack& given,
                                                 const Execution& execution) {
  // A valid stack that was moved from is empty, and is refused.
  if (given.nestings != nullptr && !given.nestings->empty()) return *given.nestings;
  const Execution alone = untold(execution);
  WatchedWork work(alone, 0);
  return sections::nest_if_valid(*given.stack, work);
}

}  // namespace

Result<PreparedStack> prepare(const GivenStack& given, Unit unit, const ReconstructOptions& options,
                              WatchedWork& work, Conform conform) {
  Result<IdVector<SectionId, Nesting>> nestings = nestings_of(given, options.execution);
  if (!nestings) return nestings.error();
  const SectionStack& stack = *given.stack;
  PreparedStack prepared;
  prepared.work_limit = options.work_limit;
  if (unit == Unit::of_the_stack) {
    UnitOfLength length = sections::unit_of(stack);
    if (stack.sections.size() == 1 && options.thickness) length.include(*options.thickness);
    prepared.exponent = length.exponent();
  }
  prepared.stack = sections::scaled(stack, prepared.exponent);
  prepared.nestings = *std::move(nestings);  // scaling by a power of two changes no order
  prepared.sections.resize(prepared.section_count());
  Conforming sections(prepared, divides_coarse(options) && conform == Conform::all);
  auto error = first_error(all_ids<SectionId>(prepared.section_count()), options.execution.threads,
                           work, [&](SectionId s) {
                             auto failed =
                                 conform == Conform::all ? sections.conform(s) : std::nullopt;
                             work.step_done();
                             return failed;
                           });
  sections.warn();
  if (!error) return prepared;
  if (error->where.point) error->where.point = scaled(*error->where.point, -prepared.exponent);
  return *error;
}

}  // namespace tetloft::internal
