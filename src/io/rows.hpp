// Lines of three fields, white space between them; # begins a comment.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/cursor.hpp"

namespace tetloft::internal::io {

using RowFields = std::array<std::string_view, 3>;

[[nodiscard]] inline Error row_error(const std::string& name, std::size_t line,
                                     const std::string& message) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name;
  error.where.line = line;
  return error;
}

/// row(line, fields), for each line that has fields; `form` is what a line should look like.
template <class Row>
Result<void> for_each_row(std::string_view text, const std::string& name, const char* form,
                          Row&& row) {
  TextCursor cursor(text);
  for (cursor.skip_white(); !cursor.at_end(); cursor.skip_white()) {
    const std::size_t line = cursor.line();
    RowFields fields;
    std::size_t count = 0;
    for (; !cursor.at_end() && cursor.peek() != '\n' && cursor.peek() != '#'; ++count) {
      const std::string_view field = cursor.token("#");
      if (count < fields.size()) fields[count] = field;
      cursor.skip_blanks();
    }
    cursor.skip_line();
    if (count == 0) continue;
    if (count != fields.size()) {
      return row_error(name, line,
                       std::string("expected \"") + form + "\", got " + std::to_string(count) +
                           (count == 1 ? " field" : " fields"));
    }
    if (Result<void> taken = row(line, fields); !taken) return taken;
  }
  return {};
}

}  // namespace tetloft::internal::io
