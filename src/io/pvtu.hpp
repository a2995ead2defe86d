// Parallel VTK XML files (.pvtu): a solid whose parts are in .vtu files of their own.
#pragma once

#include <string>
#include <vector>

#include "io/sink.hpp"

namespace tetloft::internal::io {

/// What the parts of an index have in common.
struct IndexedGrid {
  bool with_stack_points = false;    ///< their frame rounds: vtu_frame.hpp
  std::vector<std::string> sources;  ///< their files, by path from the index's folder; UTF-8
};

/// Parts have all fields of models (model/fields.hpp).
void append_index(Sink& sink, const IndexedGrid& grid);

}  // namespace tetloft::internal::io
