// One function for each kind of stack. What they draft is not yet validated.
#pragma once

#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/sections.hpp>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;

// kinds_lattice.cpp
SectionStack draft_lattice_marching_squares(Prng& prng);
SectionStack draft_lattice_staircase(Prng& prng);
SectionStack draft_small_grid(Prng& prng);
SectionStack draft_checkerboard(Prng& prng);
SectionStack draft_identical_sections(Prng& prng);

SectionStack draft_complementary_sections(Prng& prng);

// kinds_branching.cpp
SectionStack draft_nesting(Prng& prng);
SectionStack draft_branching_one_to_many(Prng& prng);
SectionStack draft_branching_many_to_many(Prng& prng);
SectionStack draft_holes(Prng& prng);
SectionStack draft_triangular_holes(Prng& prng);
SectionStack draft_isolated_contours(Prng& prng);
SectionStack draft_empty_sections(Prng& prng);
SectionStack draft_changing_classes(Prng& prng);

// kinds_degenerate.cpp
SectionStack draft_far_apart(Prng& prng);
SectionStack draft_extreme_gaps(Prng& prng);
SectionStack draft_scale_offset(Prng& prng);
SectionStack draft_near_coincident(Prng& prng);
SectionStack draft_near_touching(Prng& prng);
SectionStack draft_slivers(Prng& prng);

// kinds_shapes.cpp
SectionStack draft_stars_combs(Prng& prng);
SectionStack draft_u_over_blobs(Prng& prng);
SectionStack draft_crossing_bars(Prng& prng);
SectionStack draft_oblique(Prng& prng);
SectionStack draft_large_contours(Prng& prng);
SectionStack draft_coarse_lofts(Prng& prng);
SectionStack draft_thin_parts(Prng& prng);

// kinds_rare.cpp
SectionStack draft_interlocking(Prng& prng);
SectionStack draft_split_runs(Prng& prng);
SectionStack draft_few_ulps(Prng& prng);

// kinds_costly.cpp
SectionStack draft_islands(Prng& prng);
SectionStack draft_nested_ngons(Prng& prng);
SectionStack draft_concentric_ngons(Prng& prng);
SectionStack draft_tight_spirals(Prng& prng);
SectionStack draft_tiny_gaps(Prng& prng);
SectionStack draft_ulp_combs(Prng& prng);
SectionStack draft_ulp_lattices(Prng& prng);
SectionStack draft_needles(Prng& prng);

// kinds_voids.cpp
SectionStack draft_pores(Prng& prng);
SectionStack draft_hole_islands(Prng& prng);
SectionStack draft_channels(Prng& prng);
SectionStack draft_open_pits(Prng& prng);
SectionStack draft_touching_holes(Prng& prng);
SectionStack draft_rings(Prng& prng);
SectionStack draft_lattice_pores(Prng& prng);

// height_fields.cpp
SectionStack draft_height_fields(Prng& prng);
// kinds_mended.cpp
SectionStack draft_mended_overlaps(Prng& prng);
SectionStack draft_mended_copies(Prng& prng);
SectionStack draft_mended_keyholes(Prng& prng);
SectionStack draft_arranged_planes(Prng& prng);

// labels.cpp
/// Labels for regions of a valid stack such that each label can be made one component by
/// links between its own regions: its regions lie in consecutive sections, at least one in
/// each, and only one if it lies in one section.
[[nodiscard]] std::vector<Label> random_labels(Prng& prng, const SectionStack& stack);

}  // namespace tetloft::testing
