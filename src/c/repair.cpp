// Stacks: validated, and made fit.
#include <tetloft/repair.hpp>

#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_repair_options default_repair_options() {
  const RepairOptions defaults;
  tetloft_repair_options options{};
  options.version = TETLOFT_REPAIR_OPTIONS_VERSION;
  options.fill = static_cast<std::int32_t>(defaults.fill);
  options.distance = -1;
  return options;
}

RepairOptions repair_options_of(const tetloft_repair_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_REPAIR_OPTIONS_VERSION, "repair options");
  RepairOptions result;
  result.fill = enumerator_of(options->fill, FillRule::winding, "repair options: fill");
  // Below 0 the default; what is no number is not below, and refused.
  if (!(options->distance < 0)) result.distance = options->distance;
  if (options->keyholes != 0) result.keyholes = options->keyholes;
  result.execution = execution_of(options->execution);
  return result;
}

void fill_repair_report(const Repaired& made, tetloft_repair_report& report) {
  report.moved = made.moved;
  report.area_before = made.area_before;
  report.area_after = made.area_after;
  report.copies = made.copies;
  report.channels = made.channels;
  report.lost = made.lost.size();
  for (const LostBody& body : made.lost) report.area_lost += body.area;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_stack_validate(const tetloft_stack* stack,
                                      const tetloft_execution* execution) {
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_success(tetloft::validate(*value, execution_of(execution)));
  });
}

tetloft_status tetloft_stack_repair(const tetloft_stack* stack, double distance,
                                    const tetloft_execution* execution, tetloft_stack** repaired,
                                    tetloft_warnings** changes) {
  clear(repaired);
  clear(changes);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(repaired, "repaired");
    tetloft::RepairOptions options;
    // Below 0 the default; what is no number is not below, and refused.
    if (!(distance < 0)) options.distance = distance;
    options.execution = execution_of(execution);
    tetloft::Repaired made = value_of(tetloft::repair(*value, options));
    hand_out(repaired, std::move(made.stack), changes, made.changes);
  });
}

tetloft_status tetloft_repair_options_defaults(tetloft_repair_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_repair_options();
  });
}

tetloft_status tetloft_stack_repair_by(const tetloft_stack* stack,
                                       const tetloft_repair_options* options,
                                       tetloft_stack** repaired, tetloft_repair_report* report,
                                       tetloft_warnings** changes) {
  clear(repaired);
  clear(changes);
  return answer([&] {
    require_result(report, TETLOFT_REPAIR_REPORT_VERSION, "report");
    const auto value = value_of_handle(stack, "stack");
    require_output(repaired, "repaired");
    tetloft::Repaired made = value_of(tetloft::repair(*value, repair_options_of(options)));
    hand_out(repaired, std::move(made.stack), changes, made.changes);
    fill_repair_report(made, *report);
  });
}

tetloft_status tetloft_stack_arrange_planes(const tetloft_stack* stack, int32_t rule,
                                            double tolerance, tetloft_stack** arranged,
                                            tetloft_warnings** changes) {
  clear(arranged);
  clear(changes);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(arranged, "arranged");
    tetloft::PlaneOptions options;
    options.rule = enumerator_of(rule, tetloft::PlaneRule::merge, "rule");
    options.tolerance = tolerance;
    tetloft::ArrangedPlanes made = value_of(tetloft::arrange_planes(*value, options));
    hand_out(arranged, std::move(made.stack), changes, made.changes);
  });
}

tetloft_status tetloft_stack_snap(const tetloft_stack* stack, int bits,
                                  const tetloft_execution* execution, tetloft_stack** snapped) {
  clear(snapped);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(snapped, "snapped");
    hand_out(snapped, value_of(tetloft::snap(*value, bits, execution_of(execution))).stack);
  });
}

tetloft_status tetloft_stack_refine(const tetloft_stack* stack, double length,
                                    const tetloft_execution* execution, tetloft_stack** refined) {
  clear(refined);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(refined, "refined");
    hand_out(refined, value_of(tetloft::refine(*value, length, execution_of(execution))).stack);
  });
}
