// The version, for the preprocessor and at run time.
#pragma once

#include <tetloft/export.hpp>

// CMake reads the project's version here.
#define TETLOFT_VERSION_MAJOR 0
#define TETLOFT_VERSION_MINOR 1
#define TETLOFT_VERSION_PATCH 0

namespace tetloft {

/// "major.minor.patch" of the library that runs, as the command line prints it; the macros are
/// those that the caller was compiled with.
[[nodiscard]] TETLOFT_API const char* version();

}  // namespace tetloft
