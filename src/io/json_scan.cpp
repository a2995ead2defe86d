// Scanning JSON: the grammar of RFC 8259 as a machine with a stack of brackets.
#include "io/json_scan.hpp"

#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6);
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12);
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | code >> 18);
    byte(0x80 | (code >> 12 & 0x3F));
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

// The length of the number at the beginning of `text` by the grammar of JSON, 0 if there is none.
std::size_t number_length(std::string_view text) {
  std::size_t at = 0;
  const auto here = [&] { return at < text.size() ? text[at] : '\0'; };
  const auto digits = [&] {
    const std::size_t from = at;
    while (is_digit(here())) ++at;
    return at > from;
  };
  if (here() == '-') ++at;
  if (here() == '0') {
    ++at;
  } else if (!digits()) {
    return 0;
  }
  if (here() == '.') {
    ++at;
    if (!digits()) return 0;
  }
  if (here() == 'e' || here() == 'E') {
    ++at;
    if (here() == '+' || here() == '-') ++at;
    if (!digits()) return 0;
  }
  return at;
}

}  // namespace

JsonScanner::JsonScanner(std::string_view text, const std::string& name)
    : text_(text), name_(name) {
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
}

Error JsonScanner::complain(const std::string& message, std::size_t line) const {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name_;
  error.where.line = line;
  return error;
}

void JsonScanner::skip_white() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    const bool separates_records = c == '\x1E' && open_.empty();
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n' && !separates_records) return;
    if (c == '\n') ++line_;
  }
}

Result<JsonEvent> JsonScanner::next() {
  skip_white();
  if (at_ >= text_.size()) {
    if (due_ == Due::text) return JsonEvent{JsonKind::end, {}, 0, true, line_};
    return complain("the file ends inside of " +
                    std::string(open_.back() == '{' ? "an object" : "an array"));
  }
  if (due_ == Due::separator) {
    const char c = peek();
    if (c == '}' || c == ']') return close(c);
    if (c != ',') return complain("a comma or a closing bracket is missing");
    ++at_;
    skip_white();
    due_ = open_.back() == '{' ? Due::key : Due::value;
  }
  if (due_ == Due::first_value && peek() == ']') return close(']');
  if (due_ == Due::first_key && peek() == '}') return close('}');
  if (due_ == Due::first_key || due_ == Due::key) return take_key();
  return take_value();
}

Result<void> JsonScanner::skip(const JsonEvent& event) {
  if (event.kind != JsonKind::open_object && event.kind != JsonKind::open_array) return {};
  for (const std::size_t outside = depth() - 1; depth() > outside;) {
    const Result<JsonEvent> passed = next();
    if (!passed) return passed.error();
  }
  return {};
}

Result<JsonEvent> JsonScanner::close(char bracket) {
  if ((open_.back() == '{') != (bracket == '}')) {
    return complain(std::string("'") + bracket + "' closes what '" + open_.back() + "' opened");
  }
  ++at_;
  open_.pop_back();
  value_done();
  return JsonEvent{
      bracket == '}' ? JsonKind::close_object : JsonKind::close_array, {}, 0, true, line_};
}

Result<JsonEvent> JsonScanner::take_key() {
  const std::size_t line = line_;
  if (peek() != '"') return complain("the name of a member, in double quotes, is missing");
  Result<std::string> text = take_string();
  if (!text) return text.error();
  skip_white();
  if (peek() != ':') return complain("a colon is missing behind " + in_quotes(*text));
  ++at_;
  due_ = Due::value;
  return JsonEvent{JsonKind::key, *std::move(text), 0, true, line};
}

Result<JsonEvent> JsonScanner::take_value() {
  const std::size_t line = line_;
  const char c = peek();
  if (c == '{' || c == '[') {
    ++at_;
    open_ += c;
    due_ = c == '{' ? Due::first_key : Due::first_value;
    return JsonEvent{c == '{' ? JsonKind::open_object : JsonKind::open_array, {}, 0, true, line};
  }
  if (c == '"') {
    Result<std::string> text = take_string();
    if (!text) return text.error();
    value_done();
    return JsonEvent{JsonKind::string, *std::move(text), 0, true, line};
  }
  return c == '-' || is_digit(c) ? take_number() : take_word();
}

Result<JsonEvent> JsonScanner::take_number() {
  const std::size_t length = number_length(text_.substr(at_));
  if (length == 0) return take_word();
  const ParsedNumber number = parse_number(text_.substr(at_, length));
  at_ += length;
  value_done();
  JsonEvent event{JsonKind::number, {}, number.value, number.ok(), line_};
  return event;
}

Result<JsonEvent> JsonScanner::take_word() {
  for (const std::string_view word : {"true", "false", "null"}) {
    if (text_.substr(at_, word.size()) != word) continue;
    at_ += word.size();
    value_done();
    if (word == "null") return JsonEvent{JsonKind::null, {}, 0, true, line_};
    return JsonEvent{JsonKind::boolean, std::string(word), 0, true, line_};
  }
  std::size_t length = 0;
  for (const std::string_view ends = " \t\r\n,:[]{}\""; at_ + length < text_.size(); ++length) {
    if (ends.find(text_[at_ + length]) != std::string_view::npos) break;
  }
  return complain(in_quotes(text_.substr(at_, length > 0 ? length : 1)) + " is no value of JSON");
}

Result<std::string> JsonScanner::take_string() {
  ++at_;
  std::string text;
  for (;;) {
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\\' &&
           static_cast<unsigned char>(text_[at_]) >= 0x20) {
      ++at_;
    }
    text += text_.substr(from, at_ - from);
    if (at_ >= text_.size()) return complain("the file ends inside of a string");
    if (text_[at_] == '"') break;
    if (text_[at_] != '\\') return complain("a string has a control character or a line end");
    if (auto error = take_escape(text)) return *error;
  }
  ++at_;
  return text;
}

std::optional<Error> JsonScanner::take_escape(std::string& text) {
  constexpr std::string_view kEscapes = "\"\\/bfnrt";
  constexpr std::string_view kMeant = "\"\\/\b\f\n\r\t";
  ++at_;
  if (peek() != 'u') {
    const std::size_t which = at_ < text_.size() ? kEscapes.find(peek()) : std::string_view::npos;
    if (which == std::string_view::npos) return complain("a string has an unknown escape");
    text += kMeant[which];
    ++at_;
    return std::nullopt;
  }
  ++at_;
  const auto first = take_hex4();
  if (!first) return complain("\\u in a string needs four hexadecimal digits");
  const bool leads = *first >= 0xD800 && *first < 0xDC00;
  const bool trails = *first >= 0xDC00 && *first < 0xE000;
  std::uint32_t code = *first;
  if (leads && text_.substr(at_, 2) == "\\u") {
    at_ += 2;
    const auto second = take_hex4();
    if (!second || *second < 0xDC00 || *second >= 0xE000) {
      return complain("a string has half of a surrogate pair");
    }
    code = 0x10000 + ((*first - 0xD800) << 10 | (*second - 0xDC00));
  } else if (leads || trails) {
    return complain("a string has half of a surrogate pair");
  }
  append_utf8(text, code);
  return std::nullopt;
}

std::optional<std::uint32_t> JsonScanner::take_hex4() {
  if (text_.size() - at_ < 4) return std::nullopt;
  std::uint32_t code = 0;
  for (int i = 0; i < 4; ++i, ++at_) {
    const char c = text_[at_];
    code <<= 4;
    if (is_digit(c)) {
      code |= static_cast<std::uint32_t>(c - '0');
    } else if (c >= 'a' && c <= 'f') {
      code |= static_cast<std::uint32_t>(c - 'a' + 10);
    } else if (c >= 'A' && c <= 'F') {
      code |= static_cast<std::uint32_t>(c - 'A' + 10);
    } else {
      return std::nullopt;
    }
  }
  return code;
}

}  // namespace tetloft::internal::io
