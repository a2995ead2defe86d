// The grammar of NUAGES .cnt (Geiger, INRIA RR-2105, 1993):
//   S n            sections
//   v n z z        for each section: vertices, height
//   { x y x y … }  for each contour
// Commas or semicolons may stand between numbers, # begins a comment.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/cnt_contents.hpp"
#include "io/cursor.hpp"

namespace tetloft::internal::io {

/// Takes what it reads one after the other, of a whole file or of a part. Errors (invalid_input)
/// name file and line.
class CntParser {
 public:
  /// `text` begins in this line of the file `name`; both must outlive it.
  CntParser(std::string_view text, const std::string& name, std::size_t line = 1)
      : cursor_(text, line), name_(name) {}

  struct Header {
    std::size_t line = 0;
    double sections = 0;  ///< that it announces
  };
  [[nodiscard]] Result<Header> header();
  /// Whether anything follows but white space and comments, which are passed over.
  [[nodiscard]] bool more();
  /// Appends the next section to `contents`; of a faulty one, what was read of it.
  [[nodiscard]] Result<void> section(CntContents& contents);
  /// How many bytes follow.
  [[nodiscard]] std::size_t left() const { return cursor_.rest().size(); }

 private:
  Result<void> contour(CntContents& contents, SectionId section);
  void skip_space();
  void skip_separator(CntContents& contents);
  bool take_letter(char upper);
  Result<double> coordinate(const char* what);
  Result<double> count(const char* what);
  [[nodiscard]] Error complain(const std::string& message) const;

  TextCursor cursor_;
  const std::string& name_;
};

/// As messages show a count.
[[nodiscard]] std::string count_text(double value);

}  // namespace tetloft::internal::io
