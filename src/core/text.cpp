// See text.hpp.
#include "core/text.hpp"

#include <cstdio>

namespace tetloft::internal {

namespace {

// Bytes after the lead byte and the range of the first of them (Unicode, table 3-7).
struct Form {
  std::size_t tail = 0;
  unsigned low = 0x80, high = 0xBF;
  bool valid = false;
};

Form form_of(unsigned lead) {
  if (lead < 0x80) return {0, 0, 0, true};
  if (lead >= 0xC2 && lead <= 0xDF) return {1, 0x80, 0xBF, true};
  if (lead == 0xE0) return {2, 0xA0, 0xBF, true};
  if (lead == 0xED) return {2, 0x80, 0x9F, true};
  if (lead >= 0xE1 && lead <= 0xEF) return {2, 0x80, 0xBF, true};
  if (lead == 0xF0) return {3, 0x90, 0xBF, true};
  if (lead >= 0xF1 && lead <= 0xF3) return {3, 0x80, 0xBF, true};
  if (lead == 0xF4) return {3, 0x80, 0x8F, true};
  return {};
}

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code <= 0x9F); }

}  // namespace

TextUnit first_unit(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const TextUnit stray{1, lead, false};
  const Form form = form_of(lead);
  if (!form.valid || text.size() <= form.tail) return stray;
  if (form.tail == 0) return {1, lead, true};
  char32_t code = lead & (0x3FU >> form.tail);
  for (std::size_t i = 1; i <= form.tail; ++i) {
    const unsigned low = i == 1 ? form.low : 0x80;
    const unsigned high = i == 1 ? form.high : 0xBF;
    if (byte(i) < low || byte(i) > high) return stray;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  return {form.tail + 1, code, true};
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const TextUnit unit = first_unit(text);
    if (!unit.valid) return false;
    text.remove_prefix(unit.length);
  }
  return true;
}

bool misleads(char32_t code) {
  const auto in = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return is_control(code) || code == 0x061C || in(0x200E, 0x200F) || in(0x2028, 0x202E) ||
         in(0x2066, 0x2069);
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const TextUnit unit = first_unit(text);
    if (unit.valid && !misleads(unit.code)) {
      shown += text.substr(0, unit.length);
    } else {
      char escaped[16];
      std::snprintf(escaped, sizeof escaped, unit.code < 0x100 ? "\\x%02x" : "\\u{%04x}",
                    static_cast<unsigned>(unit.code));
      shown += escaped;
    }
    text.remove_prefix(unit.length);
  }
  return shown;
}

std::string_view beginning(std::string_view text, std::size_t most) {
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t next = end + first_unit(text.substr(end)).length;
    if (next > most) break;
    end = next;
  }
  return text.substr(0, end);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = lower_case(c);
  return lower;
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  valid.reserve(text.size());
  while (!text.empty()) {
    const TextUnit unit = first_unit(text);
    const bool white = unit.code == '\t' || unit.code == '\n' || unit.code == '\r';
    const bool no_character = unit.code == 0xFFFE || unit.code == 0xFFFF;
    if (unit.valid && !no_character && (white || !is_control(unit.code))) {
      valid += text.substr(0, unit.length);
    } else {
      valid += "\xEF\xBF\xBD";
    }
    text.remove_prefix(unit.length);
  }
  return valid;
}

}  // namespace tetloft::internal
