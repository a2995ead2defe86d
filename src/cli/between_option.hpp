// The option that says how many sections are put between two given ones.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

[[nodiscard]] Option sections_between(std::string_view name, const std::string& standard);

/// As ReconstructOptions::between; `standard` if the option was not given.
[[nodiscard]] Result<std::optional<std::size_t>> sections_between_option(
    const Arguments& arguments, std::string_view name, std::optional<std::size_t> standard);

}  // namespace tetloft::cli
