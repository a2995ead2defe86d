// Writing JSON.
#include "io/json_write.hpp"

#include <cmath>
#include <cstdio>

#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

void JsonWriter::separate() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (has_member_.empty()) return;
  if (has_member_.back()) text_ += ',';
  has_member_.back() = true;
}

void JsonWriter::begin(char bracket) {
  separate();
  text_ += bracket;
  has_member_.push_back(false);
}

void JsonWriter::end(char bracket) {
  text_ += bracket;
  has_member_.pop_back();
}

void JsonWriter::raw(std::string_view token) {
  separate();
  text_ += token;
}

void JsonWriter::key(std::string_view name) {
  separate();
  append_string(name);
  text_ += ':';
  after_key_ = true;
}

void JsonWriter::value(std::string_view text) {
  separate();
  append_string(text);
}

void JsonWriter::value(double number) {
  if (!std::isfinite(number)) return raw("null");
  std::string digits;
  append_number(digits, number);
  raw(digits);
}

void JsonWriter::append_string(std::string_view text) {
  text_ += '"';
  while (!text.empty()) {
    const TextUnit unit = first_unit(text);
    const char c = text.front();
    if (!unit.valid) {
      text_ += "\\ufffd";  // file names need not be UTF-8
    } else if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (misleads(unit.code)) {  // all below U+10000; a terminal may show the object
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(unit.code));
      text_ += escaped;
    } else {
      text_ += text.substr(0, unit.length);
    }
    text.remove_prefix(unit.length);
  }
  text_ += '"';
}

}  // namespace tetloft::internal::io
