// Which format a file is of, or is to be.
#include "io/formats.hpp"

#include <algorithm>
#include <filesystem>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

bool handles(const Format& format, Contents contents, Direction direction) {
  return direction == Direction::reading ? reads(format, contents) : writes(format, contents);
}

}  // namespace

bool reads(const Format& format, Contents contents) {
  switch (contents) {
    case Contents::stack:
      return format.read_stack != nullptr || format.read_drawing != nullptr ||
             format.open_volume != nullptr;
    case Contents::model: return format.read_model != nullptr;
    case Contents::points: return format.read_points != nullptr;
    case Contents::labels: return format.read_labels != nullptr;
    case Contents::surface: return format.read_triangles != nullptr;
    case Contents::lines: break;
  }
  return false;
}

bool writes(const Format& format, Contents contents) {
  switch (contents) {
    case Contents::stack: return format.write_stack != nullptr;
    case Contents::model: return format.write_model != nullptr;
    case Contents::surface: return format.write_surface != nullptr;
    case Contents::points: return format.write_points != nullptr;
    case Contents::labels: return format.write_labels != nullptr;
    case Contents::lines: return format.write_lines != nullptr;
  }
  return false;
}

std::string_view extension_in(const Format& format, const std::string& path) {
  const std::string name = lower_case(std::filesystem::path(path).filename().string());
  std::string_view longest;
  for (const std::string_view extension : format.extensions) {
    // A name that is nothing but an extension is a hidden file.
    const bool ends = name.size() > extension.size() &&
                      std::string_view(name).substr(name.size() - extension.size()) == extension;
    if (ends && extension.size() > longest.size()) longest = extension;
  }
  return longest;
}

std::vector<std::string> companion_paths(const Format& format, const std::string& path) {
  const std::string_view extension = extension_in(format, path);
  std::vector<std::string> paths;
  for (const Companion& companion : format.companions) {
    if (companion.write == nullptr || extension.empty()) break;
    paths.push_back(path.substr(0, path.size() - extension.size()) +
                    std::string(companion.extension));
  }
  return paths;
}

std::vector<std::string_view> extensions_of(FormatTable table, Contents contents,
                                            Direction direction) {
  std::vector<std::string_view> all;
  for (const Format* format : table) {
    if (!handles(*format, contents, direction)) continue;
    for (const std::string_view extension : format->extensions) {
      const bool listed = std::find(all.begin(), all.end(), extension) != all.end();
      if (!extension.empty() && !listed) all.push_back(extension);
    }
  }
  return all;
}

std::vector<std::string_view> names_of(FormatTable table, Contents contents, Direction direction) {
  std::vector<std::string_view> names;
  for (const Format* format : table) {
    if (handles(*format, contents, direction)) names.push_back(format->name);
  }
  return names;
}

std::string described_readers(FormatTable table, Contents contents) {
  std::vector<std::string> texts;
  for (const Format* format : table) {
    if (!reads(*format, contents)) continue;
    std::string text = std::string(format->name) + " (";
    for (const std::string_view extension : format->extensions) {
      if (!extension.empty()) text += std::string(extension) + ", ";
    }
    texts.push_back(text + std::string(format->summary) + ')');
  }
  return list_of({texts.begin(), texts.end()});
}

namespace {

// As the subject of a sentence, and its verb.
std::string subject(Contents contents) {
  const bool several =
      contents == Contents::points || contents == Contents::labels || contents == Contents::lines;
  return (several ? "" : "a ") + std::string(name_of(contents)) + (several ? " are" : " is");
}

Result<const Format*> by_name(FormatTable table, Contents contents, Direction direction,
                              const std::string& name) {
  for (const Format* format : table) {
    if (format->name == name && handles(*format, contents, direction)) return format;
  }
  const std::vector<std::string_view> names = names_of(table, contents, direction);
  return Error{ErrorCode::usage,
               subject(contents) + (direction == Direction::reading ? " read" : " written") +
                   " as " + list_of(names) + ", not as " + in_quotes(name) +
                   did_you_mean(name, names),
               {}};
}

// Nothing of the file, but a beginning long enough to meet the zeros of binary numbers.
bool is_text(std::string_view bytes) {
  constexpr std::size_t kBeginning = 4096;
  return bytes.substr(0, kBeginning).find('\0') == std::string_view::npos;
}

}  // namespace

Result<const Format*> choose_reader(FormatTable table, Contents contents, const Source& source,
                                    const std::string& named) {
  if (!named.empty()) return by_name(table, contents, Direction::reading, named);
  const Format* by_extension = nullptr;
  const Format* of_text = nullptr;
  const Format* of_others = nullptr;
  for (const Format* format : table) {
    const bool recognised = format->recognise != nullptr && format->recognise(source.bytes);
    if (!reads(*format, contents)) {
      if (recognised && of_others == nullptr) of_others = format;
      continue;
    }
    if (recognised) return format;
    const std::string_view extension = extension_in(*format, source.name);
    const std::string_view best =
        by_extension == nullptr ? "" : extension_in(*by_extension, source.name);
    if (extension.size() > best.size()) by_extension = format;
    if (format->takes_text && of_text == nullptr) of_text = format;
  }
  if (by_extension != nullptr) return by_extension;
  if (of_others == nullptr && of_text != nullptr && is_text(source.bytes)) return of_text;
  Error error{ErrorCode::invalid_input, {}, {}};
  error.where.file = source.name;
  if (of_others != nullptr) error.where.line = 1;  // it is the beginning that tells
  error.message = of_others != nullptr
                      ? "this is a file of the format " + std::string(of_others->name)
                      : std::string("nothing tells the format of this file");
  error.message += "; " + subject(contents) + " read as " + described_readers(table, contents);
  return error;
}

const Format* choose_by_section(FormatTable table, const Source& source, const std::string& named) {
  const Result<const Format*> chosen = choose_reader(table, Contents::stack, source, named);
  if (!chosen || (*chosen)->open_sections == nullptr) return nullptr;
  return !named.empty() || (*chosen)->recognise(source.bytes) ? *chosen : nullptr;
}

Result<const Format*> choose_writer(FormatTable table, Contents contents, const std::string& path,
                                    const std::string& named) {
  if (!named.empty()) return by_name(table, contents, Direction::writing, named);
  const Format* chosen = nullptr;
  for (const Format* format : table) {
    if (!writes(*format, contents)) continue;
    const std::string_view best = chosen == nullptr ? "" : extension_in(*chosen, path);
    if (extension_in(*format, path).size() > best.size()) chosen = format;
  }
  if (chosen != nullptr) return chosen;
  if (path.empty()) {
    return Error{ErrorCode::usage,
                 "the options name no format; " + subject(contents) + " written as " +
                     list_of(names_of(table, contents, Direction::writing)),
                 {}};
  }
  const std::string extension = extension_of(path);
  Error error{ErrorCode::usage,
              subject(contents) + " written as " +
                  list_of(extensions_of(table, contents, Direction::writing)) + ", not " +
                  (extension.empty() ? "without extension" : "as " + in_quotes(extension)),
              {}};
  error.where.file = path;
  return error;
}

}  // namespace tetloft::internal::io
