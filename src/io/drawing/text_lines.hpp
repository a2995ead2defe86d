// Text line by line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "io/cursor.hpp"

namespace tetloft::internal::io {

/// Cuts the first line off `text` and returns it, without its end.
inline std::string_view cut_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// `text` without a UTF-8 byte order mark at its start.
inline std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// Each line a row of words; # begins a comment.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : cursor_(text) {}

  /// Goes to the next line that has words; false at the end.
  bool next() {
    words_.clear();
    while (!cursor_.at_end()) {
      cursor_.skip_white();
      line_ = cursor_.line();
      while (!cursor_.at_end() && cursor_.peek() != '\n' && cursor_.peek() != '#') {
        words_.push_back(cursor_.token(kWhiteOrComment));
        cursor_.skip_blanks();
      }
      cursor_.skip_line();
      if (!words_.empty()) return true;
    }
    return false;
  }
  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  /// Its number, one-based; at the end the last one's.
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  TextCursor cursor_;
  std::vector<std::string_view> words_;
  std::size_t line_ = 1;
};

}  // namespace tetloft::internal::io
