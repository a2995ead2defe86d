// Numbers, and ranges of numbers, as people write them into attributes.
#pragma once

#include <optional>
#include <string_view>

namespace tetloft::internal::io {

struct TextRange {
  double low = 0;
  double high = 0;  ///< low where it is one number
  bool is_range = false;
};

/// "350", " 350.5 ", "0-5", "-5--3", "0 – 5", "0..5", "0 to 5": finite, low ≤ high; else nothing.
[[nodiscard]] std::optional<TextRange> parse_range(std::string_view text);

}  // namespace tetloft::internal::io
