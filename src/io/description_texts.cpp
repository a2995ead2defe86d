#include "io/description_texts.hpp"

#include "core/text.hpp"

namespace tetloft::internal::io {

std::vector<std::string> description_lines(const Description& about) {
  std::vector<std::string> lines;
  for (const auto& [name, text] : kDescriptionTexts) {
    const std::string& value = about.*text;
    if (!value.empty()) lines.push_back(std::string(name) + ": " + printable(value));
  }
  return lines;
}

}  // namespace tetloft::internal::io
