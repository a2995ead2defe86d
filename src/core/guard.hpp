// Guards. Inside the library TETLOFT_CHECK throws InternalError where an invariant is broken; never
// used on user input. At the edge of the API guard_internal turns whatever is thrown into an Error.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include <tetloft/result.hpp>

namespace tetloft::internal {

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

/// An Error on its way through code that has no use for it.
class Failed : public std::exception {
 public:
  explicit Failed(Error error) : error_(std::move(error)) {}
  [[nodiscard]] const char* what() const noexcept override { return error_.message.c_str(); }
  [[nodiscard]] const Error& error() const noexcept { return error_; }

 private:
  Error error_;
};

/// Is such an error an answer, as of a trial? Others say nothing about what was tried: memory
/// ended, say.
[[nodiscard]] inline bool is_refusal(ErrorCode code) {
  return code == ErrorCode::invalid_input || code == ErrorCode::unrepresentable ||
         code == ErrorCode::work_limit;
}

/// Where a refusal is an answer, as of a trial: whether `result` is none. Throws Failed where the
/// error says nothing about what was tried: memory ended, say.
template <class T>
[[nodiscard]] bool accepted(const Result<T>& result) {
  if (result) return true;
  if (is_refusal(result.error().code)) return false;
  throw Failed(result.error());
}

}  // namespace tetloft::internal

#define TETLOFT_CHECK(condition)      \
  ((condition) ? static_cast<void>(0) \
               : ::tetloft::internal::fail_check(#condition, __FILE__, __LINE__))
