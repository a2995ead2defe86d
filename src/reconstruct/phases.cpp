#include "reconstruct/phases.hpp"

#include <string>

#include "core/enums.hpp"
#include "core/option_rules.hpp"
#include "core/pages.hpp"
#include "core/unit_of_length.hpp"
#include "correspondence/link_report.hpp"
#include "model/scaling.hpp"
#include "reconstruct/build.hpp"
#include "reconstruct/decide.hpp"
#include "reconstruct/decide_between.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/divide.hpp"
#include "reconstruct/ends.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/stack_errors.hpp"
#include "reconstruct/void_outcome.hpp"

namespace tetloft::internal {

std::optional<Error> check_options(const ReconstructOptions& options) {
  const Result<void> sensible = check_correspondence_options(options.correspondence);
  if (!sensible) return sensible.error();
  if (!is_enumerator(options.ends, Ends::half)) {
    return Error{ErrorCode::usage, "there are no such ends: flat or half", {}};
  }
  if (!is_enumerator(options.delaunay, DelaunayEngine::slab)) {
    return Error{ErrorCode::usage, "there is no such Delaunay engine", {}};
  }
  Result<void> good = check_work_limit(options.work_limit);
  if (good && options.between) good = check_between(*options.between);
  if (good && options.thickness) good = check_length(*options.thickness, "the thickness");
  if (!good) return good.error();
  return std::nullopt;
}

namespace {

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

void warn(BuiltStack& built, const ReconstructOptions& options) {
  const PreparedStack& prepared = built.prepared;
  const Correspondence& decided = built.plan.correspondence;
  warn_of_dropped(decided.candidates, prepared.nestings, built.warnings);
  for (const auto& hint :
       {hint_of_missing_partners(prepared, decided.candidates),
        divides_coarse(options) ? std::nullopt : hint_of_coarse_contours(prepared, decided)}) {
    if (hint) built.warnings.push_back(*hint);
  }
}

[[nodiscard]] std::optional<Error> decide_about_voids(BuiltStack& built,
                                                      const ReconstructOptions& options,
                                                      const WatchedWork& work) {
  VoidDecision decision(built.prepared, options);
  Result<std::optional<Correspondence>> voids =
      decision.make(built.plan.correspondence.links, work);
  if (!voids) return voids.error();
  built.plan.voids = std::move(*voids);
  built.complements = decision.complements();
  return std::nullopt;
}

[[nodiscard]] std::optional<Error> put_ends(BuiltStack& built, const ReconstructOptions& options) {
  const PreparedStack& prepared = built.prepared;
  std::vector<double> heights;
  for (const Section& section : prepared.stack.sections) heights.push_back(section.z);
  const double thickness =
      heights.size() == 1 ? single_thickness(prepared, options, built.warnings) : 0;
  Result<EndPlanes> ends = place_ends(heights, options.ends, thickness);
  if (!ends) return ends.error();
  built.plan.ends = *ends;
  return std::nullopt;
}

// All of the plan but what is put between, of a stack prepared, or a window.
[[nodiscard]] std::optional<Error> decide(BuiltStack& built, Decision& decision,
                                          const ReconstructOptions& options,
                                          const WatchedWork& work) {
  PreparedStack& prepared = built.prepared;
  Plan& plan = built.plan;
  StepClock clock(built.seconds);
  plan.exponent = prepared.exponent;
  Result<Correspondence> decided = decision.make(all_ids<SlabId>(prepared.slab_count()), work);
  if (!decided) return decided.error();
  plan.correspondence = std::move(*decided);
  plan.motions = decision.motions();
  if (auto error = decide_about_voids(built, options, work)) return error;
  clock.end(Step::correspondence);
  return std::nullopt;
}

[[nodiscard]] std::optional<Error> put_between(BuiltStack& built, const ReconstructOptions& options,
                                               const WatchedWork& work) {
  StepClock clock(built.seconds);
  const PreparedStack& prepared = built.prepared;
  auto error =
      decide_between(prepared, options, all_ids<SlabId>(prepared.slab_count()), work, built.plan);
  clock.end(Step::between);
  return error;
}

// All slabs of a stack whose sections are conforming.
[[nodiscard]] std::optional<Error> build(BuiltStack& built, Decision* decision,
                                         const ReconstructOptions& options, WatchedWork& work) {
  PreparedStack& prepared = built.prepared;
  built.plan.gabriel.resize(prepared.section_count());
  built.plan.apart.resize(prepared.section_count());
  built.plan.divided = std::move(prepared.divisions);
  SlabBuilds builds(prepared, decision, built.plan, options, work);
  if (auto error = builds.run()) return error;
  for (const std::vector<Warning>& told : {prepared.warnings, builds.warnings()}) {
    built.warnings.insert(built.warnings.end(), told.begin(), told.end());
  }
  built.parts = builds.take_parts();
  built.refinements = builds.refinements();
  built.open = builds.open_clusters();
  built.mended = builds.mended();
  return std::nullopt;
}

Error in_unit_given(Error error, int exponent) {
  if (error.where.point) error.where.point = scaled(*error.where.point, -exponent);
  return error;
}

}  // namespace

IdVector<SlabId, std::uint32_t> BuiltStack::sections_between() const {
  IdVector<SlabId, std::uint32_t> counts(prepared.slab_count());
  for (const Part& part : parts) {
    if (part.lower.valid() && part.upper.valid()) counts[part.slab] = part.solid.sections_between;
  }
  return counts;
}

std::size_t step_count(const SectionStack& stack) {
  const std::size_t sections = stack.sections.size();
  return sections == 0 ? 0 : 2 * sections - 1;
}

Result<BuiltStack> build_stack(Unit unit, const GivenStack& stack,
                               const ReconstructOptions& options, WatchedWork& work) {
  if (auto error = check_options(options)) return *error;
  BuiltStack built;
  StepClock clock(built.seconds);
  Result<PreparedStack> prepared = prepare(stack, unit, options, work);
  if (!prepared) return prepared.error();
  built.prepared = std::move(*prepared);
  clock.end(Step::sections);
  auto error = put_ends(built, options);
  if (error) return in_unit_given(*std::move(error), built.prepared.exponent);
  Decision decision(built.prepared, options);
  error = decide(built, decision, options, work);
  if (!error) error = put_between(built, options, work);
  if (!error) error = build(built, &decision, options, work);
  if (error) return in_unit_given(*std::move(error), built.prepared.exponent);
  warn(built, options);
  return built;
}

Result<BuiltStack> plan_stack(Unit unit, const GivenStack& stack, const ReconstructOptions& options,
                              WatchedWork& work) {
  if (auto error = check_options(options)) return *error;
  BuiltStack planned;
  StepClock clock(planned.seconds);
  const bool reverse = options.correspondence.criterion == Criterion::reverse;
  Result<PreparedStack> prepared =
      prepare(stack, unit, options, work, reverse ? Conform::all : Conform::none);
  if (!prepared) return prepared.error();
  planned.prepared = std::move(*prepared);
  clock.end(Step::sections);
  auto error = put_ends(planned, options);
  if (error) return in_unit_given(*std::move(error), planned.prepared.exponent);
  error = decide_window(planned, options, work);
  if (error) return *error;
  warn(planned, options);
  return planned;
}

bool decides_in_windows(const ReconstructOptions& options) {
  const CorrespondenceOptions& rule = options.correspondence;
  return rule.criterion != Criterion::reverse && rule.labels.empty() && rule.decisions.empty() &&
         rule.voids.labels.empty() && rule.voids.decisions.empty();
}

std::optional<Error> decide_window(BuiltStack& window, const ReconstructOptions& options,
                                   const WatchedWork& work) {
  Decision decision(window.prepared, options);
  auto error = decide(window, decision, options, work);
  if (error) return in_unit_given(*std::move(error), window.prepared.exponent);
  return std::nullopt;
}

std::optional<Error> build_window(BuiltStack& window, const ReconstructOptions& options,
                                  WatchedWork& work) {
  StepClock clock(window.seconds);
  auto error = conform_all(window.prepared, options.execution.threads, work);
  clock.end(Step::sections);
  if (!error) error = put_between(window, options, work);
  if (!error) error = build(window, nullptr, options, work);
  if (error) return in_unit_given(*std::move(error), window.prepared.exponent);
  return std::nullopt;
}

std::optional<Model> take_model(BuiltStack& built, unsigned threads) {
  StepClock clock(built.seconds);
  Plan& plan = built.plan;
  VoidOutcome of_voids =
      void_outcome(built.prepared.sections, plan.voids, built.complements, built.parts);
  // What slabs were built on takes as much memory as a model; gluing asks for vertices alone.
  for (const SectionId s : built.prepared.sections.ids()) built.prepared.release_triangulation(s);
  core::give_back_freed();
  Model model =
      glue(built.prepared.sections, plan.correspondence.component, std::move(built.parts), threads);
  model.links = region_links(plan.correspondence.candidates, built.prepared.nestings);
  model.motions = plan.motions;
  model.void_links = std::move(of_voids.links);
  model.deviations = std::move(of_voids.deviations);
  const bool exact = scale_exactly(model, -built.prepared.exponent);
  clock.end(Step::assembly);
  if (!exact) return std::nullopt;
  return model;
}

}  // namespace tetloft::internal
