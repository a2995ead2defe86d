// What a .cnt holds as written, and judgements on it: what its numbers are, and whether a
// contour seems to be an open line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/repair.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::io {

/// Numbers taken in pairs. What remains of an odd number of them is a last vertex of which y is
/// NaN, until settle_vertices().
struct CntContents {
  SectionStack stack;
  IdVector<SectionId, IdVector<ContourId, std::size_t>> lines;  ///< of the opening braces
  IdVector<SectionId, std::size_t> header_lines;                ///< of each "v"
  IdVector<SectionId, double> announced;                        ///< numbers of vertices
  /// Where the first odd contour begins and ends.
  struct Odd {
    std::size_t opened = 0;
    std::size_t closed = 0;
  };
  std::optional<Odd> odd;
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

/// The contours that are lines, taken for such on request: the first and the last vertex lie on the
/// box of all contours, on different sides; or on one, and the edge between them is conspicuous.
[[nodiscard]] std::vector<ContourOfSection> lines_to_the_frame(const SectionStack& stack);

}  // namespace tetloft::internal::io
