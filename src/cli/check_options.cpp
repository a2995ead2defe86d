// See check_options.hpp.
#include "cli/check_options.hpp"

#include <utility>

#include "cli/engine_option.hpp"
#include "cli/stack_input.hpp"

namespace tetloft::cli {

std::vector<Option> check_option_list() {
  return {{"--motions", "",
           "with --correspondence moved: estimate anew how regions move, too; else that is taken "
           "from the model"},
          {"--strict", "",
           "no exceptions: cavities and tunnels that are not as defined fail, though the model "
           "says so"},
          model_format_option(),
          kThreadsOption};
}

Result<CheckOptions> check_options(const Arguments& arguments, Console& console) {
  CheckOptions options;
  auto correspondence = correspondence_options(arguments, console);
  if (!correspondence) return correspondence.error();
  options.correspondence = *std::move(correspondence);
  options.recompute_motions = arguments.has("--motions");
  options.strict = arguments.has("--strict");
  if (options.recompute_motions && options.correspondence.criterion != Criterion::moved) {
    console.warn({"--motions has no effect but with --correspondence moved", {}});
  }
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  options.execution.threads = *threads;
  return options;
}

}  // namespace tetloft::cli
