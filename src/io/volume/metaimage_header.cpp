// Lines of a MetaImage header.
#include "io/volume/metaimage_header.hpp"

#include <optional>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

const MetaHeader::Field* MetaHeader::find(std::initializer_list<const char*> keys) const {
  for (const char* key : keys) {
    if (const auto at = fields.find(key); at != fields.end()) return &at->second;
  }
  return nullptr;
}

bool MetaHeader::is_true(std::initializer_list<const char*> keys, bool otherwise) const {
  const Field* const field = find(keys);
  if (field == nullptr || field->value.empty()) return otherwise;
  const char c = field->value.front();
  return c == 'T' || c == 't' || c == '1' || c == 'Y' || c == 'y';
}

Error MetaHeader::complain(const Field* field, const std::string& message) const {
  return volume_error(name, message,
                      field == nullptr ? std::nullopt : std::optional<std::size_t>(field->line));
}

Result<std::vector<double>> MetaHeader::numbers(std::initializer_list<const char*> keys,
                                                std::size_t count) const {
  std::vector<double> numbers;
  const Field* const field = find(keys);
  if (field == nullptr) return numbers;
  for (const std::string& word : words_of(field->value)) {
    const ParsedNumber number = parse_number(word);
    if (!number.ok()) return complain(field, complaint(word, number.status));
    numbers.push_back(number.value);
  }
  if (numbers.size() >= count) return numbers;
  return complain(field, std::string(*keys.begin()) + " has " + std::to_string(numbers.size()) +
                             " numbers, and should have " + std::to_string(count));
}

Result<MetaHeader> read_meta_header(const ByteSource& file, const std::string& name) {
  MetaHeader header;
  header.name = name;
  HeaderLines lines(file, name);
  bool in_list = false;
  for (;;) {
    const Result<bool> next = lines.next();
    if (!next) return next.error();
    if (!*next) break;
    const std::string_view line = trimmed(lines.text());
    if (line.empty() || line.front() == '#') continue;
    if (in_list) {
      header.listed.emplace_back(line);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      return volume_error(name, in_quotes(line) + " is no line \"key = value\"", lines.number());
    }
    const std::string key = lower_case(trimmed(line.substr(0, equals)));
    const std::string_view value = trimmed(line.substr(equals + 1));
    header.fields[key] = {std::string(value), lines.number()};
    if (key != "elementdatafile") continue;
    header.data = lines.position();
    in_list = value == "LIST" || value.substr(0, 5) == "LIST ";
    if (!in_list) return header;
  }
  if (in_list) return header;
  return volume_error(name, "the header has no ElementDataFile");
}

}  // namespace tetloft::internal::io
