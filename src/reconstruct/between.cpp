// The API of the longer stack: builds as a reconstruction does, and keeps what was put between.
#include <tetloft/between.hpp>

#include <algorithm>
#include <utility>

#include "core/guard.hpp"
#include "reconstruct/long_stack.hpp"
#include "reconstruct/phases.hpp"
#include "sections/scaling.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Nothing where the model, made in this unit, is none in the one given.
Result<std::optional<LongStack>> between_in(Unit unit, const SectionStack& stack,
                                            const ReconstructOptions& options) {
  WatchedWork work(options.execution, step_count(stack));
  Result<BuiltStack> built = build_stack(unit, stack, options, work);
  if (!built) return built.error();
  LongLayers layers = long_layers(*built);
  Result<CorrespondenceOptions> correspondence = settled(layers, options.execution);
  if (!correspondence) return correspondence.error();
  const std::optional<Model> model = take_model(*built, options.execution.threads);
  if (!model) return std::optional<LongStack>();
  LongStack result;
  // Given ones are as they were, for their unit costs no bit; inserted ones as in the model.
  result.stack = sections::scaled(layers.prepared.stack, -built->prepared.exponent);
  result.stack.frame = stack.frame;
  result.stack.about = stack.about;
  result.source = std::move(layers.source);
  result.component = std::move(layers.component);
  result.components = model->component_count;
  result.correspondence = std::move(*correspondence);
  // Of a single section they are about how its model ends.
  if (built->prepared.slab_count() > 0) result.warnings = std::move(built->warnings);
  return std::optional(std::move(result));
}

}  // namespace

Result<LongStack> between(const SectionStack& stack, const BetweenOptions& options) {
  return guard_internal([&] {
    ReconstructOptions asked;
    asked.correspondence = options.correspondence;
    asked.between = options.sections;
    asked.divide_coarse = options.divide_coarse;
    asked.work_limit = options.work_limit;
    asked.execution = options.execution;
    return in_either_unit(asked, [&](Unit unit, const ReconstructOptions& in_unit) {
      return between_in(unit, stack, in_unit);
    });
  });
}

}  // namespace tetloft
