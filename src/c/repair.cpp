// Stacks: validated, and made fit.
#include <tetloft/repair.hpp>

#include "c/handles.hpp"
#include "c/options.hpp"

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
