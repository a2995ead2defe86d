// The texts of a Description by the names that files have for them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/description.hpp>

namespace tetloft::internal::io {

struct DescriptionText {
  std::string_view name;
  std::string Description::*text;
};
inline constexpr std::array kDescriptionTexts{
    DescriptionText{"name", &Description::name}, DescriptionText{"unit", &Description::unit},
    DescriptionText{"orientation", &Description::orientation}};

/// "name: liver", "unit: mm", "orientation: LPS", as far as they are known, each in one line.
[[nodiscard]] std::vector<std::string> description_lines(const Description& about);

}  // namespace tetloft::internal::io
