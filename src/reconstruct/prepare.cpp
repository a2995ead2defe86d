#include "reconstruct/prepare.hpp"

#include <string>
#include <utility>

#include "core/guard.hpp"
#include "core/pages.hpp"
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

std::vector<const Section*> PreparedStack::neighbours(SectionId s) const {
  std::vector<const Section*> found;
  if (s.index() > 0) {
    found.push_back(&stack.sections[SectionId(s.index() - 1)]);
  } else if (beyond_below) {
    found.push_back(&beyond_below->section);
  }
  if (s.index() + 1 < section_count()) {
    found.push_back(&stack.sections[SectionId(s.index() + 1)]);
  } else if (beyond_above) {
    found.push_back(&beyond_above->section);
  }
  return found;
}

// At once: what slabs are built of rarely fits in the holes that are left.
void PreparedStack::release_triangulation(SectionId s) {
  ConformingSection& section = sections[s];
  core::release(section.triangulation.triangles.raw());
  core::release(section.triangulation.neighbours.raw());
  core::release(section.edges.raw());
  section.first_edge = {};
  section.next = {};
  section.previous = {};
  section.edge_of = {};
}

namespace {

// Conforms the sections, coarse contours divided where that can be done.
class Conforming {
 public:
  explicit Conforming(PreparedStack& prepared)
      : prepared_(prepared), refused_(prepared.section_count()) {}

  std::optional<Error> conform(SectionId s) {
    if (!prepared_.least_long) return prepared_.conform_section(s);
    SectionDivision division =
        divide_section(prepared_.stack.sections[s], prepared_.neighbours(s), *prepared_.least_long);
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

std::optional<Error> conform_all(PreparedStack& prepared, unsigned threads, WatchedWork& work) {
  prepared.divisions.resize(prepared.section_count());
  Conforming sections(prepared);
  auto error =
      first_error(all_ids<SectionId>(prepared.section_count()), threads, work, [&](SectionId s) {
        auto failed = sections.conform(s);
        work.step_done();
        return failed;
      });
  sections.warn();
  return error;
}

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
  if (divides_coarse(options)) prepared.least_long = sections::least_long_edge(prepared.stack);
  prepared.sections.resize(prepared.section_count());
  if (conform == Conform::none) {
    for (std::size_t s = 0; s < prepared.section_count(); ++s) work.step_done_go_on();
    return prepared;
  }
  auto error = conform_all(prepared, options.execution.threads, work);
  if (!error) return prepared;
  if (error->where.point) error->where.point = scaled(*error->where.point, -prepared.exponent);
  return *error;
}

}  // namespace tetloft::internal
