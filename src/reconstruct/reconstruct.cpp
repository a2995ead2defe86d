// The API: runs the phases, and reports.
#include <tetloft/reconstruct.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "model/volume.hpp"
#include "reconstruct/component_names.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/phases.hpp"

namespace tetloft {

using namespace internal;

namespace {

using Clock = std::chrono::steady_clock;

// What the parts of a model did, in sum.
void add_up(const std::vector<Part>& parts, ReconstructReport& report) {
  for (const Part& part : parts) {
    for (std::size_t r = 0; r < kRules; ++r) report.rules[r] += part.solid.rules[r];
    for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += part.solid.seconds[s];
    report.work += part.solid.work;
    report.sections_between += part.solid.sections_between;
    report.sections_given_up += part.solid.sections_given_up;
    report.smallest_lift = std::min(report.smallest_lift, part.solid.smallest_lift);
  }
}

void describe(const PreparedStack& prepared, const Model& model, unsigned threads,
              ReconstructReport& report) {
  report.slices = prepared.section_count();
  report.contours = prepared.stack.contour_count();
  report.input_vertices = prepared.stack.vertex_count();
  report.vertices = model.points.size();
  report.tets = model.tets.size();
  report.components = model.component_count;
  report.volume = volume_of(model, threads);
  report.split_vertices = static_cast<std::size_t>(
      std::count(model.origin.begin(), model.origin.end(), PointOrigin::contour_split));
  report.work += report.split_vertices;
  for (std::size_t s = 1; s + 1 < prepared.section_count(); ++s) {
    const auto& inside = prepared.sections[SectionId(s)].internal;
    count(report.rules, Rule::gluing,
          static_cast<std::uint64_t>(std::count(inside.begin(), inside.end(), std::uint8_t{1})));
  }
}

// Nothing where the model, made in this unit, is none in the one given.
Result<std::optional<Reconstruction>> reconstruct_in(Unit unit, const GivenStack& given,
                                                     const ReconstructOptions& options) {
  const auto start = Clock::now();
  const SectionStack& stack = *given.stack;
  WatchedWork work(options.execution, step_count(stack));
  Result<BuiltStack> built = build_stack(unit, given, options, work);
  if (!built) return built.error();
  Reconstruction result;
  ReconstructReport& report = result.report;
  add_up(built->parts, report);
  count(report.rules, Rule::gabriel_refinement, built->refinements);
  for (const std::vector<EdgeDivision>& section : built->plan.divided) {
    for (const EdgeDivision& edge : section) report.dividing_vertices += edge.parts - 1;
  }
  std::optional<Model> model = take_model(*built, options.execution.threads);
  if (!model) return std::optional<Reconstruction>();
  result.model = std::move(*model);
  result.model.frame = stack.frame;
  result.model.about = stack.about;
  result.model.component_names = names_by_labels(result.model, options.correspondence.labels);
  result.warnings = std::move(built->warnings);
  if (const auto hint = hint_of_many_tets(built->prepared, result.model)) {
    result.warnings.push_back(*hint);
  }
  describe(built->prepared, result.model, options.execution.threads, report);
  result.partition = std::move(built->plan.correspondence.partition);
  for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += built->seconds[s];
  report.seconds_total = std::chrono::duration<double>(Clock::now() - start).count();
  return std::optional(std::move(result));
}

Result<Reconstruction> reconstruct_given(const GivenStack& stack,
                                         const ReconstructOptions& options) {
  return in_either_unit(options, [&](Unit unit, const ReconstructOptions& in_unit) {
    return reconstruct_in(unit, stack, in_unit);
  });
}

}  // namespace

Result<Reconstruction> reconstruct(const SectionStack& stack, const ReconstructOptions& options) {
  return reconstruct_given(stack, options);
}

Result<Reconstruction> reconstruct(const ValidStack& stack, const ReconstructOptions& options) {
  return reconstruct_given(stack, options);
}

}  // namespace tetloft
