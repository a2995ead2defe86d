// Results of the library for programs that end with the first error.
#pragma once

#include <stdexcept>
#include <utility>

#include <tetloft/result.hpp>

namespace tetloft::bench {

/// Throws std::runtime_error with the text of the error, if there is one.
template <class T>
void throw_if_failed(const Result<T>& result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
}

/// The value; throws as above.
template <class T>
[[nodiscard]] T value_of(Result<T> result) {
  throw_if_failed(result);
  return std::move(*result);
}

}  // namespace tetloft::bench
