// Reading and writing numbers with <charconv>.
#include "io/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace tetloft::io {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

// Whether a number that no double can hold is too large (otherwise it is too small).
// `digits` is well-formed, unsigned and without 0x.
bool is_too_large(std::string_view digits, bool hex) {
  // The exponent of the first non-zero digit, and the written exponent, both saturating far
  // outside of any double.
  long long leading = 0;
  bool seen_point = false;
  bool seen_nonzero = false;
  std::size_t i = 0;
  for (; i < digits.size(); ++i) {
    const char c = digits[i];
    if (c == '.') {
      seen_point = true;
      continue;
    }
    if (hex ? !is_hex_digit(c) : !is_digit(c)) break;
    if (c != '0') seen_nonzero = true;
    if (seen_nonzero && !seen_point) ++leading;
    if (!seen_nonzero && seen_point) --leading;
  }
  constexpr long long kFar = 1'000'000'000'000'000LL;
  long long exponent = 0;
  bool negative = false;
  if (i < digits.size()) ++i;  // past the e or p
  for (; i < digits.size(); ++i) {
    if (digits[i] == '-') negative = true;
    if (is_digit(digits[i])) exponent = std::min(kFar, exponent * 10 + (digits[i] - '0'));
  }
  if (negative) exponent = -exponent;
  return leading * (hex ? 4 : 1) + exponent > 0;
}

ParsedNumber parse_magnitude(std::string_view digits, bool hex) {
  if (digits.empty()) return {};
  ParsedNumber number;
  const auto format = hex ? std::chars_format::hex : std::chars_format::general;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number.value, format);
  if (error == std::errc::invalid_argument || stop != end) return {};
  number.status = NumberStatus::ok;
  if (error == std::errc::result_out_of_range) {
    number.value = 0;
    if (is_too_large(digits, hex)) number.status = NumberStatus::not_finite;
  }
  if (!std::isfinite(number.value)) number.status = NumberStatus::not_finite;
  return number;
}

}  // namespace

ParsedNumber parse_number(std::string_view token) {
  const bool negative = !token.empty() && token.front() == '-';
  if (negative || (!token.empty() && token.front() == '+')) token.remove_prefix(1);
  // from_chars would take a second sign.
  if (token.empty() || token.front() == '-' || token.front() == '+') return {};
  const bool hex = token.size() > 2 && token[0] == '0' && (token[1] == 'x' || token[1] == 'X');
  if (hex) {
    token.remove_prefix(2);
    // from_chars would take a sign, inf or nan here too.
    if (token.front() != '.' && !is_hex_digit(token.front())) return {};
  }
  ParsedNumber number = parse_magnitude(token, hex);
  if (negative) number.value = -number.value;
  return number;
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  if (token.size() > 1 && token.front() == '+' && is_digit(token[1])) token.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : token.substr(0, kLongest)) {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  text += token.size() > kLongest ? "…'" : "'";
  return text;
}

std::string complaint(std::string_view token, NumberStatus status) {
  return quoted(token) +
         (status == NumberStatus::not_finite ? " is not a finite number" : " is not a number");
}

namespace {

// Longest shortest form: sign, 17 digits, point, e, sign, three digits; fixed notation is
// only taken by to_chars where it is not longer.
template <class Float>
void append_float(std::string& text, Float value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

}  // namespace

void append_number(std::string& text, double value) { append_float(text, value); }
void append_number(std::string& text, float value) { append_float(text, value); }

}  // namespace tetloft::io
