// What files of contours hold, before it is made into a stack: structures of lines in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::io {

enum class LineKind : std::uint8_t {
  closed,  ///< whether or not the file repeats the first point
  open,
  points,  ///< no line at all
};

/// A contour as it stands in the file.
struct DrawnLine {
  std::vector<Point3> points;  ///< finite
  LineKind kind = LineKind::closed;
  std::string type;  ///< the format's own name for it ("CLOSED_PLANAR"); empty where it has none
  std::int64_t label = 0;    ///< of drawings with labels
  std::size_t line = 0;      ///< where it begins in a text file, one-based; 0: none
  std::uint64_t offset = 0;  ///< where it begins in a binary one; 0: none
  bool left_out = false;     ///< counted, but of no stack; the reader says why
};

struct DrawnStructure {
  std::int64_t number = 0;
  std::string name;
  std::vector<DrawnLine> lines;
};

/// That two lines of one structure belong together, by their positions in it.
struct DrawnJoin {
  std::size_t lower = 0;
  std::size_t upper = 0;
};

struct Drawing {
  std::vector<DrawnStructure> structures;
  /// The file keeps several objects apart, of which one is read; else the structures, or the one
  /// there is, are read together.
  bool apart = false;
  /// The option that chooses one: "--roi", "--label".
  std::string chosen_by = "--roi";
  /// Lines bear labels, which are part of the stack.
  bool labelled = false;
  /// Of a drawing of one structure: adjacency, where the file tells it, and then all of it.
  std::vector<DrawnJoin> joins;
  /// Contours of the format may touch and cross themselves and each other, as keyholes do; the
  /// region is that of odd crossing number. They are repaired when the stack is made.
  bool may_touch = false;
  /// Open lines and points are left out, as the format means them; else an open line is refused.
  bool leaves_out_open = false;
  /// Planes, where the file tells how many it has; 0: those of the lines are counted.
  std::size_t planes = 0;
  /// Where the file itself tells that its planes are not parallel: two that are not.
  std::string not_parallel;
  /// Every line has one height, as the file says it: those of equal height are one section, and no
  /// others, if no tolerance is asked for.
  bool exact_heights = false;
  /// What is to be done to the lines before they become a stack, but not before they are counted;
  /// or the error that they become none. Null: nothing.
  std::function<Result<void>(Drawing&)> prepare;
  std::string unit;
  std::string orientation;  ///< Description::orientation
  std::vector<Warning> warnings;
};

}  // namespace tetloft::internal::io
