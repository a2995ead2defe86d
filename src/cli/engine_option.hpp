// The option that names a Delaunay engine.
#pragma once

#include <string_view>

#include <tetloft/delaunay.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// The engine that `option` names: auto, incremental or slab; automatic if it was not given.
[[nodiscard]] Result<DelaunayEngine> engine_option(const Arguments& arguments,
                                                   std::string_view option);

}  // namespace tetloft::cli
