#include "io/drawing/range_text.hpp"

#include <cstddef>

#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// The longest decimal number that `text` begins with; a point belongs to it where a digit follows,
// so that "0..5" is a range.
std::size_t length_of_number(std::string_view text) {
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
  text = trimmed(text);
  const std::size_t length = length_of_number(text);
  const ParsedNumber low = parse_number(text.substr(0, length));
  if (!low.ok()) return std::nullopt;
  text.remove_prefix(length);
  text = trimmed(text);
  if (text.empty()) return TextRange{low.value, low.value, false};
  for (const std::string_view between : {"-", "..", "\xE2\x80\x93", "\xE2\x80\x94", "to", ":"}) {
    if (text.substr(0, between.size()) != between) continue;
    text.remove_prefix(between.size());
    text = trimmed(text);
    const ParsedNumber high = parse_number(text.substr(0, length_of_number(text)));
    if (!high.ok() || length_of_number(text) != text.size() || !(low.value <= high.value)) {
      return std::nullopt;
    }
    return TextRange{low.value, high.value, true};
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::io
