// See reconstruct_request.hpp.
#include "cli/reconstruct_request.hpp"

#include <utility>

#include "cli/between_option.hpp"
#include "cli/engine_option.hpp"
#include "cli/verdicts.hpp"
#include "core/option_rules.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

std::vector<Option> solid_options() {
  return {sections_between("--between", "auto"),
          kNoDivideOption,
          {"--ends",
           "HOW",
           "the ends of the stack: flat (default) at the outer sections, or half a gap "
           "beyond them",
           {},
           {"flat", "half"}},
          {"--thickness", "T", "of the solid made of a single section, above 0"},
          {"--delaunay",
           "ENGINE",
           "slab (default) or incremental: what triangulates the slabs; the result is the "
           "same",
           {},
           engine_words()},
          kWorkLimitOption,
          kThreadsOption};
}

Result<ReconstructRequest> reconstruct_request_of(const Arguments& arguments, Console& console) {
  auto outputs = model_outputs(arguments);
  if (!outputs) return outputs.error();
  Result<ReconstructRequest> request = solid_request_of(arguments, console);
  if (request) request->outputs = *std::move(outputs);
  return request;
}

Result<ReconstructRequest> solid_request_of(const Arguments& arguments, Console& console) {
  ReconstructRequest request;
  request.input = arguments.operand(0);
  const auto correspondence = correspondence_options(arguments, console);
  if (!correspondence) return correspondence.error();
  request.options.correspondence = *correspondence;
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  request.preparation = *prepared;
  const auto between = sections_between_option(arguments, "--between", std::nullopt);
  if (!between) return between.error();
  request.options.between = *between;
  const auto ends = arguments.choice("--ends");
  if (!ends) return ends.error();
  request.options.ends = ends->value_or(0) == 0 ? Ends::flat : Ends::half;
  request.options.divide_coarse = !arguments.has("--no-divide");
  const auto thickness = arguments.number("--thickness");
  if (!thickness) return thickness.error();
  if (thickness->has_value() && !is_length(**thickness)) {
    return usage_error("option --thickness: " + io::in_quotes(*arguments.text("--thickness")) +
                       " is not above 0");
  }
  request.options.thickness = *thickness;
  const auto engine = engine_option(arguments, "--delaunay");
  if (!engine) return engine.error();
  request.options.delaunay = *engine;
  const auto work = work_limit_option(arguments, kDefaultWorkLimit);
  if (!work) return work.error();
  request.options.work_limit = *work;
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  request.options.execution.threads = *threads;
  request.verify = arguments.has("--verify");
  return request;
}

Result<void> verify(const Model& model, const SectionStack& stack,
                    const ReconstructOptions& made_with) {
  CheckOptions options;
  options.correspondence = made_with.correspondence;
  options.execution.threads = made_with.execution.threads;
  const Result<CheckReport> report = check(model, stack, options);
  if (!report) return report.error();
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    if (verdict.pass) continue;
    return Error{ErrorCode::internal,
                 "verification failed: " + describe(verdict, verdict.failures.front()),
                 {}};
  }
  return {};
}

}  // namespace tetloft::cli
