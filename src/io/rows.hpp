// Lines of a few fields, white space between them; # begins a comment.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/cursor.hpp"

namespace tetloft::internal::io {

struct RowFields {
  std::array<std::string_view, 4> field;  ///< the first of them
  std::size_t count = 0;                  ///< of all
};

[[nodiscard]] inline Error row_error(const std::string& name, std::size_t line,
                                     const std::string& message) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name;
  error.where.line = line;
  return error;
}

/// That a line has another number of fields than its form.
[[nodiscard]] inline Error row_form_error(const std::string& name, std::size_t line,
                                          std::string_view form, std::size_t fields) {
  return row_error(name, line,
                   "expected \"" + std::string(form) + "\", got " + std::to_string(fields) +
                       (fields == 1 ? " field" : " fields"));
}

/// row(line, fields), for each line that has fields.
template <class Row>
Result<void> for_each_row(std::string_view text, Row&& row) {
  TextCursor cursor(text);
  for (cursor.skip_white(); !cursor.at_end(); cursor.skip_white()) {
    const std::size_t line = cursor.line();
    RowFields fields;
    for (; !cursor.at_end() && cursor.peek() != '\n' && cursor.peek() != '#'; ++fields.count) {
      const std::string_view field = cursor.token(kWhiteOrComment);
      if (fields.count < fields.field.size()) fields.field[fields.count] = field;
      cursor.skip_blanks();
    }
    cursor.skip_line();
    if (fields.count == 0) continue;
    if (Result<void> taken = row(line, fields); !taken) return taken;
  }
  return {};
}

}  // namespace tetloft::internal::io
