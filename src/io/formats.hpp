// The table of formats, and the choice from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/formats.hpp>

#include "io/format.hpp"

namespace tetloft::internal::io {

using FormatTable = std::span<const Format* const>;

[[nodiscard]] FormatTable format_table();

[[nodiscard]] bool reads(const Format& format, Contents contents);
[[nodiscard]] bool writes(const Format& format, Contents contents);

/// The extension of `format` that `path` ends in, whatever its case, or "". The longest one.
[[nodiscard]] std::string_view extension_in(const Format& format, const std::string& path);

/// The reader of `contents` for a source: the one that is named; else of those that recognise the
/// bytes, or have the extension, the first; else, where no other format recognises the bytes and
/// they are text, the one that takes text. Error usage where the name is wrong, invalid_input
/// naming the formats that can be read.
[[nodiscard]] Result<const Format*> choose_reader(FormatTable table, Contents contents,
                                                  const Source& source, const std::string& named);

/// The format of a stack, if source.bytes, the beginning of a regular file, tell it, or it is
/// named, and its sections are read one after the other; else null. A name, or text that nothing
/// recognises, are no reason to hold what follows for anything.
[[nodiscard]] const Format* choose_by_section(FormatTable table, const Source& source,
                                              const std::string& named);

/// The writer of `contents` for a path: the one that is named, else that of the extension, the
/// longest where several fit. Error usage naming the formats that can be written.
[[nodiscard]] Result<const Format*> choose_writer(FormatTable table, Contents contents,
                                                  const std::string& path,
                                                  const std::string& named);

/// Where the companions of a model's file stand: `path` with another ending each; none where the
/// path has no extension of the format.
[[nodiscard]] std::vector<std::string> companion_paths(const Format& format,
                                                       const std::string& path);

/// The extensions of formats that read, or write, `contents`, each once.
enum class Direction : std::uint8_t { reading, writing };
[[nodiscard]] std::vector<std::string_view> extensions_of(FormatTable table, Contents contents,
                                                          Direction direction);
/// Names of formats.
[[nodiscard]] std::vector<std::string_view> names_of(FormatTable table, Contents contents,
                                                     Direction direction);

/// The formats that read `contents`, in a row, for help and messages.
[[nodiscard]] std::string described_readers(FormatTable table, Contents contents);

}  // namespace tetloft::internal::io
