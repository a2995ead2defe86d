// The API: validates, runs the steps over all sections and slabs, glues, reports.
#include <tetloft/reconstruct.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/unit_of_length.hpp"
#include "core/watched_work.hpp"
#include "correspondence/link_report.hpp"
#include "model/scaling.hpp"
#include "reconstruct/build.hpp"
#include "reconstruct/decide.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/divide.hpp"
#include "reconstruct/ends.hpp"
#include "reconstruct/glue.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/prepare.hpp"
#include "reconstruct/stack_errors.hpp"
#include "reconstruct/void_outcome.hpp"

namespace tetloft {

using namespace internal;

namespace {

using Clock = std::chrono::steady_clock;

// Steps that the caller's callback hears of; an empty stack is refused.
std::size_t step_count(const SectionStack& stack) {
  const std::size_t sections = stack.sections.size();
  return sections == 0 ? 0 : 2 * sections - 1;
}

[[nodiscard]] std::optional<Error> check_options(const ReconstructOptions& options) {
  const Result<void> sensible = check_correspondence_options(options.correspondence);
  if (!sensible) return sensible.error();
  if (!is_enumerator(options.ends, Ends::half)) {
    return Error{ErrorCode::usage, "there are no such ends: flat or half", {}};
  }
  if (!is_enumerator(options.delaunay, DelaunayEngine::slab)) {
    return Error{ErrorCode::usage, "there is no such Delaunay engine", {}};
  }
  Result<void> good = check_work_limit(options.work_limit);
  if (good && options.thickness) good = check_length(*options.thickness, "the thickness");
  if (!good) return good.error();
  return std::nullopt;
}

// What the parts of a model did, in sum.
void add_up(const std::vector<Part>& parts, ReconstructReport& report) {
  for (const Part& part : parts) {
    for (std::size_t r = 0; r < kRules; ++r) report.rules[r] += part.solid.rules[r];
    for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += part.solid.seconds[s];
    report.work += part.solid.work;
    report.smallest_lift = std::min(report.smallest_lift, part.solid.smallest_lift);
  }
}

void describe(const PreparedStack& prepared, const Model& model, ReconstructReport& report) {
  report.slices = prepared.section_count();
  report.contours = prepared.stack.contour_count();
  report.input_vertices = prepared.stack.vertex_count();
  report.vertices = model.points.size();
  report.tets = model.tets.size();
  report.components = model.component_count;
  report.split_vertices = static_cast<std::size_t>(
      std::count(model.origin.begin(), model.origin.end(), PointOrigin::contour_split));
  report.work += report.split_vertices;
  for (std::size_t s = 1; s + 1 < prepared.section_count(); ++s) {
    const auto& inside = prepared.sections[SectionId(s)].internal;
    count(report.rules, Rule::gluing,
          static_cast<std::uint64_t>(std::count(inside.begin(), inside.end(), std::uint8_t{1})));
  }
}

void warn_of_dropped(const StackCandidates& candidates,
                     const IdVector<SectionId, Nesting>& nestings, std::vector<Warning>& warnings) {
  for (const RegionLink& link : region_links(candidates, nestings)) {
    if (link.fate != LinkFate::unrealisable) continue;
    Place place;
    place.section = lower_section(link.slab).index();
    place.contour = link.lower.index();
    warnings.push_back({"it was not joined to contour " + std::to_string(link.upper.index()) +
                            " of the section above, as it should: no Delaunay edge lies between",
                        place});
  }
}

// Decide, build, glue. Nothing where the model, made in the unit of the prepared stack, is none in
// the one given. `result` holds what is known before.
Result<std::optional<Reconstruction>> make(PreparedStack& prepared,
                                           const ReconstructOptions& options, WatchedWork& work,
                                           Reconstruction result) {
  ReconstructReport& report = result.report;
  StepClock clock(report.seconds);
  Plan plan;
  plan.exponent = prepared.exponent;
  plan.gabriel.resize(prepared.section_count());
  plan.apart.resize(prepared.section_count());
  plan.divided = std::move(prepared.divisions);
  Result<std::optional<EndPlanes>> ends = place_ends(prepared, options, result.warnings);
  if (!ends) return ends.error();
  plan.ends = *ends;
  Decision decision(prepared, options);
  Result<Correspondence> decided = decision.make(all_ids<SlabId>(prepared.slab_count()), work);
  if (!decided) return decided.error();
  plan.correspondence = std::move(*decided);
  plan.motions = decision.motions();
  const VoidDecision void_decision(prepared, options);
  Result<std::optional<Correspondence>> voids = void_decision.make(plan.correspondence.links, work);
  if (!voids) return voids.error();
  plan.voids = std::move(*voids);
  clock.end(Step::correspondence);

  SlabBuilds builds(prepared, decision, plan, options, work);
  if (auto error = builds.run()) return *error;
  for (const std::vector<Warning>& told : {prepared.warnings, builds.warnings()}) {
    result.warnings.insert(result.warnings.end(), told.begin(), told.end());
  }
  warn_of_dropped(plan.correspondence.candidates, prepared.nestings, result.warnings);
  for (const auto& hint :
       {hint_of_missing_partners(prepared, plan.correspondence.candidates),
        divides_coarse(options) ? std::nullopt
                                : hint_of_coarse_contours(prepared, plan.correspondence)}) {
    if (hint) result.warnings.push_back(*hint);
  }
  std::vector<Part> parts = builds.take_parts();
  VoidOutcome of_voids =
      void_outcome(prepared.sections, plan.voids, void_decision.complements(), parts);
  add_up(parts, report);
  for (const std::vector<EdgeDivision>& section : plan.divided) {
    for (const EdgeDivision& edge : section) report.dividing_vertices += edge.parts - 1;
  }
  count(report.rules, Rule::gabriel_refinement, builds.refinements());
  StepClock gluing(report.seconds);
  result.model = glue(prepared.sections, plan.correspondence.component, std::move(parts));
  result.model.links = region_links(plan.correspondence.candidates, prepared.nestings);
  result.model.motions = std::move(plan.motions);
  result.model.void_links = std::move(of_voids.links);
  result.model.deviations = std::move(of_voids.deviations);
  gluing.end(Step::assembly);
  if (const auto hint = hint_of_many_tets(prepared, result.model)) result.warnings.push_back(*hint);
  describe(prepared, result.model, report);
  if (!scale_exactly(result.model, -prepared.exponent)) return std::optional<Reconstruction>();
  report.volume = volume(result.model);
  result.partition = std::move(plan.correspondence.partition);
  return std::optional(std::move(result));
}

// All phases; errors in the unit given.
Result<std::optional<Reconstruction>> make_in(Unit unit, const SectionStack& stack,
                                              const ReconstructOptions& options) {
  const auto start = Clock::now();
  if (auto error = check_options(options)) return *error;
  WatchedWork work(options.execution, step_count(stack));
  Reconstruction result;
  StepClock clock(result.report.seconds);
  Result<PreparedStack> prepared = prepare(stack, unit, options, work);
  if (!prepared) return prepared.error();
  clock.end(Step::sections);
  auto made = make(*prepared, options, work, std::move(result));
  if (!made) {
    Error error = made.error();
    if (error.where.point) error.where.point = scaled(*error.where.point, -prepared->exponent);
    return error;
  }
  if (*made) {
    (*made)->report.seconds_total = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return made;
}

}  // namespace

Result<Reconstruction> reconstruct(const SectionStack& stack,
                                   const ReconstructOptions& given_options) {
  return guard_threads(given_options,
                       [&](const ReconstructOptions& options) -> Result<Reconstruction> {
                         if (Result<void> sound = fp_self_check(); !sound) return sound.error();
                         auto made = make_in(Unit::of_the_stack, stack, options);
                         if (!made) return made.error();
                         if (*made) return std::move(**made);
                         ReconstructOptions again = options;
                         again.execution.progress = nullptr;  // all steps have been told
                         made = make_in(Unit::as_given, stack, again);
                         if (!made) return made.error();
                         return std::move(**made);
                       });
}

}  // namespace tetloft
