#include "io/table_rows.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "io/cursor.hpp"

namespace tetloft::internal::io {

namespace {

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

// Without quotes.
std::string_view content(std::string_view field) {
  field = trimmed(field);
  if (field.size() > 1 && field.front() == '"' && field.back() == '"') {
    field = field.substr(1, field.size() - 2);
  }
  return field;
}

}  // namespace

TableRows::TableRows(std::string_view text) : text_(text) {
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
}

bool TableRows::next() {
  after_gap_ = false;
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++line_;
    const std::size_t comment = line.find('#');
    const std::string_view rest = trimmed(line.substr(0, comment));
    if (rest.empty()) {
      after_gap_ = after_gap_ || comment == std::string_view::npos;
      continue;
    }
    line = rest;
    if (separator_ == '\0') {
      if (line.substr(0, 2) == "//") line = trimmed(line.substr(2));
      separator_ = separator_of(line);
    }
    split(line);
    if (!fields_.empty()) return true;
  }
  return false;
}

void TableRows::split(std::string_view line) {
  fields_.clear();
  std::size_t from = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    const bool ends = i == line.size() ||
                      (!quoted && (separator_ == ' ' ? is_white(line[i]) : line[i] == separator_));
    if (!ends) continue;
    const std::string_view field = content(line.substr(from, i - from));
    from = i + 1;
    if (separator_ == ' ' && field.empty()) continue;
    fields_.push_back(field);
  }
  // A separator may end the row.
  if (separator_ != ' ' && fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
}

ParsedNumber TableRows::number(std::string_view field) const {
  const ParsedNumber parsed = parse_number(field);
  const std::size_t comma = field.find(',');
  if (parsed.status != NumberStatus::malformed || comma == std::string_view::npos) return parsed;
  std::string pointed(field);
  pointed[comma] = '.';
  return pointed.find_first_of(",.", comma + 1) == std::string::npos ? parse_number(pointed)
                                                                     : parsed;
}

bool TableRows::is_header() const {
  return std::any_of(fields_.begin(), fields_.end(), [&](std::string_view field) {
    return number(field).status == NumberStatus::malformed && !field.empty();
  });
}

std::string plain_name(std::string_view name) {
  std::string text;
  for (const char c : name.substr(0, name.find_first_of("([{"))) {
    if (c == ' ' || c == '_' || c == '-' || c == ':') continue;
    text += lower_case(c);
  }
  return text;
}

std::size_t column_named(const std::vector<std::string_view>& fields,
                         const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (plain_name(fields[i]) == name) return i;
    }
  }
  return fields.size();
}

}  // namespace tetloft::internal::io
