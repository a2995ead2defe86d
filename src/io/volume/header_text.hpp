// Headers of text in front of data that are none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/cursor.hpp"

namespace tetloft::internal::io {

/// Words between white space.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// The lines of a header, one after the other; memory: a line.
class HeaderLines {
 public:
  /// Both must outlive it.
  HeaderLines(const ByteSource& file, const std::string& name) : file_(file), name_(name) {}

  /// False at the end of the file. Error invalid_input where a line, or all of them, are longer
  /// than headers are.
  [[nodiscard]] Result<bool> next();
  /// Without its end, LF or CRLF.
  [[nodiscard]] std::string_view text() const { return text_; }
  /// One-based.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Of the next line.
  [[nodiscard]] std::uint64_t position() const { return position_; }

 private:
  const ByteSource& file_;
  const std::string& name_;
  std::string buffer_;
  std::size_t used_ = 0;
  std::uint64_t position_ = 0;
  std::string text_;
  std::size_t number_ = 0;
};

}  // namespace tetloft::internal::io
