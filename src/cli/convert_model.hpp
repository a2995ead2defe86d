// tetloft convert of a model: its solid or its boundary in another format, whole or by components.
#pragma once

#include <string>

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// --model-format, --to and --per-component, which are of models alone; and --ascii and --compress,
/// which are of stacks, too.
[[nodiscard]] std::vector<Option> model_conversion_options();

/// Whether the input is to be read as a model: what --model-format and --to say, else what the
/// output can hold, else what the input's extension says.
[[nodiscard]] bool converts_model(const Arguments& arguments, const std::string& output);

/// Exit code, or the error that stopped it.
[[nodiscard]] Result<int> convert_model(const Arguments& arguments, const std::string& output,
                                        Console& console);

}  // namespace tetloft::cli
