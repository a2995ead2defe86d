#include "io/solid_comments.hpp"

#include <array>

#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

struct CommentedMember {
  std::string_view key;
  std::string Description::*value;
};
constexpr std::array kCommentedMembers{CommentedMember{"name", &Description::name},
                                       CommentedMember{"unit", &Description::unit},
                                       CommentedMember{"orientation", &Description::orientation}};
constexpr std::string_view kComponentKey = "component ";

}  // namespace

void append_comments(std::string& text, std::string_view mark, const Model& model,
                     const std::vector<ComponentGroup>& groups) {
  const auto line = [&](std::string_view key, const std::string& value) {
    text.append(mark).append(" ").append(key).append(": ").append(printable(value)).append("\n");
  };
  for (const CommentedMember& member : kCommentedMembers) {
    const std::string& value = model.about.*member.value;
    if (!value.empty()) line(member.key, value);
  }
  for (const ComponentGroup& group : groups) {
    if (!group.component.valid()) continue;
    line(std::string(kComponentKey) + std::to_string(group.tag()), group.name);
  }
}

void SolidComments::take(std::string_view comment) {
  const std::size_t colon = comment.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view key = trimmed(comment.substr(0, colon));
  const std::string value = valid_utf8(trimmed(comment.substr(colon + 1)));
  for (const CommentedMember& member : kCommentedMembers) {
    if (key == member.key) about_.*member.value = value;
  }
  if (key.substr(0, kComponentKey.size()) != kComponentKey) return;
  if (const auto number = parse_integer(key.substr(kComponentKey.size()))) names_[*number] = value;
}

}  // namespace tetloft::internal::io
