// Errors as values.
//
// The library never prints, exits or aborts. A function that can fail returns a Result, which
// holds either a value or an Error that says what is wrong and where; no exception leaves it, and
// what the caller gave it stays as it was. Where memory ends it is ErrorCode::out_of_memory, and
// nothing is lost: no file, no block, no thread.
//
// Arguments are checked at entry. A function that returns a Result refuses what does not fit, as
// invalid_input or usage. Functions that return anything else (star(), nest(), outlines(),
// to_string(), …) throw: std::out_of_range for an id that names nothing, std::invalid_argument for
// arguments that are no values of their kind or do not belong together, std::bad_alloc where memory
// ends; all objects stay valid. Only small accessors in headers (vertex(), opposite(),
// IdVector's [], …) do not check: what they require is said there, and the standard library's
// assertions (-D_GLIBCXX_ASSERTIONS) watch over it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft {

/// What kind of failure; the values are the exit codes of the command line.
enum class ErrorCode : int {
  usage = 2,              ///< options that contradict each other or make no sense
  invalid_input = 3,      ///< the input is not a valid stack, mesh, label or point set
  io = 4,                 ///< a file cannot be read or written
  unrepresentable = 5,    ///< double precision holds no valid model of this input
  cancelled = 6,          ///< stopped at the caller's wish, or by an exception of a callback
  work_limit = 7,         ///< more work than the caller's limit allows; a higher one may succeed
  internal = 70,          ///< a defect of the library
  out_of_memory = 71,     ///< memory ended, or the system's limit on it
  unfit_arithmetic = 72,  ///< compiled or run without the arithmetic that exactness needs
};

/// Lower-case name of a code, as printed in JSON ("invalid_input").
[[nodiscard]] TETLOFT_API const char* name_of(ErrorCode code);

/// Where something is wrong; every part is optional.
struct Place {
  std::string file;
  std::optional<std::size_t> line;     ///< one-based
  std::optional<std::size_t> section;  ///< zero-based, like all below
  std::optional<std::size_t> slab;     ///< between sections `slab` and `slab + 1`
  std::optional<std::size_t> contour;
  std::optional<std::size_t> vertex;
  std::optional<Point3> point;  ///< coordinates, z included where known
};

/// "file.cnt:12: section 3, contour 0, vertex 7 (1.5, 2, 30)"; empty for an empty place. This and
/// the texts below are one line that can be shown anywhere: control characters, marks of the
/// direction of writing and bytes that are no UTF-8 (all as file names may hold them) are escaped,
/// "\x1b".
[[nodiscard]] TETLOFT_API std::string to_string(const Place& place);

struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
  Place where;
};

/// Place and message in one line, as the command line prints it.
[[nodiscard]] TETLOFT_API std::string to_string(const Error& error);

/// Something that was mended or that the user should know; never a failure.
struct Warning {
  std::string message;
  Place where;
};

[[nodiscard]] TETLOFT_API std::string to_string(const Warning& warning);

/// A value, or the Error that prevented it.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value. Requires ok().
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// The error. Requires !ok().
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}
  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] const Error& error() const { return error_.value(); }

 private:
  std::optional<Error> error_;
};

}  // namespace tetloft
