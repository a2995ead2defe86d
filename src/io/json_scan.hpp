// A strict pull scanner for JSON (RFC 8259): events from front to back, no tree and no recursion,
// so that nesting costs a byte a level. Several texts may stand in a row, newlines or the record
// separators of RFC 8142 between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

enum class JsonKind : std::uint8_t {
  open_object,
  close_object,
  open_array,
  close_array,
  key,
  string,
  number,
  boolean,
  null,
  end,  ///< of the file, outside of any text
};

struct JsonEvent {
  JsonKind kind = JsonKind::end;
  std::string text;      ///< of keys and strings, as UTF-8; "true" or "false" of booleans
  double number = 0;     ///< nearest to the digits
  bool finite = true;    ///< false of numbers beyond the largest double
  std::size_t line = 0;  ///< where it begins, one-based
};

class JsonScanner {
 public:
  /// `name` stands for the file in errors; both must outlive the scanner. A byte order mark is
  /// passed over.
  JsonScanner(std::string_view text, const std::string& name);

  /// Error invalid_input with the line where the text is no JSON: a value malformed or missing, a
  /// comma too many, a bracket of the other kind, an end within a value.
  [[nodiscard]] Result<JsonEvent> next();
  /// Passes over the rest of the value that `event`, the last one, begins: nothing for what is no
  /// object or array.
  [[nodiscard]] Result<void> skip(const JsonEvent& event);

  /// How many objects and arrays are open.
  [[nodiscard]] std::size_t depth() const { return open_.size(); }
  [[nodiscard]] std::size_t line() const { return line_; }
  /// invalid_input, naming the file and the line.
  [[nodiscard]] Error complain(const std::string& message, std::size_t line) const;

 private:
  enum class Due : std::uint8_t {
    value,        // behind ':' or ','
    first_value,  // behind '[': a value, or ']'
    first_key,    // behind '{': a key, or '}'
    key,          // behind ',' in an object
    separator,    // behind a value: ',' or the closing bracket
    text,         // outside of all: a value, or the end
  };

  [[nodiscard]] Error complain(const std::string& message) const {
    return complain(message, line_);
  }
  void skip_white();
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] Result<JsonEvent> take_value();
  [[nodiscard]] Result<JsonEvent> take_key();
  [[nodiscard]] Result<JsonEvent> close(char bracket);
  [[nodiscard]] Result<JsonEvent> take_number();
  [[nodiscard]] Result<JsonEvent> take_word();
  [[nodiscard]] Result<std::string> take_string();
  [[nodiscard]] std::optional<Error> take_escape(std::string& text);
  [[nodiscard]] std::optional<std::uint32_t> take_hex4();
  void value_done() { due_ = open_.empty() ? Due::text : Due::separator; }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::string open_;  // '{' and '[' not closed yet, outermost first
  Due due_ = Due::text;
};

}  // namespace tetloft::internal::io
