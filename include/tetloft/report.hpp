// What a reconstruction tells of itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <tetloft/export.hpp>

namespace tetloft {

/// How often each rule of the method fired; see src/slab/README.md, "Rules and their counters", for
/// each.
enum class Rule : std::uint8_t {
  run_at_contour_edge,
  run_at_external_edge,
  run_at_cross_edge,
  gap_at_cross_edge,
  hole_in_link,
  detached_sheet,
  merge_sheets,
  connect_parts,
  triangular_hole,
  two_class_tet,
  halved_lift,
  moved_cut,
  prism,
  gluing,
  gabriel_refinement,
  opened_pit,
  closed_passage,
  united_voids,
  filled_handle,
  bridged_face,
  opened_face,
};
inline constexpr int kRules = 21;
[[nodiscard]] TETLOFT_API const char* name_of(Rule rule);

/// The steps that time is told for.
enum class Step : std::uint8_t {
  sections,        ///< validation, nesting, conforming triangulations
  delaunay,        ///< D of every slab
  correspondence,  ///< classes
  between,         ///< sections put between
  complex,         ///< seed and completion
  subdivision,     ///< midpoints, lifting, truncation
  contact,         ///< exact contact tests
  assembly,        ///< gluing and numbering
};
inline constexpr int kSteps = 8;
[[nodiscard]] TETLOFT_API const char* name_of(Step step);

struct ReconstructReport {
  std::size_t slices = 0;
  std::size_t sections_between = 0;   ///< put between the slices
  std::size_t sections_given_up = 0;  ///< of slabs that they did not fit
  std::size_t contours = 0;
  std::size_t input_vertices = 0;
  std::size_t split_vertices = 0;     ///< inserted on contours
  std::size_t dividing_vertices = 0;  ///< of these, the ones that divide coarse contours
  std::size_t vertices = 0;
  std::size_t tets = 0;
  std::size_t components = 0;
  double volume = 0;
  /// Smallest fraction of the way to its target that a lifted vertex went; 1/2 or more is
  /// ideal; 1 without lifted vertices.
  double smallest_lift = 1;
  /// What was done, whatever the clock and the threads: tets of the slabs' Delaunay
  /// triangulations, looked at in completion and tested for embedding, each as often as it was,
  /// pairs of triangles tested for contact, and inserted vertices.
  std::uint64_t work = 0;
  std::array<std::uint64_t, kRules> rules{};
  /// CPU seconds summed over threads, by step; and wall-clock seconds in all.
  std::array<double, kSteps> seconds{};
  double seconds_total = 0;
};

}  // namespace tetloft
