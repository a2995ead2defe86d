// See engine_option.hpp.
#include "cli/engine_option.hpp"

#include <array>
#include <vector>

namespace tetloft::cli {

Result<DelaunayEngine> engine_option(const Arguments& arguments, std::string_view option) {
  constexpr std::array kEngines{DelaunayEngine::automatic, DelaunayEngine::incremental,
                                DelaunayEngine::slab};
  std::vector<std::string_view> names;
  for (const DelaunayEngine engine : kEngines) names.emplace_back(name_of(engine));
  const auto chosen = arguments.choice(option, names);
  if (!chosen) return chosen.error();
  return kEngines[chosen->value_or(0)];
}

}  // namespace tetloft::cli
