// The options that name a Delaunay engine and limit its work.
#pragma once

#include <string_view>

#include <tetloft/delaunay.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// The engine that `option` names: auto, incremental or slab; automatic if it was not given.
[[nodiscard]] Result<DelaunayEngine> engine_option(const Arguments& arguments,
                                                   std::string_view option);

/// What --work-limit says, above 0; `standard` if it was not given.
[[nodiscard]] Result<double> work_limit_option(const Arguments& arguments, double standard);

}  // namespace tetloft::cli
