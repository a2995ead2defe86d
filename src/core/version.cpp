#include <tetloft/version.hpp>

#define TETLOFT_TEXT_OF(value) #value
#define TETLOFT_TEXT(value) TETLOFT_TEXT_OF(value)

namespace tetloft {

const char* version() {
  return TETLOFT_TEXT(TETLOFT_VERSION_MAJOR) "." TETLOFT_TEXT(
      TETLOFT_VERSION_MINOR) "." TETLOFT_TEXT(TETLOFT_VERSION_PATCH);
}

}  // namespace tetloft
