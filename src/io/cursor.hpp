// A cursor over text: tokens between white space, and the line it is in.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace tetloft::internal::io {

/// Space, tab, vertical tab, form feed, carriage return, line feed.
[[nodiscard]] constexpr bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Of ASCII.
[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Without white space at its ends.
[[nodiscard]] constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
  return text;
}

/// What ends a token: white space, and some other bytes. One look at a table for each byte.
class TokenEnds {
 public:
  constexpr explicit TokenEnds(std::string_view others) {
    for (std::size_t c = 0; c < ends_.size(); ++c) {
      const char byte = static_cast<char>(static_cast<unsigned char>(c));
      ends_[c] = is_white(byte) || others.find(byte) != std::string_view::npos;
    }
  }
  [[nodiscard]] constexpr bool has(char c) const { return ends_[static_cast<unsigned char>(c)]; }

 private:
  std::array<bool, 256> ends_{};
};

/// White space, and the beginning of a comment.
inline constexpr TokenEnds kWhiteOrComment("#");

class TextCursor {
 public:
  /// Skips a UTF-8 byte order mark at the start. `line`: where the text begins in its file.
  explicit TextCursor(std::string_view text, std::size_t line = 1)
      : at_(text.data()), end_(text.data() + text.size()), line_(line) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") at_ += 3;
  }

  void skip_white() {
    for (; at_ != end_ && is_white(*at_); ++at_) {
      if (*at_ == '\n') ++line_;
    }
  }
  /// Skips white space within the line.
  void skip_blanks() {
    while (at_ != end_ && is_white(*at_) && *at_ != '\n') ++at_;
  }
  /// Goes to the end of the line, before its line feed.
  void skip_line() {
    while (at_ != end_ && *at_ != '\n') ++at_;
  }

  [[nodiscard]] bool at_end() const { return at_ == end_; }
  /// The next byte, or 0 at the end.
  [[nodiscard]] char peek() const { return at_ == end_ ? '\0' : *at_; }
  void advance() { ++at_; }
  /// All that is left.
  [[nodiscard]] std::string_view rest() const {
    return {at_, static_cast<std::size_t>(end_ - at_)};
  }
  /// One-based.
  [[nodiscard]] std::size_t line() const { return line_; }

  /// The bytes up to the next white space, passed over.
  std::string_view token() {
    constexpr TokenEnds white("");
    return token(white);
  }
  /// The bytes up to the next of these ends, passed over.
  std::string_view token(const TokenEnds& ends) {
    const char* const from = at_;
    while (at_ != end_ && !ends.has(*at_)) ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

 private:
  const char* at_;
  const char* end_;
  std::size_t line_;
};

}  // namespace tetloft::internal::io
