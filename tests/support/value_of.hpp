// What a test does with a result that has to be there.
#pragma once

#include <stdexcept>
#include <utility>

#include <tetloft/result.hpp>

namespace tetloft::test {

/// A value that is there, or a failed test that ends.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return *std::move(result);
}

}  // namespace tetloft::test
