// What a page holds, unpacked by code of the tests.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/json_value.hpp"
#include "io/base64.hpp"
#include "unit/render/inflate.hpp"

namespace tetloft::test {

/// The values of an array of a page, "0-points" that of the first model.
template <class T>
std::vector<T> array_of(const std::string& page, const std::string& name) {
  const std::string opening = "id=\"array-" + name + "\">";
  const std::size_t begin = page.find(opening);
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + opening.size();
  const std::string text = page.substr(from, page.find('<', from) - from);
  const auto stream = internal::io::decode_base64(text, text.size());
  const auto planes = stream ? inflate(*stream) : std::nullopt;
  EXPECT_TRUE(planes) << name;
  if (!planes) return {};
  const std::size_t n = planes->size() / sizeof(T);
  std::vector<T> values(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      bits |= static_cast<std::uint32_t>(static_cast<unsigned char>((*planes)[k * n + i])) << 8 * k;
    }
    if constexpr (std::is_same_v<T, float>) {
      values[i] = std::bit_cast<float>(bits);
    } else {
      values[i] = static_cast<T>(bits);
    }
  }
  return values;
}

/// What the page says of its models.
inline JsonValue page_header(const std::string& page) {
  const std::string opening = "id=\"model\">";
  const std::size_t begin = page.find(opening);
  EXPECT_NE(begin, std::string::npos);
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + opening.size();
  const auto header = parse_json(page.substr(from, page.find("</script>", from) - from));
  EXPECT_TRUE(header);
  return header.value_or(JsonValue{});
}

}  // namespace tetloft::test
