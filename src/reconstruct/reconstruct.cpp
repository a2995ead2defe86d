// The API: runs the phases, and reports.
#include <tetloft/reconstruct.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "reconstruct/component_names.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/phases.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace {

using Clock = std::chrono::steady_clock;

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
  report = report_of_parts(*built);
  const StepSeconds before_gluing = built->seconds;
  std::optional<Model> model = take_model(*built, options.execution.threads);
  if (!model) return std::optional<Reconstruction>();
  result.model = std::move(*model);
  result.model.frame = stack.frame;
  result.model.about = stack.about;
  result.model.component_names =
      names_by_labels(built->plan.correspondence.partition, result.model.component_count,
                      options.correspondence.labels);
  result.warnings = std::move(built->warnings);
  if (const auto hint = hint_of_many_tets(built->prepared, result.model)) {
    result.warnings.push_back(*hint);
  }
  report.slices = built->prepared.section_count();
  report.contours = built->prepared.stack.contour_count();
  report.input_vertices = built->prepared.stack.vertex_count();
  describe(result.model, options.execution.threads, report);
  result.partition = std::move(built->plan.correspondence.partition);
  for (std::size_t s = 0; s < kSteps; ++s)
    report.seconds[s] += built->seconds[s] - before_gluing[s];
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
