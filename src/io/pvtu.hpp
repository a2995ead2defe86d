// Parallel VTK XML files (.pvtu): a solid whose parts are in .vtu files of their own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/sink.hpp"

namespace tetloft::internal::io {

/// What the parts of an index have in common.
struct IndexedGrid {
  bool with_stack_points = false;    ///< their frame rounds: vtu_frame.hpp
  std::vector<std::string> sources;  ///< their files, by path from the index's folder; UTF-8
};

/// Whether a file that begins so is an index.
[[nodiscard]] bool begins_as_index(std::string_view bytes);
/// The sources of an index, as it calls them. Refused (invalid_input; `name` stands for the file)
/// where it is damaged or lists none.
[[nodiscard]] Result<std::vector<std::string>> index_sources(std::string_view bytes,
                                                             const std::string& name);

/// Parts have all fields of models (model/fields.hpp).
void append_index(Sink& sink, const IndexedGrid& grid);

}  // namespace tetloft::internal::io
