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

}  // namespace tetloft::cli
