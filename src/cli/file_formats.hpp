// What the table of formats says to users: words for files in help, and options that name a
// format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/formats.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// An input or output of this kind, for help: the word with its extension where there is but one
/// ("IN.ext"), else the word.
[[nodiscard]] std::string input_word(std::string_view word, Contents contents);
[[nodiscard]] std::string output_word(std::string_view word, Contents contents);

/// ".obj (what that is), .ply (…) or …": what can be written.
[[nodiscard]] std::string described_outputs(Contents contents);
/// The summaries of what can be read.
[[nodiscard]] std::string described_inputs(Contents contents);
/// The extensions of what can be written.
[[nodiscard]] std::vector<std::string_view> output_extensions(Contents contents);

/// Names of formats that write solids or boundaries, each once.
[[nodiscard]] std::vector<std::string_view> model_targets();
/// Whether the format of this name, or if it is empty that of the output's extension, takes solids:
/// one that does gets the solid of a model, another one the boundary.
[[nodiscard]] bool writes_solid(const std::string& output, const std::string& to);

/// Whether a file of this name would be read as such contents.
[[nodiscard]] bool has_input_extension(const std::string& path, Contents contents);

/// `name` NAME: reads the input that help calls `word` as that format.
[[nodiscard]] Option format_option(std::string_view name, std::string_view word, Contents contents);
/// The format that was given, or "". Usage error where there is none of that name.
[[nodiscard]] Result<std::string> chosen_format(const Arguments& arguments, std::string_view option,
                                                Contents contents);

}  // namespace tetloft::cli
