// See engine_option.hpp.
#include "cli/engine_option.hpp"

#include <string>

#include "io/numbers.hpp"

namespace tetloft::cli {

Result<DelaunayEngine> engine_option(const Arguments& arguments, std::string_view option) {
  const auto name = arguments.text(option);
  if (!name) return DelaunayEngine::automatic;
  for (const DelaunayEngine engine :
       {DelaunayEngine::automatic, DelaunayEngine::incremental, DelaunayEngine::slab}) {
    if (*name == name_of(engine)) return engine;
  }
  return usage_error("option " + std::string(option) + ": " + io::in_quotes(*name) +
                     " is none of auto, incremental, slab");
}

Result<double> work_limit_option(const Arguments& arguments, double standard) {
  const auto limit = arguments.number("--work-limit");
  if (!limit) return limit.error();
  if (limit->has_value() && !(**limit > 0)) {
    return usage_error("option --work-limit: " + io::in_quotes(*arguments.text("--work-limit")) +
                       " is not above 0");
  }
  return limit->value_or(standard);
}

}  // namespace tetloft::cli
