// Parsing JSON by recursive descent, at most 50 levels deep.
#include "cli/json_value.hpp"

#include <cctype>
#include <cstdlib>

namespace tetloft::test {

namespace {

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::optional<JsonValue> parse() {
    JsonValue value;
    if (!take_value(value, 0)) return std::nullopt;
    skip_white();
    if (at_ != text_.size()) return std::nullopt;
    return value;
  }

 private:
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  void skip_white() {
    while (peek() == ' ' || peek() == '\n' || peek() == '\r' || peek() == '\t') ++at_;
  }

  bool take_value(JsonValue& value, int depth) {
    if (depth > 50) return false;
    skip_white();
    switch (peek()) {
      case '{': return take_object(value, depth);
      case '[': return take_array(value, depth);
      case '"': value.kind = JsonValue::Kind::string; return take_string(value.string);
      case 't':
        value.boolean = true;
        value.kind = JsonValue::Kind::boolean;
        return take("true");
      case 'f': value.kind = JsonValue::Kind::boolean; return take("false");
      case 'n': return take("null");
      default: return take_number(value);
    }
  }

  bool take_object(JsonValue& value, int depth) {
    value.kind = JsonValue::Kind::object;
    ++at_;
    skip_white();
    if (take('}')) return true;
    do {
      skip_white();
      std::string key;
      if (!take_string(key)) return false;
      skip_white();
      if (!take(':')) return false;
      JsonValue member;
      if (!take_value(member, depth + 1)) return false;
      if (!value.object.emplace(key, member).second) return false;
      skip_white();
    } while (take(','));
    return take('}');
  }

  bool take_array(JsonValue& value, int depth) {
    value.kind = JsonValue::Kind::array;
    ++at_;
    skip_white();
    if (take(']')) return true;
    do {
      JsonValue element;
      if (!take_value(element, depth + 1)) return false;
      value.array.push_back(element);
      skip_white();
    } while (take(','));
    return take(']');
  }

  bool take_string(std::string& out) {
    if (!take('"')) return false;
    for (;;) {
      if (at_ == text_.size()) return false;
      const char c = text_[at_++];
      if (c == '"') return true;
      if (static_cast<unsigned char>(c) < 0x20) return false;
      if (c != '\\') {
        out += c;
        continue;
      }
      const char escaped = peek();
      ++at_;
      if (escaped == 'u') {
        std::string digits;
        for (int i = 0; i < 4; ++i, ++at_) {
          if (std::isxdigit(static_cast<unsigned char>(peek())) == 0) return false;
          digits += peek();
        }
        const unsigned long code = std::stoul(digits, nullptr, 16);
        out += code < 0x80 ? static_cast<char>(code) : '?';
      } else if (std::string_view("\"\\/bfnrt").find(escaped) != std::string_view::npos) {
        out += escaped;
      } else {
        return false;
      }
    }
  }

  bool take_digits() {
    const std::size_t from = at_;
    while (std::isdigit(static_cast<unsigned char>(peek())) != 0) ++at_;
    return at_ > from;
  }

  bool take_number(JsonValue& value) {
    value.kind = JsonValue::Kind::number;
    const std::size_t from = at_;
    take('-');
    if (!take('0') && !take_digits()) return false;
    if (take('.') && !take_digits()) return false;
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (!take('+')) take('-');
      if (!take_digits()) return false;
    }
    value.number = std::strtod(std::string(text_.substr(from, at_ - from)).c_str(), nullptr);
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonValue& JsonValue::at(const std::string& key) const {
  static const JsonValue kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : found->second;
}

std::optional<JsonValue> parse_json(std::string_view text) { return Parser(text).parse(); }

}  // namespace tetloft::test
