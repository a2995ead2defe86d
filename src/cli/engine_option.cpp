// See engine_option.hpp.
#include "cli/engine_option.hpp"

#include <array>
#include <vector>

#include "core/option_rules.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

constexpr std::array kEngines{DelaunayEngine::automatic, DelaunayEngine::incremental,
                              DelaunayEngine::slab};

}  // namespace

std::vector<std::string> engine_words() {
  std::vector<std::string> words;
  for (const DelaunayEngine engine : kEngines) words.emplace_back(name_of(engine));
  return words;
}

Result<DelaunayEngine> engine_option(const Arguments& arguments, std::string_view option) {
  const auto chosen = arguments.choice(option);
  if (!chosen) return chosen.error();
  return kEngines[chosen->value_or(0)];
}

Result<unsigned> threads_option(const Arguments& arguments) {
  const auto threads = arguments.integer("--threads", 0, kMostThreads);
  if (!threads) return threads.error();
  return static_cast<unsigned>(threads->value_or(0));
}

Result<double> work_limit_option(const Arguments& arguments, double standard) {
  const auto limit = arguments.number("--work-limit");
  if (!limit) return limit.error();
  if (limit->has_value() && !is_work_limit(**limit)) {
    return usage_error("option --work-limit: " + io::in_quotes(*arguments.text("--work-limit")) +
                       " is not above 0");
  }
  return limit->value_or(standard);
}

}  // namespace tetloft::cli
