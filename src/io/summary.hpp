// What a file of a format holds.
#pragma once

#include <tetloft/inspect.hpp>

#include "io/format.hpp"

namespace tetloft::internal::io {

/// But for the format's name. `format` reads stacks.
[[nodiscard]] Result<FileSummary> summary_of(const Format& format, const Source& source,
                                             const ReadOptions& options);

}  // namespace tetloft::internal::io
