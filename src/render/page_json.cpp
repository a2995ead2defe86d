#include "render/page_json.hpp"

#include "core/text.hpp"

namespace tetloft::internal::render {

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

std::string json_script(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  // In JSON it stands in strings only.
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

void json_text(io::JsonWriter& json, std::string_view name, std::string_view text) {
  json.member(name, valid_utf8(text));
}

}  // namespace tetloft::internal::render
