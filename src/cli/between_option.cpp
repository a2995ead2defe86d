// See between_option.hpp.
#include "cli/between_option.hpp"

#include "core/option_rules.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

Option sections_between(std::string_view name, const std::string& standard) {
  return {std::string(name),
          "N",
          "sections to put between two given ones, interpolated: a number, auto (as many as gaps "
          "and contour edges call for, none where sections are dense) or none; default: " +
              standard,
          {},
          {"auto", "none"}};
}

Result<std::optional<std::size_t>> sections_between_option(const Arguments& arguments,
                                                           std::string_view name,
                                                           std::optional<std::size_t> standard) {
  const std::optional<std::string> text = arguments.text(name);
  if (!text) return standard;
  if (*text == "none") return std::optional<std::size_t>(0);
  if (*text == "auto") return std::optional<std::size_t>();
  const auto count = arguments.integer(name, 0, kMostBetween);
  if (!count) {
    return usage_error("option " + std::string(name) + ": " + io::in_quotes(*text) +
                       " is neither auto nor none nor a number from 0 to " +
                       std::to_string(kMostBetween));
  }
  return std::optional(static_cast<std::size_t>(**count));
}

}  // namespace tetloft::cli
