// Words and numbers as they stand in a page. The page is well-formed XML, too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tetloft::internal::report {

/// Text, as content or as the value of an attribute: whatever it is, it is nothing but text.
/// Marks that change the direction of writing are shown as U+FFFD, too.
[[nodiscard]] std::string escaped(std::string_view text);

/// "1 234 567", with narrow spaces that do not break.
[[nodiscard]] std::string count_text(std::size_t count);
/// "1 tet", "2 tets".
[[nodiscard]] std::string counted_text(std::size_t count, std::string_view singular);
/// The number, or a dash for none.
template <class Number>
[[nodiscard]] std::string known_text(const std::optional<Number>& number) {
  return number ? std::to_string(*number) : "–";
}
/// "12.3 mm²": power 1 to 3; the unit may be empty, and is any text.
[[nodiscard]] std::string with_unit(double value, std::string_view unit, int power);
/// "mm²", escaped; empty for none.
[[nodiscard]] std::string unit_text(std::string_view unit, int power);

/// Appends a number with so many decimals at most: coordinates of drawings.
void append_coordinate(std::string& out, double value, int decimals = 1);

/// `content` with the tag around it; `attributes` as they stand in the tag.
[[nodiscard]] std::string element(std::string_view tag, std::string_view content,
                                  std::string_view attributes = {});

}  // namespace tetloft::internal::report
