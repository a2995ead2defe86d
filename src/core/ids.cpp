// See ids.hpp.
#include <tetloft/ids.hpp>

#include <stdexcept>

namespace tetloft {

void throw_no_id() {
  throw std::out_of_range("a number that is no id: negative, or 2^32 - 1 or more");
}

}  // namespace tetloft
