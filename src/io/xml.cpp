// Scanning tags.
#include "io/xml.hpp"

#include <algorithm>
#include <array>

#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// The five named entities of XML, and white space as xml_text() writes it; others do not occur in
// attributes of VTK files and stay.
std::string decode_entities(std::string_view raw) {
  static constexpr std::array<std::pair<std::string_view, char>, 8> kEntities{{{"&lt;", '<'},
                                                                               {"&gt;", '>'},
                                                                               {"&amp;", '&'},
                                                                               {"&quot;", '"'},
                                                                               {"&apos;", '\''},
                                                                               {"&#9;", '\t'},
                                                                               {"&#10;", '\n'},
                                                                               {"&#13;", '\r'}}};
  std::string text;
  text.reserve(raw.size());
  while (!raw.empty()) {
    const auto entity = std::find_if(kEntities.begin(), kEntities.end(), [&](const auto& e) {
      return raw.substr(0, e.first.size()) == e.first;
    });
    if (entity == kEntities.end()) {
      text += raw.front();
      raw.remove_prefix(1);
    } else {
      text += entity->second;
      raw.remove_prefix(entity->first.size());
    }
  }
  return text;
}

}  // namespace

const std::string* XmlTag::find(std::string_view attribute) const {
  for (const auto& [key, value] : attributes) {
    if (key == attribute) return &value;
  }
  return nullptr;
}

Error XmlScanner::complain_of_close(const XmlTag& tag) const {
  return complain(tag.position, "the tag " + in_quotes("</" + std::string(tag.name) + '>') +
                                    " does not close what is open");
}

Error XmlScanner::complain(std::size_t position, const std::string& message) const {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name_;
  const std::string_view before = text_.substr(0, std::min(position, text_.size()));
  error.where.line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  return error;
}

void XmlScanner::skip_white() {
  while (at_ < text_.size() && is_white(text_[at_])) ++at_;
}

std::string_view XmlScanner::take_name() {
  const std::size_t from = at_;
  const auto ends_name = [](char c) {
    return is_white(c) || c == '=' || c == '>' || c == '/' || c == '<' || c == '"' || c == '\'';
  };
  while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
  return text_.substr(from, at_ - from);
}

std::string_view XmlScanner::take_text() {
  const std::size_t from = at_;
  at_ = std::min(text_.find('<', at_), text_.size());
  return text_.substr(from, at_ - from);
}

std::optional<Error> XmlScanner::read_attributes(XmlTag& tag) {
  for (;;) {
    skip_white();
    if (at_ >= text_.size()) return complain(tag.position, "a tag is not closed");
    if (text_[at_] == '>') {
      ++at_;
      return std::nullopt;
    }
    if (text_[at_] == '/') {
      ++at_;
      if (at_ >= text_.size() || text_[at_] != '>' || tag.kind == XmlTag::Kind::close) {
        return complain(tag.position, "a tag is malformed");
      }
      ++at_;
      tag.kind = XmlTag::Kind::open_close;
      return std::nullopt;
    }
    const std::string_view key = take_name();
    if (tag.find(key) != nullptr) {
      return complain(tag.position, "a tag has the attribute " + in_quotes(key) + " twice");
    }
    if (tag.attributes.size() == kMostAttributes) {
      return complain(tag.position,
                      "a tag has more than " + std::to_string(kMostAttributes) + " attributes");
    }
    skip_white();
    if (key.empty() || at_ >= text_.size() || text_[at_] != '=') {
      return complain(tag.position, "a tag is malformed");
    }
    ++at_;
    skip_white();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    const std::size_t end =
        quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
    if (end == std::string_view::npos) {
      return complain(tag.position, "the attribute " + in_quotes(key) + " has no quoted value");
    }
    tag.attributes.emplace_back(key, decode_entities(text_.substr(at_ + 1, end - at_ - 1)));
    at_ = end + 1;
  }
}

Result<XmlTag> XmlScanner::next_tag() {
  for (;;) {
    static_cast<void>(take_text());
    XmlTag tag;
    tag.position = at_;
    if (at_ >= text_.size()) return tag;
    const std::string_view from = text_.substr(at_);
    // Comments may hold anything, tags too; declarations end at the first '>'.
    const bool comment = from.substr(0, 4) == "<!--";
    if (comment || from.substr(0, 2) == "<?" || from.substr(0, 2) == "<!") {
      const std::string_view closing = comment ? "-->" : ">";
      const std::size_t end = from.find(closing);
      if (end == std::string_view::npos) return complain(at_, "a tag is not closed");
      at_ += end + closing.size();
      continue;
    }
    ++at_;
    tag.kind = XmlTag::Kind::open;
    if (at_ < text_.size() && text_[at_] == '/') {
      ++at_;
      tag.kind = XmlTag::Kind::close;
    }
    tag.name = take_name();
    if (tag.name.empty()) return complain(tag.position, "a tag has no name");
    if (auto error = read_attributes(tag)) return *error;
    return tag;
  }
}

}  // namespace tetloft::internal::io
