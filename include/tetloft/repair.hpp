// Sections as they come from other tools, made fit: their planes put in order, mended, repaired,
// snapped to a lattice, refined; and gaps that are told of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
/// Is it one of those, as a reader tells them among others?
[[nodiscard]] TETLOFT_API bool is_of_gap(const Warning& warning);

enum class PlaneRule : std::uint8_t {
  sort = 0,   ///< by z; sections of the same z become one
  flip = 1,   ///< a stack that descends is turned over: the last section comes first
  merge = 2,  ///< sort, and sections that are no more than a tolerance apart become one
};

struct PlaneOptions {
  PlaneRule rule = PlaneRule::sort;
  /// Of merge, above 0; others take none. From the lowest section on, those at most so far above
  /// it are one with it, the next one above begins anew: no chain of small gaps grows longer.
  double tolerance = 0;
};

struct ArrangedPlanes {
  SectionStack stack;
  /// By section of the stack: those that it is made of, as they were numbered, by z and then by
  /// number. Contours are in that order too.
  IdVector<SectionId, std::vector<SectionId>> origin;
  std::vector<Warning> changes;  ///< one for each section made of several
};

/// Puts sections in the order that a stack needs. Coordinates stay as they are, but for the z of
/// sections merged: that at which most of their contours lie, the lowest of those. Refused: usage
/// for a rule or tolerance that is none; invalid_input naming the section for a z that is not
/// finite, and for flip where z does not strictly decrease. The rest is left to validate().
[[nodiscard]] TETLOFT_API Result<ArrangedPlanes> arrange_planes(const SectionStack& stack,
                                                                const PlaneOptions& options = {});

/// Which points of a section make up its region, where contours overlap.
enum class FillRule : std::uint8_t {
  odd = 0,  ///< those of odd crossing number
  /// Contours that overlap in part, so that the boundary of one lies partly inside and partly
  /// outside the other, are taken together: a point is inside them that one of them winds around.
  /// The region is what lies inside an odd number of such groups. So traces that overlap are
  /// united, and a contour that lies wholly in another, touching it perhaps, stays a hole.
  unite = 1,
  winding = 2,  ///< those that all contours together wind around; a hole must run the other way
};

struct RepairOptions {
  /// How far the boundary may move; without it 2^-20 of the section's largest coordinate.
  std::optional<double> distance = {};
  FillRule fill = FillRule::odd;
  /// Closes channels by which tools cut holes to the outline, up to so wide.
  std::optional<double> keyholes = {};
  Execution execution = {};
};

/// A contour around which, on either side, repair left no region.
struct LostBody {
  SectionId section;
  ContourId contour;
  double area = 0;  ///< that the contour bounds
};

struct Repaired {
  SectionStack stack;            ///< valid, unless all contours cancelled
  std::vector<Warning> changes;  ///< all of them, with their places
  double moved = 0;              ///< how far the boundary moved at most
  /// Of the region by the fill rule, summed over sections: copies counted once and crossings
  /// resolved; and of what came of it, channels closed and corners cut off.
  double area_before = 0;
  double area_after = 0;
  std::vector<LostBody> lost = {};  ///< each is told as a change, too
  std::size_t copies = 0;           ///< contours left out, for they repeat another
  std::size_t channels = 0;         ///< closed
};

/// Repairs sections as they come from other tools: spikes, contours without area, crossings and
/// contacts of contours with themselves and each other. Sections keep their region, the points
/// that the fill rule says, up to `distance`: crossings become vertices, which moves edges by
/// ulps; vertices and edges next to each other become one; where pieces of the region touch at a
/// vertex they are parted by cutting their corners off. Contours without contact stay as they are
/// (by the rule of winding: where they bound the region); the others become new contours, numbered
/// at the place of the one they begin with. What mend() removes is removed too. A valid stack stays
/// as it is, but for winding and keyholes. Refused (invalid_input, naming section and contour)
/// where that needs a larger distance; usage for lengths that are not above 0. Takes O(n log n + k)
/// for k pairs of edges whose extents in x overlap.
///
/// Copies: of contours that touch each other and are the same, whatever they begin with and which
/// way they run, one is kept; also where they are nearly so, as rounded otherwise: if every vertex
/// of one is so near to the other, and the other way round, that a strip of this width along both
/// has 2^-8 of the smaller one's area at most. The one of the larger area is kept.
///
/// Channels: two chains of the same contour that run beside each other, the region on their outer
/// sides and none between, from a place wider than `keyholes` to another, the outside and a hole,
/// or two holes. Their ends are *gates*: segments between vertices (or a vertex and the point of an
/// edge nearest to it, which becomes one), at most `keyholes` long, that run outside the region and
/// meet no contour; between two gates no disc has room that is wider than `keyholes` (as far as
/// those are that circumscribe or inscribe Delaunay triangles of the vertices between). Then what
/// lies between becomes region, and the hole a contour of its own. A slit that ends blindly stays,
/// and so do a narrow place without length, and one between two contours. A hole no wider than
/// `keyholes` is taken for an end of the channel.
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
