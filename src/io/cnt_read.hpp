// Reading NUAGES .cnt.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// As read_cnt() in io.hpp.
[[nodiscard]] Result<StackOfFile> read_cnt_source(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
