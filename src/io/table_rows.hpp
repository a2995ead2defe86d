// Rows of text with fields: separated by semicolons, tabs, commas or blanks, whichever the first
// row has, in this order. A # begins a comment; "//" before the first row is passed over. Fields
// may be quoted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

class TableRows {
 public:
  explicit TableRows(std::string_view text);

  /// Goes to the next row that has fields; false at the end.
  bool next();
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
  /// One-based.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Whether an empty line, and no comment, stands before this row.
  [[nodiscard]] bool after_gap() const { return after_gap_; }

  /// A field as a number. Where no comma separates fields, one may stand for the decimal point.
  [[nodiscard]] ParsedNumber number(std::string_view field) const;
  /// Whether the row is one of names: a field is none.
  [[nodiscard]] bool is_header() const;

 private:
  void split(std::string_view line);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  char separator_ = '\0';  // ' ': any number of blanks
  bool after_gap_ = false;
  std::vector<std::string_view> fields_;
};

/// Lower case, without blanks, '_' and '-': how names of columns are compared.
[[nodiscard]] std::string plain_name(std::string_view name);

/// The column of one of these names, or the size of `fields`. Names that stand earlier go first.
[[nodiscard]] std::size_t column_named(const std::vector<std::string_view>& fields,
                                       const std::vector<std::string_view>& names);

}  // namespace tetloft::internal::io
