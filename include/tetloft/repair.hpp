// Sections as they come from other tools, made fit: mended, repaired, snapped to a lattice,
// refined; and gaps that are told of.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// Removes what changes nothing: a first vertex repeated at the end, consecutive
/// duplicate vertices. Returns one warning for each contour changed. Contours left with
/// fewer than three vertices stay as they are, for validate() to name.
TETLOFT_API std::vector<Warning> mend(SectionStack& stack);

/// Gaps between planes that are a thousandth, or less, of the gaps around them: one warning for
/// each, naming the upper section. A slice written as two planes becomes a body of its own where
/// its contours are parted. Only gaps between sections with contours, alone or two in a row, are
/// told: more than that is a finer sampling.
[[nodiscard]] TETLOFT_API std::vector<Warning> suspicious_gaps(const SectionStack& stack);

struct RepairOptions {
  /// How far the boundary may move; without it 2^-20 of the section's largest coordinate.
  std::optional<double> distance = {};
  Execution execution = {};
};

struct Repaired {
  SectionStack stack;            ///< valid, unless all contours cancelled
  std::vector<Warning> changes;  ///< all of them, with their places
  double moved = 0;              ///< how far the boundary moved at most
};

/// Repairs sections as they come from other tools: spikes, contours without area, crossings and
/// contacts of contours with themselves and each other. Sections keep their region, the points of
/// odd crossing number, up to `distance`: crossings become vertices, which moves edges by ulps;
/// edges that lie on each other cancel; where pieces of the region touch at a vertex they are
/// parted by cutting their corners off. Contours without contact stay as they are; the others
/// become new contours, numbered at the place of the one they begin with. What mend() removes is
/// removed too. A valid stack stays as it is. Refused (invalid_input, naming section and contour)
/// where that needs a larger distance. Takes O(n log n + k) for k pairs of edges whose extents in x
/// overlap.
[[nodiscard]] TETLOFT_API Result<Repaired> repair(const SectionStack& stack,
                                                  const RepairOptions& options = {});

/// A vertex that snapping moved, and whereto.
struct MovedVertex {
  SectionId section;
  ContourId contour;
  std::size_t vertex = 0;
  Point2 from;
  Point2 to;
};

struct Snapped {
  SectionStack stack;
  std::vector<MovedVertex> moved;
  double lattice = 0;  ///< the power of two that x and y are multiples of now
  int bits = 0;        ///< log2 of (extent / lattice), ≥ what was asked for
};

/// Rounds x and y to the lattice of 2^-bits times the largest coordinate magnitude
/// (rounded up to a power of two); takes a finer lattice, bit by bit up to 50, while
/// snapping makes contours touch or degenerate; vertices that fall on their predecessor
/// are removed (and listed as moved there). Refused (usage) unless 1 ≤ bits ≤ 50, and
/// (invalid_input) where no lattice keeps the stack valid.
[[nodiscard]] TETLOFT_API Result<Snapped> snap(const SectionStack& stack, int bits,
                                               const Execution& execution = {});

struct ContourOfSection {
  SectionId section;
  ContourId contour;
};

struct FrameOptions {
  /// The rectangle's corners of least and largest coordinates. None: the box of all lines; a side
  /// of it where no open line ends is taken farther out, by a sixteenth of the larger extent.
  std::optional<std::array<Point2, 2>> corners = {};
};

struct ClosedOnFrame {
  SectionStack stack;  ///< not validated
  /// Of each contour the one of the stack that it is, or the first that became part of it; invalid
  /// for the rectangle.
  IdVector<SectionId, IdVector<ContourId, ContourId>> origin;
  Point2 low, high;  ///< the rectangle
  std::vector<Warning> changes;
};

/// Closes open level lines along a rectangle, so that the region of each section is where a height
/// field, of which the sections are levels, is at least as high. `open` are the contours that are
/// lines, from their first vertex to their last one; without any the stack stays as it is. Refused
/// (invalid_input, naming section and contour) where a line ends off the rectangle, or two in one
/// point of it.
/// The rule: the ends of a section's lines cut the rectangle's perimeter into arcs that lie inside
/// and outside by turns, so there are two closings, each the complement of the other; without open
/// lines these are the region of the closed contours and the rectangle less that region. Two
/// closings of neighbouring sections contradict each other wherever the upper region is not within
/// the lower one: on each arc between ends of either that only the upper one holds, and at each
/// closed contour of the upper section outside of the lower region, or of the lower section inside
/// of the upper region. Of all choices that with the fewest contradictions is taken, exactly; a
/// height field has one without. Of equal ones, from the top section down, the closing that is
/// outside before the rectangle's lowest corner, counter-clockwise; a warning names the sections.
[[nodiscard]] TETLOFT_API Result<ClosedOnFrame> close_on_frame(
    const SectionStack& stack, const std::vector<ContourOfSection>& open,
    const FrameOptions& options = {});

struct Refined {
  SectionStack stack;
  std::size_t inserted = 0;  ///< vertices
};

/// Divides contour edges longer than `length` into equal parts no longer than it; points are
/// rounded once. Coarse contours, a rectangle of four vertices say, tell the Delaunay
/// triangulation little about what lies across: refined ones keep open what they close. Refused:
/// usage for a length that is not positive, or so small that 2^26 vertices do not suffice;
/// invalid_input for an invalid stack, or where rounding makes contours touch.
[[nodiscard]] TETLOFT_API Result<Refined> refine(const SectionStack& stack, double length,
                                                 const Execution& execution = {});

}  // namespace tetloft
