// What a page says, as JSON and HTML that is safe within it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/json_write.hpp"
#include "render/palette.hpp"

namespace tetloft::internal::render {

/// `text` between tags.
[[nodiscard]] std::string html_text(std::string_view text);
/// JSON as a script: without a "<" that might be taken for a tag.
[[nodiscard]] std::string json_script(std::string_view json);

/// Text from outside, made UTF-8.
void json_text(io::JsonWriter& json, std::string_view name, std::string_view text);
/// value(k): entry k of the array.
template <class Value>
void json_list(io::JsonWriter& json, std::string_view name, std::size_t n, Value&& value) {
  json.key(name);
  json.begin_array();
  for (std::size_t k = 0; k < n; ++k) json.value(value(k));
  json.end_array();
}
/// colour(k): the Rgb of entry k, which becomes [r, g, b].
template <class Colour>
void json_colours(io::JsonWriter& json, std::string_view name, std::size_t n, Colour&& colour) {
  json.key(name);
  json.begin_array();
  for (std::size_t k = 0; k < n; ++k) {
    const Rgb c = colour(k);
    json.begin_array();
    for (const std::uint8_t part : {c.r, c.g, c.b}) json.value(part);
    json.end_array();
  }
  json.end_array();
}

}  // namespace tetloft::internal::render
