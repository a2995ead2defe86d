// Which lines of a drawing are read.
#pragma once

#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "io/drawing/drawing.hpp"

namespace tetloft::internal::io {

/// A line, and where it stands in the file, for messages.
struct ChosenLine {
  DrawnLine line;
  std::size_t structure = 0;  ///< position in the drawing
  std::size_t position = 0;   ///< in its structure
};

struct ChosenLines {
  std::string name;  ///< of the structure, where one was chosen
  std::vector<ChosenLine> lines;
};

/// Takes the lines out of the drawing: those of the structure, or of the label, that `asked` names;
/// without it all, or those of the one structure that has closed lines where the file keeps objects
/// apart. Error usage where there is none of that name, or one of several must be chosen.
[[nodiscard]] Result<ChosenLines> choose_lines(Drawing& drawing, const std::string& asked);

/// "contour 3 of structure 'lung' (byte 12345)", zero-based.
[[nodiscard]] std::string place_of(const Drawing& drawing, const ChosenLine& line);

/// The position among `names` (and their numbers) of the one that `asked` names: a name as it is
/// written; else a number, which "#2" is whatever the names; else a name in other case, if one
/// alone fits.
[[nodiscard]] std::optional<std::size_t> find_structure(
    const std::string& asked, const std::vector<std::pair<double, std::string>>& known);

}  // namespace tetloft::internal::io
