#include "io/drawing/range_text.hpp"

#include <cstddef>

#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void trim(std::string_view& text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
}

// The longest decimal number that `text` begins with; a point belongs to it where a digit follows,
// so that "0..5" is a range.
std::size_t number_length(std::string_view text) {
  std::size_t at = 0;
  const auto here = [&](std::size_t further) {
    return at + further < text.size() ? text[at + further] : '\0';
  };
  if (here(0) == '-' || here(0) == '+') ++at;
  while (is_digit(here(0))) ++at;
  if (here(0) == '.' && is_digit(here(1))) {
    ++at;
    while (is_digit(here(0))) ++at;
  }
  const bool exponent =
      (here(0) == 'e' || here(0) == 'E') &&
      (is_digit(here(1)) || ((here(1) == '-' || here(1) == '+') && is_digit(here(2))));
  if (exponent && at > 0) {
    at += 2;
    while (is_digit(here(0))) ++at;
  }
  return at;
}

}  // namespace

std::optional<TextRange> parse_range(std::string_view text) {
  trim(text);
  const std::size_t length = number_length(text);
  const ParsedNumber low = parse_number(text.substr(0, length));
  if (!low.ok()) return std::nullopt;
  text.remove_prefix(length);
  trim(text);
  if (text.empty()) return TextRange{low.value, low.value, false};
  for (const std::string_view between : {"-", "..", "\xE2\x80\x93", "\xE2\x80\x94", "to", ":"}) {
    if (text.substr(0, between.size()) != between) continue;
    text.remove_prefix(between.size());
    trim(text);
    const ParsedNumber high = parse_number(text.substr(0, number_length(text)));
    if (!high.ok() || number_length(text) != text.size() || !(low.value <= high.value)) {
      return std::nullopt;
    }
    return TextRange{low.value, high.value, true};
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::io
