// Text from outside (file names, titles, words of a file) on its way to a terminal or into a
// document: UTF-8 read strictly, and what must not be passed on as it is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetloft::internal {

/// One character of UTF-8, or one byte that is none.
struct TextUnit {
  std::size_t length = 0;  ///< bytes; 1 where !valid
  char32_t code = 0;       ///< the code point, or the byte
  bool valid = false;
};

/// The first unit of `text`, by Unicode's table 3-7: no overlong forms, no surrogates, nothing
/// above U+10FFFF. Requires text not empty.
[[nodiscard]] TextUnit first_unit(std::string_view text);

/// Whether all of `text` is such characters.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Whether a terminal, or a reader's eye, can be led astray by this code point: control characters
/// (C0, DEL, C1), line and paragraph separators, marks that change the direction of writing.
[[nodiscard]] bool misleads(char32_t code);

/// `text` in one line that can be shown anywhere: what misleads as "\u{202e}", below U+0100 and
/// for bytes that are no UTF-8 as "\x1b". The rest, backslashes included, stays as it is:
/// printable(printable(t)) == printable(t).
[[nodiscard]] std::string printable(std::string_view text);

/// The first characters of `text`, as many as `most` bytes hold.
[[nodiscard]] std::string_view beginning(std::string_view text, std::size_t most);

/// Letters of ASCII in lower case; what is beyond it stays.
[[nodiscard]] constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] std::string lower_case(std::string_view text);

/// `text` as a document may hold it, XML and HTML included: each byte that is no UTF-8, and each
/// control character but tab and line ends, becomes U+FFFD, as do U+FFFE and U+FFFF.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace tetloft::internal
