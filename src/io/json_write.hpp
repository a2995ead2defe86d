// One JSON value (RFC 8259), written front to back: always valid UTF-8, and nothing in it that
// misleads a terminal (core/text.hpp).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetloft::internal::io {

class JsonWriter {
 public:
  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_array() { begin('['); }
  void end_array() { end(']'); }
  /// The key of the next value. Only within an object.
  void key(std::string_view name);

  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(bool flag) { raw(flag ? "true" : "false"); }
  /// Shortest digits that read back exactly; null where JSON has no number (nan, inf).
  void value(double number);
  /// null where there is none.
  template <class T>
  void value(const std::optional<T>& known) {
    if (known) return value(*known);
    raw("null");
  }
  template <std::integral I>
  requires(!std::same_as<I, bool>) void value(I number) { raw(std::to_string(number)); }
  /// An array of these.
  template <class T>
  void value(const std::vector<T>& values) {
    value_all(values);
  }
  template <class T, std::size_t N>
  void value(const std::array<T, N>& values) {
    value_all(values);
  }

  /// key() and value() in one.
  template <class T>
  void member(std::string_view name, const T& content) {
    key(name);
    value(content);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  template <class List>
  void value_all(const List& values) {
    begin_array();
    for (const auto& one : values) value(one);
    end_array();
  }
  void begin(char bracket);
  void end(char bracket);
  void separate();
  void raw(std::string_view token);
  void append_string(std::string_view text);

  std::string text_;
  std::vector<bool> has_member_;  // of each open object or array
  bool after_key_ = false;
};

}  // namespace tetloft::internal::io
