// From a drawing to a stack: which lines count, in which planes they lie, and where these are.
#pragma once

#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "io/drawing/drawing.hpp"
#include "io/stack_of_file.hpp"

namespace tetloft::internal::io {

/// `name` stands for the file in messages. Errors: usage where options.structure names none, or one
/// of several must be named; invalid_input where no lines are left, or their planes are not
/// parallel, or the stack is not valid.
[[nodiscard]] Result<StackOfFile> stack_of_drawing(Drawing drawing, const std::string& name,
                                                   const ReadOptions& options);

/// Counts of what stands in the file.
[[nodiscard]] FileSummary summary_of_drawing(Drawing drawing);

}  // namespace tetloft::internal::io
