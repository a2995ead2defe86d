// See file_formats.hpp.
#include "cli/file_formats.hpp"

#include <algorithm>

#include "core/spelling.hpp"
#include "io/formats.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

using io::Direction;

std::string file_word(std::string_view word, Contents contents, Direction direction) {
  const auto extensions = io::extensions_of(io::format_table(), contents, direction);
  return std::string(word) + (extensions.size() == 1 ? std::string(extensions.front()) : "");
}

}  // namespace

std::string input_word(std::string_view word, Contents contents) {
  return file_word(word, contents, Direction::reading);
}

std::string output_word(std::string_view word, Contents contents) {
  return file_word(word, contents, Direction::writing);
}

std::string described_outputs(Contents contents) {
  std::vector<std::string> texts;
  for (const FormatInfo& format : formats()) {
    if (!format.writes.has(contents)) continue;
    std::string text;
    for (const std::string_view extension : format.extensions) {
      text += (text.empty() ? "" : ", ") + std::string(extension);
    }
    texts.push_back(text + " (" + std::string(format.summary) + ')');
  }
  return list_of({texts.begin(), texts.end()});
}

std::string described_inputs(Contents contents) {
  std::vector<std::string> texts;
  for (const FormatInfo& format : formats()) {
    if (format.reads.has(contents)) texts.emplace_back(format.summary);
  }
  return list_of({texts.begin(), texts.end()});
}

std::vector<std::string_view> output_extensions(Contents contents) {
  return io::extensions_of(io::format_table(), contents, Direction::writing);
}

std::vector<std::string_view> model_targets() {
  std::vector<std::string_view> names;
  for (const FormatInfo& format : formats()) {
    const bool writes = format.writes.has(Contents::model) || format.writes.has(Contents::surface);
    if (writes) names.push_back(format.name);
  }
  return names;
}

bool writes_solid(const std::string& output, const std::string& to) {
  return io::choose_writer(io::format_table(), Contents::model, output, to).ok();
}

bool has_input_extension(const std::string& path, Contents contents) {
  return std::any_of(
      io::format_table().begin(), io::format_table().end(), [&](const io::Format* format) {
        return io::reads(*format, contents) && !io::extension_in(*format, path).empty();
      });
}

Option format_option(std::string_view name, std::string_view word, Contents contents) {
  const auto names = io::names_of(io::format_table(), contents, Direction::reading);
  return {std::string(name),
          "NAME",
          "read " + std::string(word) + " as " +
              io::described_readers(io::format_table(), contents) +
              "; default: by its contents, then its extension",
          {},
          {names.begin(), names.end()}};
}

Result<std::string> chosen_format(const Arguments& arguments, std::string_view option,
                                  Contents contents) {
  const auto names = io::names_of(io::format_table(), contents, Direction::reading);
  const auto chosen = arguments.choice(option);
  if (!chosen) return chosen.error();
  return chosen->has_value() ? std::string(names[**chosen]) : std::string();
}

}  // namespace tetloft::cli
