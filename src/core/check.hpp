// Internal invariants. TETLOFT_CHECK throws InternalError; the API boundary
// (guard_internal) turns it into Error{internal}. Never used on user input.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include <tetloft/result.hpp>

namespace tetloft {

class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws InternalError naming the violated condition and its place in the source.
[[noreturn]] void fail_check(const char* condition, const char* file, int line);

/// Ends an API function with ErrorCode::cancelled.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Needs no memory itself: texts this short live in the string.
[[nodiscard]] Error out_of_memory();

/// What the exception in flight means to a caller. Only in a catch block.
[[nodiscard]] Error error_of_exception();

/// Runs an API function's body: returns its Result, and turns anything thrown inside
/// into an Error.
template <class Body>
auto guard_internal(Body&& body) -> decltype(body()) {
  try {
    return body();
  } catch (...) {
    return error_of_exception();
  }
}

/// Where a refusal is an answer, as of a trial: whether `result` is none. Throws std::bad_alloc
/// where memory ended instead: that answers nothing.
template <class T>
[[nodiscard]] bool accepted(const Result<T>& result) {
  if (!result && result.error().code == ErrorCode::out_of_memory) throw std::bad_alloc();
  return result.ok();
}

}  // namespace tetloft

#define TETLOFT_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::tetloft::fail_check(#condition, __FILE__, __LINE__))
