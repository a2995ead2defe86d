#include <tetloft/version.hpp>

namespace tetloft {

const char* version() { return TETLOFT_VERSION; }

}  // namespace tetloft
