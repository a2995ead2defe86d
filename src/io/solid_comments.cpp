#include "io/solid_comments.hpp"

#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/description_texts.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kComponentKey = "component ";

}  // namespace

void append_comments(std::string& text, std::string_view mark, const Model& model,
                     const std::vector<ComponentGroup>& groups) {
  const auto append = [&](const std::string& line) {
    text.append(mark).append(" ").append(line).append("\n");
  };
  for (const std::string& line : description_lines(model.about)) append(line);
  for (const ComponentGroup& group : groups) {
    if (!group.component.valid()) continue;
    append(std::string(kComponentKey) + std::to_string(group.tag()) + ": " + printable(group.name));
  }
}

void SolidComments::take(std::string_view comment) {
  const std::size_t colon = comment.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view key = trimmed(comment.substr(0, colon));
  const std::string value = valid_utf8(trimmed(comment.substr(colon + 1)));
  for (const auto& [name, text] : kDescriptionTexts) {
    if (key == name) about_.*text = value;
  }
  if (key.substr(0, kComponentKey.size()) != kComponentKey) return;
  if (const auto number = parse_integer(key.substr(kComponentKey.size()))) names_[*number] = value;
}

}  // namespace tetloft::internal::io
