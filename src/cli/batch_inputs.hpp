// The stacks of a folder, or of a list, and names for what is made of each.
#pragma once

#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// What the log is called that stands beside the solids.
inline constexpr const char* kBatchLog = "tetloft.jsonl";

/// Whether the operand stands for many stacks: --list, a name that ends in .list, or a folder.
[[nodiscard]] bool names_many(const Arguments& arguments);

struct BatchInputs {
  std::vector<std::string> stacks;
  std::vector<std::string> left_out;  ///< files of the folder that are none
};

/// Of a folder the files in it, by name, that a reader recognises (io/stack_files.hpp), without
/// hidden ones and those that another one names as its data; folders in it are not entered. Of a
/// list its lines, but for empty ones and comments: paths as from where the command runs. Error
/// invalid_input where there is none, or a line is there twice.
[[nodiscard]] Result<BatchInputs> batch_inputs(const Arguments& arguments,
                                               const std::string& format);

/// A name for each, without extension: that of the file, less the extension of its format. Where
/// several have one name, whatever the case, the folders go before it that tell them apart, and
/// where none does, they keep their extensions. Error usage where two are the same even so.
[[nodiscard]] Result<std::vector<std::string>> output_stems(const std::vector<std::string>& stacks);

}  // namespace tetloft::cli
