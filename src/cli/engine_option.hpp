// The options that name a Delaunay engine, limit its work and share it among threads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/delaunay3.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// The words of options that name an engine.
[[nodiscard]] std::vector<std::string> engine_words();
/// The engine that `option` names: auto, incremental or slab; automatic if it was not given.
[[nodiscard]] Result<DelaunayEngine> engine_option(const Arguments& arguments,
                                                   std::string_view option);

inline const Option kThreadsOption{"--threads", "N",
                                   "0 (default: all processors) to 1024; the result is the same"};
static_assert(kMostThreads == 1024);
/// What --threads says, 0 if it was not given.
[[nodiscard]] Result<unsigned> threads_option(const Arguments& arguments);

/// Of commands that build slabs.
inline const Option kWorkLimitOption{
    "--work-limit", "N",
    "tets per vertex that a slab may take, and a 16th as many vertices inserted into a section, "
    "before it is refused with exit code 7 (default 128, which no sane stack reaches; under 2^15 "
    "vertices as for 2^15)"};
/// Likewise.
inline const Option kNoDivideOption{
    "--no-divide", "",
    "take contours of few vertices as they are, where the default divides their long "
    "edges, so that what lies between follows both of two such contours; nothing is "
    "divided in sections of many vertices, as from images"};
/// What --work-limit says, above 0; `standard` if it was not given.
[[nodiscard]] Result<double> work_limit_option(const Arguments& arguments, double standard);

}  // namespace tetloft::cli
