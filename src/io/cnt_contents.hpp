// What a .cnt holds as written, and judgements on it: what its numbers are, and whether a
// contour seems to be an open line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/result.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::io {

/// A contour with an odd number of numbers: all but the last are in its vertices.
struct OddContour {
  std::size_t section = 0;
  std::size_t contour = 0;
  double last = 0;
  std::size_t line = 0;  ///< of its closing brace
  std::size_t opened = 0;
};

/// Numbers taken in pairs.
struct CntContents {
  SectionStack stack;
  IdVector<SectionId, IdVector<ContourId, std::size_t>> lines;  ///< of the opening braces
  IdVector<SectionId, std::size_t> header_lines;                ///< of each "v"
  IdVector<SectionId, double> announced;                        ///< numbers of vertices
  std::vector<OddContour> odd;                                  ///< in the order of the file
  bool commas = false;  ///< there is one between two numbers
};

/// Makes vertices of the numbers: pairs; or the first two of every three, where three make a
/// vertex, with a warning. Never are pairs that make a valid stack of the announced counts taken
/// for anything else. Error invalid_input for odd contours, for three numbers of which the third
/// is not the height of the section, and for decimal commas; `where` lacks the file.
[[nodiscard]] Result<std::optional<Warning>> settle_vertices(CntContents& contents);

/// How many times longer the edge that closes a contour is than its longest other one; nothing
/// where it is not conspicuous.
[[nodiscard]] std::optional<double> conspicuous_closing(const Contour& contour);

/// Warnings of contours that are closed conspicuously, from one side of the box of all contours
/// to another: lines cut off at a frame. At most `most`.
[[nodiscard]] std::vector<Warning> open_lines(const SectionStack& stack, std::size_t most);

}  // namespace tetloft::io
