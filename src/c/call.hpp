// How every function of the C interface is built: outputs are cleared, a body runs and throws what
// is wrong, the status says what became of it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <tetloft/tetloft.h>
#include <tetloft/result.hpp>

#include "c/last_error.hpp"
#include "core/guard.hpp"

namespace tetloft::internal::c {

/// Ends a body with a status that no ErrorCode has.
struct Refusal {
  tetloft_status status;
  std::string message;
};

[[noreturn]] inline void fail_usage(std::string message) {
  throw Failed(Error{ErrorCode::usage, std::move(message), {}});
}

/// Ends a body with TETLOFT_USAGE unless the output that is told as `name` can be written.
inline void require_output(const void* output, const char* name) {
  if (output == nullptr) fail_usage(std::string("the output ") + name + " is NULL");
}

/// Ends a body with TETLOFT_USAGE unless `index` is below `size`.
inline void require_index(std::size_t index, std::size_t size, const char* what) {
  if (index < size) return;
  fail_usage("there is no " + std::string(what) + ' ' + std::to_string(index) + ", only " +
             std::to_string(size));
}

/// The value of a result; its error ends the body.
template <class T>
[[nodiscard]] T value_of(Result<T> result) {
  if (!result) throw Failed(result.error());
  return std::move(result).value();
}
inline void require_success(const Result<void>& result) {
  if (!result) throw Failed(result.error());
}

/// Sets outputs that are asked for to NULL or 0.
template <class... T>
void clear(T*... outputs) noexcept {
  ((outputs != nullptr ? static_cast<void>(*outputs = T{}) : static_cast<void>(0)), ...);
}
/// Writes an output if it is asked for.
template <class T>
void put(T* output, T value) noexcept {
  if (output != nullptr) *output = value;
}

/// Runs a body; nothing that it throws leaves.
template <class Body>
[[nodiscard]] tetloft_status answer(Body&& body) noexcept {
  try {
    body();
    return TETLOFT_OK;
  } catch (...) {
    return remember_exception();
  }
}

}  // namespace tetloft::internal::c
