// What a page says, as JSON and HTML that is safe within it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/numbers.hpp"
#include "render/palette.hpp"

namespace tetloft::internal::render {

/// `text` as a JSON string, without a "<" that might be taken for a tag. Text that is not UTF-8
/// becomes so.
[[nodiscard]] std::string json_string(std::string_view text);
/// `text` between tags.
[[nodiscard]] std::string html_text(std::string_view text);
[[nodiscard]] std::string json_colour(const Rgb& colour);
/// The number, or null for one that is not finite.
[[nodiscard]] std::string json_number(double value);

/// One member of a JSON object at a time.
class JsonMembers {
 public:
  void text(const char* name, std::string_view value) { raw(name, json_string(value)); }
  void number(const char* name, double value) { raw(name, json_number(value)); }
  void flag(const char* name, bool value) { raw(name, value ? "true" : "false"); }
  void raw(const char* name, const std::string& value) {
    if (!out_.empty()) out_ += ',';
    out_ += json_string(name) + ':' + value;
  }
  /// item(k): the JSON of entry k.
  template <class Item>
  void list(const char* name, std::size_t n, Item&& item) {
    std::string all = "[";
    for (std::size_t k = 0; k < n; ++k) {
      if (k != 0) all += ',';
      all += item(k);
    }
    raw(name, all + ']');
  }
  [[nodiscard]] std::string object() const { return '{' + out_ + '}'; }

 private:
  std::string out_;
};

}  // namespace tetloft::internal::render
