// Random valid stacks of named kinds, for property tests.
//
// A stack is a function of its kind and a 64-bit seed, through core/prng.hpp and nothing
// else. Every stack passes validate(): a draft that does not is thrown away and the next
// one drawn from the same seed. Small on purpose (two to four sections, contours of 3 to
// about 60 vertices): degeneracy, not size, is what breaks geometry.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <tetloft/correspondence.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::testing {

enum class StackKind : std::uint8_t {
  lattice_marching_squares,  ///< bitmap outlines with vertices on half-integers
  lattice_staircase,         ///< bitmap outlines along pixel sides
  small_grid,                ///< few polygons of few vertices on a grid of 9 × 9 points
  checkerboard,              ///< squares, shifted by half their pitch
  identical_sections,        ///< the same section again and again
  nesting,                   ///< contours in contours, to depth 5
  branching_one_to_many,
  branching_many_to_many,
  holes,             ///< appearing, vanishing, drifting, over exterior, with islands
  triangular_holes,  ///< holes of three vertices, in one section or in both, shifted
  isolated_contours,
  empty_sections,
  far_apart,        ///< clusters 10 to 10^5 diameters apart
  extreme_gaps,     ///< section distances from 1e-6 to 1e6
  scale_offset,     ///< far from the origin, and scales from 2^-300 to 2^300
  near_coincident,  ///< sections equal up to a jitter of 1e-3 to 1e-16
  near_touching,    ///< contours of one section 1e-1 to 1e-13 apart
  stars_combs,      ///< non-convex, deeply notched
  slivers,          ///< thin annuli, bars, corridors, needles
  u_over_blobs,     ///< horseshoes over blobs in their mouths
  crossing_bars,    ///< parallel bars over parallel bars the other way
  interlocking,     ///< two components whose thin bars cross, each in the other's plane too
  split_runs,       ///< cross edges on the hull around which a component is kept twice
  few_ulps,         ///< so far from the origin that shapes are some hundred ulps wide or less
  oblique,          ///< columns that drift by up to more than their width
  random_labels,    ///< any of some kinds, with realisable labels
  complementary_sections,  ///< each section the complement of the one before, in a frame
  changing_classes,        ///< regions that are one class below a section, several above it
  large_contours,          ///< up to 20,000 vertices
  islands,                 ///< many small contours, the same or nearly in each section
  nested_ngons,            ///< many polygons of few vertices in each other, turned
  concentric_ngons,        ///< fine polygons about centres that nearly agree
  tight_spirals,           ///< spirals whose windings nearly touch
  tiny_gaps,               ///< cells parted by gaps from 2^-6 to 2^-50 of their size
  ulp_combs,               ///< combs over themselves, teeth an ulp or few aside
  ulp_lattices,            ///< a lattice that the next section computes in another way
  needles,                 ///< thin triangles, far longer than apart
  pores,                   ///< blocks with holes in one section or two, and notches
  hole_islands,     ///< holes with islands, beside each other or over each other but for a little
  channels,         ///< tunnels that drift by up to more than their width
  open_pits,        ///< holes over exterior, in part or as a whole
  touching_holes,   ///< holes that share an edge, a piece of one or a vertex in projection
  rings,            ///< thin rings that hardly overlap, or not; and discs over them
  lattice_pores,    ///< bitmaps of blocks with pores and notches of a few pixels
  coarse_lofts,     ///< contours of few vertices turned, moved, crossed, and beside fine ones
  thin_parts,       ///< tubes, sheets and shells that lean by more than they are thick
  height_fields,    ///< level lines of height fields, closed along a rectangle
  mended_overlaps,  ///< those of broken.hpp, mended
  mended_copies,
  mended_keyholes,
  arranged_planes,
};

[[nodiscard]] std::span<const StackKind> all_kinds();
/// Those about what is not the solid.
[[nodiscard]] std::span<const StackKind> kinds_with_voids();
[[nodiscard]] const char* name_of(StackKind kind);
[[nodiscard]] std::optional<StackKind> kind_named(std::string_view name);

/// True for the kinds with features a few ulps wide, for which double precision may hold
/// no valid model.
[[nodiscard]] bool is_near_coincident(StackKind kind);

/// True for the kinds whose Delaunay triangulations grow with the product of the sections'
/// vertices (large circles about different centres): their work has the work limit alone.
[[nodiscard]] bool has_large_triangulations(StackKind kind);

struct GeneratedStack {
  SectionStack stack;
  CorrespondenceOptions correspondence;  ///< defaults, and labels where the kind has them
  int drafts = 1;                        ///< how many it took
};

[[nodiscard]] GeneratedStack generate(StackKind kind, std::uint64_t seed);

}  // namespace tetloft::testing
