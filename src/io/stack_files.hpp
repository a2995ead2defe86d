// Which files are stacks, and of which files one is read: what a program looks at that finds its
// inputs by itself.
#pragma once

#include <string>
#include <vector>

#include <tetloft/formats.hpp>

namespace tetloft::internal::io {

/// Whether the contents of a file, or its extension, are of a format that stacks are read from (of
/// the one that is named, if any is). Text that nothing recognises is not said to be one, though
/// read_stack() would try. No file that cannot be read is one, but by its extension.
[[nodiscard]] bool is_stack_file(const std::string& path, const std::string& format);

/// The files that read_stack() takes its stack from: this one, then those of voxels that it names.
/// Only the first where that does not come out: reading it will tell why.
[[nodiscard]] std::vector<std::string> stack_files(const std::string& path,
                                                   const std::string& format);

/// Whether open_sections() reads the sections of a file one after the other, as far as its
/// beginning and the options tell.
[[nodiscard]] bool is_read_by_section(const std::string& path, const ReadOptions& options);

}  // namespace tetloft::internal::io
