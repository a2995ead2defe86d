// Reading and writing numbers: <charconv> for decimals, hexadecimal by hand.
#include "io/numbers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <system_error>

#include "core/text.hpp"
#include "io/cursor.hpp"

namespace tetloft::internal::io {

namespace {

// Value of a hexadecimal digit, or −1.
int hex_value(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// The written exponent (digits with an optional sign), saturating far outside of any
// double; empty if malformed.
std::optional<long long> parse_exponent(std::string_view text) {
  constexpr long long kFar = 1'000'000'000'000'000LL;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
  long long exponent = 0;
  for (const char c : text) exponent = std::min(kFar, exponent * 10 + (c - '0'));
  return negative ? -exponent : exponent;
}

// Whether a well-formed decimal number that no double can hold is too large (otherwise it
// is too small).
bool is_too_large(std::string_view digits) {
  const std::size_t mark = std::min(digits.find_first_of("eE"), digits.size());
  long long leading = 0;  // the power of ten above the first non-zero digit
  bool seen_point = false;
  bool seen_nonzero = false;
  for (const char c : digits.substr(0, mark)) {
    if (c == '.') {
      seen_point = true;
      continue;
    }
    if (c != '0') seen_nonzero = true;
    if (seen_nonzero && !seen_point) ++leading;
    if (!seen_nonzero && seen_point) --leading;
  }
  if (mark == digits.size()) return leading > 0;
  return leading + parse_exponent(digits.substr(mark + 1)).value_or(0) > 0;
}

ParsedNumber parse_decimal(std::string_view digits) {
  ParsedNumber number;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number.value);
  if (error == std::errc::invalid_argument || stop != end) return {};
  number.status = NumberStatus::ok;
  if (error == std::errc::result_out_of_range) {
    number.value = 0;
    if (is_too_large(digits)) number.status = NumberStatus::not_finite;
  }
  if (!std::isfinite(number.value)) number.status = NumberStatus::not_finite;
  return number;
}

// mantissa · 2^exponent, and a little more if `inexact` (which requires a mantissa of more
// than 53 bits), to the nearest double, ties to even. Done by hand: std::ldexp would round
// a second time where the result is denormal.
double round_binary(std::uint64_t mantissa, long long exponent, bool inexact) {
  if (mantissa == 0) return 0;
  constexpr int kDigits = std::numeric_limits<double>::digits;
  constexpr long long kLeastExponent = std::numeric_limits<double>::min_exponent - kDigits;
  const int width = static_cast<int>(std::bit_width(mantissa));
  const long long dropped = std::max<long long>(width - kDigits, kLeastExponent - exponent);
  if (dropped > 64) return 0;
  if (dropped > 0) {
    // The half bit and everything below decide; a shift by all 64 bits is not defined.
    const std::uint64_t kept = dropped == 64 ? 0 : mantissa >> dropped;
    const bool half = (mantissa >> (dropped - 1) & 1U) != 0;
    const bool below = inexact || (mantissa & ((std::uint64_t{1} << (dropped - 1)) - 1)) != 0;
    mantissa = kept + (half && (below || (kept & 1U) != 0) ? 1 : 0);
    exponent += dropped;
  }
  constexpr long long kOverflow = 2 * std::numeric_limits<double>::max_exponent;
  return std::ldexp(static_cast<double>(mantissa), static_cast<int>(std::min(exponent, kOverflow)));
}

// Behind the 0x. By hand because std::from_chars of some standard libraries rounds hex
// denormals wrongly and takes two signs in the exponent.
ParsedNumber parse_hexadecimal(std::string_view text) {
  std::uint64_t mantissa = 0;
  long long exponent = 0;
  bool inexact = false;
  bool seen_point = false;
  bool seen_digit = false;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    if (text[i] == '.' && !seen_point) {
      seen_point = true;
      continue;
    }
    const int digit = hex_value(text[i]);
    if (digit < 0) break;
    seen_digit = true;
    // Digits that find no room only count as being zero or not.
    const bool room = mantissa >> 60 == 0;
    if (room) mantissa = mantissa << 4 | static_cast<std::uint64_t>(digit);
    if (!room && digit != 0) inexact = true;
    if (room && seen_point) exponent -= 4;
    if (!room && !seen_point) exponent += 4;
  }
  if (!seen_digit) return {};
  if (i < text.size()) {
    if (text[i] != 'p' && text[i] != 'P') return {};
    const auto written = parse_exponent(text.substr(i + 1));
    if (!written) return {};
    exponent += *written;
  }
  const double value = round_binary(mantissa, exponent, inexact);
  return {value, std::isfinite(value) ? NumberStatus::ok : NumberStatus::not_finite};
}

}  // namespace

ParsedNumber parse_number(std::string_view token) {
  const bool negative = !token.empty() && token.front() == '-';
  if (negative || (!token.empty() && token.front() == '+')) token.remove_prefix(1);
  // from_chars would take a second sign.
  if (token.empty() || token.front() == '-' || token.front() == '+') return {};
  const bool hex = token.size() > 2 && token[0] == '0' && (token[1] == 'x' || token[1] == 'X');
  ParsedNumber number = hex ? parse_hexadecimal(token.substr(2)) : parse_decimal(token);
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

std::string in_quotes(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  const std::string_view shown = beginning(token, kLongest);
  return '\'' + printable(shown) + (shown.size() < token.size() ? "…'" : "'");
}

std::string complaint(std::string_view token, NumberStatus status) {
  return in_quotes(token) +
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

void append_point(std::string& text, const Point3& p) {
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
  append_number(text, p.z);
}

}  // namespace tetloft::internal::io
