// A cursor over files that hold words of text, and numbers as text or as bytes.
//
// What is wrong is thrown as Failed, naming the file, and the line where all of the file has lines:
// readers of such files have nothing else to do with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/scalar_type.hpp"

namespace tetloft::internal::io {

enum class DataForm : std::uint8_t { text, little_endian, big_endian };

class DataCursor {
 public:
  /// Of the file `name`.
  DataCursor(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  /// How numbers are written from here on; text, if nothing is said.
  void set_form(DataForm form) {
    form_ = form;
    has_bytes_ = has_bytes_ || form != DataForm::text;
  }
  [[nodiscard]] DataForm form() const { return form_; }

  /// The next word, between white space; empty at the end of the file.
  [[nodiscard]] std::string_view word();
  /// The rest of the line, without its end, which is passed over, and a carriage return there.
  std::string_view line();
  /// How many bytes are left.
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }

  /// The next value; fails where there is none, or none that is finite. Text of type float32 means
  /// the float nearest to it.
  [[nodiscard]] double number(ScalarType type);
  /// The same of integers; of uint64 those above the largest int64 come out negative.
  [[nodiscard]] std::int64_t integer(ScalarType type);
  /// The next integer, written as text whatever the form.
  [[nodiscard]] std::int64_t text_integer();
  /// The same, which is a count; `what` of, for messages.
  [[nodiscard]] std::size_t text_count(std::string_view what);

  /// Fails unless there can be so many values: what a file announces is asked before anything is
  /// allocated for it.
  void require(std::uint64_t count, ScalarType type) const;
  /// Passes over values.
  void skip(std::uint64_t count, ScalarType type);
  void skip_bytes(std::size_t count);
  [[nodiscard]] std::string_view bytes(std::size_t count);

  [[noreturn]] void fail(std::string message) const;

 private:
  template <class T>
  [[nodiscard]] T stored();

  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0;
  DataForm form_ = DataForm::text;
  bool has_bytes_ = false;
};

}  // namespace tetloft::internal::io
