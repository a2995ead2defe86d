// Checks at the entry of public functions that return plain values: what is wrong is thrown, and
// where such a function is called inside, the API boundary makes an Error{internal} of it.
#pragma once

#include <stdexcept>

namespace tetloft::internal {

/// An id names nothing.
inline void require_named(bool named, const char* what) {
  if (!named) throw std::out_of_range(what);
}

/// Arguments are no values of their kind, or do not belong together.
inline void require_fit(bool fit, const char* what) {
  if (!fit) throw std::invalid_argument(what);
}

}  // namespace tetloft::internal
