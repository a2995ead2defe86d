// Numbers as text, the same in every locale.
//
// Reading accepts what strtod of the C locale accepts for finite numbers: an optional sign,
// decimal or hexadecimal (0x) digits with or without point, an exponent. Writing gives the
// shortest digits that read back to the same bits, −0.0 included.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tetloft/point.hpp>

namespace tetloft::internal::io {

enum class NumberStatus : std::uint8_t {
  ok,
  malformed,   ///< not a number, or followed by something else
  not_finite,  ///< nan, inf, or beyond the largest double
};

struct ParsedNumber {
  double value = 0;
  NumberStatus status = NumberStatus::malformed;
  [[nodiscard]] bool ok() const { return status == NumberStatus::ok; }
};

/// The whole of `token` as one number. What is too small for a denormal becomes zero of the
/// same sign.
[[nodiscard]] ParsedNumber parse_number(std::string_view token);

/// The whole of `token` as a decimal integer without fraction.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

/// Why `token` was not taken: "'abc' is not a number".
[[nodiscard]] std::string complaint(std::string_view token, NumberStatus status);

/// `token` for messages: quoted, cut after 40 bytes, printable (core/text.hpp).
[[nodiscard]] std::string in_quotes(std::string_view token);

/// Appends the shortest digits that read back exactly.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);

/// "x y z".
void append_point(std::string& text, const Point3& p);

template <std::integral I>
void append_number(std::string& text, I value) {
  char buffer[24];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

}  // namespace tetloft::internal::io
