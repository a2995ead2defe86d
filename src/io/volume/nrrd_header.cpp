// Lines of a NRRD header.
#include "io/volume/nrrd_header.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

std::string identifier_of(std::string_view field) {
  std::string identifier;
  for (const char c : field) {
    if (!is_white(c)) identifier += lower_case(c);
  }
  // Both names are in use.
  return identifier == "centerings" ? "centers" : identifier;
}

// "\n" and "\\" stand for a line feed and a backslash.
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 1 < text.size();
    if (escape && text[i + 1] == 'n') plain += '\n';
    if (escape && text[i + 1] == '\\') plain += '\\';
    if (escape && (text[i + 1] == 'n' || text[i + 1] == '\\')) {
      ++i;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

}  // namespace

const NrrdField* NrrdHeader::find(const std::string& identifier) const {
  const auto at = fields.find(identifier);
  return at == fields.end() ? nullptr : &at->second;
}

bool NrrdHeader::has_list() const {
  const NrrdField* const file = find("datafile");
  return file != nullptr && (file->value == "LIST" || file->value.substr(0, 5) == "LIST ");
}

std::vector<std::string> NrrdHeader::words(const std::string& identifier) const {
  std::vector<std::string> words;
  const NrrdField* const field = find(identifier);
  if (field == nullptr) return words;
  const std::string& text = field->value;
  for (std::size_t i = 0; i < text.size();) {
    if (is_white(text[i])) {
      ++i;
      continue;
    }
    const std::size_t from = i;
    const char close = text[i] == '(' ? ')' : text[i] == '"' ? '"' : '\0';
    if (close != '\0') {
      i = std::min(text.find(close, i + 1), text.size() - 1) + 1;
    } else {
      while (i < text.size() && !is_white(text[i])) ++i;
    }
    words.push_back(text.substr(from, i - from));
  }
  return words;
}

Error NrrdHeader::complain(const std::string& identifier, const std::string& message) const {
  const NrrdField* const field = find(identifier);
  return volume_error(name, message,
                      field == nullptr ? std::nullopt : std::optional<std::size_t>(field->line));
}

Result<NrrdHeader> read_nrrd_header(const ByteSource& file, const std::string& name) {
  NrrdHeader header;
  header.name = name;
  HeaderLines lines(file, name);
  for (;;) {
    const Result<bool> next = lines.next();
    if (!next) return next.error();
    if (!*next) return header;
    const std::string_view text = lines.text();
    if (lines.number() == 1) {
      const bool known =
          text.size() == kNrrdMagic.size() + 1 && text.substr(0, kNrrdMagic.size()) == kNrrdMagic;
      if (known && text.back() >= '1' && text.back() <= '5') continue;
      return volume_error(name,
                          in_quotes(text) + " is no version of NRRD, of which 1 to 5 are read", 1);
    }
    if (header.has_list()) {
      if (!text.empty()) header.listed.emplace_back(text);
      continue;
    }
    if (text.empty()) {
      header.data = lines.position();
      return header;
    }
    if (text.front() == '#') continue;
    const std::size_t pair = text.find(":=");
    const std::size_t field = text.find(": ");
    if (pair != std::string_view::npos && pair < field) {
      header.keys[std::string(text.substr(0, pair))] = without_escapes(text.substr(pair + 2));
      continue;
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
      return volume_error(name, in_quotes(text) + " is neither a field nor a key with a value",
                          lines.number());
    }
    const std::string identifier = identifier_of(text.substr(0, colon));
    const bool first =
        header.fields
            .try_emplace(identifier,
                         NrrdField{std::string(trimmed(text.substr(colon + 1))), lines.number()})
            .second;
    if (!first) {
      return volume_error(name, "there are two fields " + in_quotes(text.substr(0, colon)),
                          lines.number());
    }
  }
}

}  // namespace tetloft::internal::io
