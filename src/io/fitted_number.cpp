#include "io/fitted_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// 0.d1d2d3… · 10^exponent, without zeros at the end.
struct DecimalDigits {
  std::string digits;
  int exponent = 0;
};

// Of a number above 0: rounded to so many digits, or the shortest that read back (0).
DecimalDigits digits_of(double value, int count) {
  char buffer[40];
  const std::to_chars_result end =
      count == 0
          ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific)
          : std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific,
                          count - 1);
  const std::string_view text(buffer, static_cast<std::size_t>(end.ptr - buffer));
  const std::size_t mark = text.find('e');
  DecimalDigits decimal;
  for (const char c : text.substr(0, mark)) {
    if (c != '.') decimal.digits += c;
  }
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0') decimal.digits.pop_back();
  decimal.exponent = static_cast<int>(parse_integer(text.substr(mark + 1)).value_or(0)) + 1;
  return decimal;
}

// The shorter of "123.45" or ".0012345" and "1.2345E-3".
std::string written_digits(const DecimalDigits& decimal) {
  const std::string& digits = decimal.digits;
  const int exponent = decimal.exponent;
  const auto count = static_cast<int>(digits.size());
  const std::string scientific =
      digits.substr(0, 1) + '.' + digits.substr(1) + 'E' + std::to_string(exponent - 1);
  const int fixed_size = 1 + std::max({count, exponent, count - exponent});
  if (fixed_size > static_cast<int>(scientific.size())) return scientific;
  std::string fixed = digits;
  if (exponent <= 0) return '.' + std::string(static_cast<std::size_t>(-exponent), '0') + fixed;
  const auto point = static_cast<std::size_t>(exponent);
  if (fixed.size() < point) fixed.resize(point, '0');
  return fixed.insert(point, 1, '.');
}

}  // namespace

std::string fitted_number(double value, std::size_t width) {
  const std::string sign = std::signbit(value) ? "-" : "";
  if (value == 0) return sign + "0.";
  const double size = std::fabs(value);
  std::string text = sign + written_digits(digits_of(size, 0));
  // Rounded up, the largest doubles can be beyond all: then with a digit less.
  for (int count = 16; text.size() > width || !parse_number(text).ok(); --count) {
    text = sign + written_digits(digits_of(size, count));
  }
  return text;
}

std::string FittedCoordinates::text_of(double coordinate) {
  ++count_;
  std::string text = fitted_number(coordinate, width_);
  const double read = parse_number(text).value;
  if (read != coordinate) {
    ++rounded_;
    largest_ = std::max(largest_, std::fabs(read - coordinate));
  }
  return text;
}

std::vector<Warning> FittedCoordinates::warnings() const {
  if (rounded_ == 0) return {};
  // In the few digits of float32, where it has such a number.
  const bool is_beyond =
      largest_ > std::numeric_limits<float>::max() || largest_ < std::numeric_limits<float>::min();
  std::string difference;
  is_beyond ? append_number(difference, largest_)
            : append_number(difference, static_cast<float>(largest_));
  return {{std::to_string(rounded_) + " of " + std::to_string(count_) +
               " coordinates have more digits than fit into the " + std::to_string(width_) +
               " characters of a field: they are rounded, by " + difference + " at most",
           {}}};
}

}  // namespace tetloft::internal::io
