// From stacks to models.
#include <tetloft/between.hpp>
#include <tetloft/reconstruct.hpp>

#include <cstdint>
#include <limits>
#include <string>

#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_reconstruct_options default_reconstruct_options() {
  const ReconstructOptions defaults;
  tetloft_reconstruct_options options{};
  options.version = TETLOFT_RECONSTRUCT_OPTIONS_VERSION;
  options.ends = static_cast<std::int32_t>(defaults.ends);
  options.engine = static_cast<std::int32_t>(defaults.delaunay);
  options.between = -1;
  options.divide_coarse = defaults.divide_coarse ? 1 : 0;
  options.work_limit = defaults.work_limit;
  return options;
}

std::optional<std::size_t> sections_between(std::int64_t between) {
  if (between < -1) {
    fail_usage("reconstruct options: between is " + std::to_string(between) +
               ", neither a number of sections nor -1");
  }
  if (between == -1) return std::nullopt;
  // What a word does not hold is refused like the largest that it holds.
  constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(std::min(static_cast<std::uint64_t>(between), kMost));
}

ReconstructOptions reconstruct_options_of(const tetloft_reconstruct_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_RECONSTRUCT_OPTIONS_VERSION, "reconstruct options");
  ReconstructOptions result;
  result.correspondence = correspondence_of(options->correspondence);
  result.ends = enumerator_of(options->ends, Ends::half, "reconstruct options: ends");
  result.delaunay =
      enumerator_of(options->engine, DelaunayEngine::slab, "reconstruct options: engine");
  result.between = sections_between(options->between);
  result.divide_coarse = options->divide_coarse != 0;
  if (options->thickness != 0) result.thickness = options->thickness;
  result.work_limit = options->work_limit;
  result.execution = execution_of(options->execution);
  return result;
}

BetweenOptions between_options_of(const tetloft_reconstruct_options* options) {
  const ReconstructOptions given = reconstruct_options_of(options);
  return {.correspondence = given.correspondence,
          .sections = given.between,
          .divide_coarse = given.divide_coarse,
          .work_limit = given.work_limit,
          .execution = given.execution};
}

Labels decisions_of(const CorrespondenceOptions& correspondence) {
  return {.labels = correspondence.labels,
          .decisions = correspondence.decisions,
          .hole_labels = correspondence.voids.labels,
          .void_decisions = correspondence.voids.decisions};
}

void fill_report(const ReconstructReport& made, tetloft_report& report) {
  report.slices = made.slices;
  report.sections_between = made.sections_between;
  report.sections_given_up = made.sections_given_up;
  report.contours = made.contours;
  report.input_vertices = made.input_vertices;
  report.split_vertices = made.split_vertices;
  report.dividing_vertices = made.dividing_vertices;
  report.vertices = made.vertices;
  report.tets = made.tets;
  report.components = made.components;
  report.volume = made.volume;
  report.smallest_lift = made.smallest_lift;
  report.work = made.work;
  report.seconds = made.seconds_total;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_reconstruct_options_defaults(tetloft_reconstruct_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_reconstruct_options();
  });
}

tetloft_status tetloft_reconstruct(const tetloft_stack* stack,
                                   const tetloft_reconstruct_options* options,
                                   tetloft_model** model, tetloft_warnings** warnings) {
  clear(model);
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(model, "model");
    tetloft::Reconstruction made =
        value_of(tetloft::reconstruct(*value, reconstruct_options_of(options)));
    hand_out(model, ModelValue{std::move(made.model), made.report}, warnings, made.warnings);
  });
}

tetloft_status tetloft_between(const tetloft_stack* stack,
                               const tetloft_reconstruct_options* options, tetloft_stack** longer,
                               tetloft_labels** decisions, tetloft_warnings** warnings) {
  clear(longer);
  clear(decisions);
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(longer, "longer");
    tetloft::LongStack made = value_of(tetloft::between(*value, between_options_of(options)));
    NewHandle<tetloft_stack> made_stack(std::move(made.stack));
    if (decisions == nullptr) {
      hand_out_warnings(warnings, made.warnings);
    } else {
      hand_out(decisions, decisions_of(made.correspondence), warnings, made.warnings);
    }
    made_stack.give(longer);
  });
}

tetloft_status tetloft_model_report(const tetloft_model* model, tetloft_report* report) {
  return answer([&] {
    require_result(report, TETLOFT_REPORT_VERSION, "report");
    const auto value = value_of_handle(model, "model");
    if (!value->report) fail_usage("the model was not reconstructed: there is no report");
    fill_report(*value->report, *report);
  });
}
