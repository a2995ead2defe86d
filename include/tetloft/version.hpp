#pragma once

namespace tetloft {

/// "major.minor.patch", as the command line prints it.
[[nodiscard]] const char* version();

}  // namespace tetloft
