// tetloft reconstruct --roi all: a solid of each structure of a file.
#pragma once

#include "cli/reconstruct_request.hpp"

namespace tetloft::cli {

/// Several at once. What fails is named and leaves no file; the others are written. Returns 0, or
/// the code of the first failure in the order of the file.
[[nodiscard]] Result<int> reconstruct_all(const Arguments& arguments,
                                          const ReconstructRequest& request, Console& console);

}  // namespace tetloft::cli
