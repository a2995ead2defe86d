// tetloft info of plans, of pieces, and of indices over them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "cli/console.hpp"

namespace tetloft::cli {

/// What `info` prints of a plan or a piece, all of which is read and checked, or of an index, whose
/// pieces' heads are; nothing of another file. `path` is of a file, not of a stream.
[[nodiscard]] Result<std::optional<std::string>> plan_or_piece_info(const std::string& path,
                                                                    const Console& console);

}  // namespace tetloft::cli
