// A strict reader of well-formed markup, to see whether a page is such, and what stands in it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetloft::test {

struct Element {
  std::string tag;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< directly in it, entities resolved
  std::vector<Element> children;

  /// This and all that is in it, of that tag ("*": of any) and class ("": of any).
  [[nodiscard]] std::vector<const Element*> all(std::string_view wanted,
                                                std::string_view css = "") const;
  [[nodiscard]] double number(const std::string& attribute) const;
  /// All text in it.
  [[nodiscard]] std::string words() const;
};

/// The one element that `text` holds, behind a document type; `why` says where it is not
/// well-formed. No comments, no CDATA, the five entities of XML and decimal ones below 128.
[[nodiscard]] std::optional<Element> parse_markup(std::string_view text, std::string& why);

}  // namespace tetloft::test
