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

/// Runs an API function's body: returns its Result, and turns anything thrown inside
/// into an Error.
template <class Body>
auto guard_internal(Body&& body) -> decltype(body()) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::internal, "out of memory", {}};
  } catch (const Cancelled& e) {
    return Error{ErrorCode::cancelled, e.what(), {}};
  } catch (const std::exception& e) {
    return Error{ErrorCode::internal, e.what(), {}};
  } catch (...) {
    return Error{ErrorCode::internal, "unknown exception", {}};
  }
}

}  // namespace tetloft

#define TETLOFT_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::tetloft::fail_check(#condition, __FILE__, __LINE__))
