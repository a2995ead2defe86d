// A pull scanner for the XML that VTK files are made of: tags, attributes, text. Neither
// namespaces nor document types, and no tree: a file is read once, from front to back.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

struct XmlTag {
  enum class Kind { open, close, open_close, end_of_file };
  Kind kind = Kind::end_of_file;
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string>> attributes;
  std::size_t position = 0;  ///< of its '<' in the file

  /// The value of an attribute, or null.
  [[nodiscard]] const std::string* find(std::string_view attribute) const;
};

class XmlScanner {
 public:
  static constexpr std::size_t kMostAttributes = 64;

  /// `name` stands for the file in errors; both must outlive the scanner.
  XmlScanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next tag (invalid_input where one has an attribute twice, or more than kMostAttributes);
  /// comments, declarations and text before it are passed over.
  [[nodiscard]] Result<XmlTag> next_tag();
  /// The text up to the next '<' or the end.
  [[nodiscard]] std::string_view take_text();
  /// Everything behind the last tag, unread.
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  /// Goes on `bytes` further.
  void pass_over(std::size_t bytes) { at_ += bytes; }
  [[nodiscard]] std::size_t position() const { return at_; }
  /// Of the whole text.
  [[nodiscard]] std::size_t size() const { return text_.size(); }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// That a closing tag is not that of the element which is open.
  [[nodiscard]] Error complain_of_close(const XmlTag& tag) const;
  /// invalid_input, naming the file and the line of byte `position`.
  [[nodiscard]] Error complain(std::size_t position, const std::string& message) const;

 private:
  [[nodiscard]] std::optional<Error> read_attributes(XmlTag& tag);
  void skip_white();
  std::string_view take_name();

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace tetloft::internal::io
