#include "render/page_json.hpp"

#include <cmath>

#include "core/text.hpp"

namespace tetloft::internal::render {

std::string json_string(std::string_view text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : valid_utf8(text)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || c == '<' || c == '"' || c == '\\') {
      out += "\\u00";
      out += kDigits[byte >> 4];
      out += kDigits[byte & 15U];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : valid_utf8(text)) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string json_colour(const Rgb& colour) {
  return '[' + std::to_string(colour.r) + ',' + std::to_string(colour.g) + ',' +
         std::to_string(colour.b) + ']';
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text;
  io::append_number(text, value);
  return text;
}

}  // namespace tetloft::internal::render
