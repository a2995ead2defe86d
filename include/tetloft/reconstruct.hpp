// From a stack of sections to a solid: the method of Nonato, Minghim, Oliveira and Tavares
// (2000), see src/reconstruct/README.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// How the model ends at the first and last section.
enum class Ends : std::uint8_t {
  flat,  ///< at the section's plane
  half,  ///< half a gap beyond it: a prism over the section's region
};

/// No sane stack comes near it; what does is refused within seconds.
inline constexpr double kDefaultWorkLimit = 128;

struct ReconstructOptions {
  CorrespondenceOptions correspondence = {};
  Ends ends = Ends::flat;
  /// The engine that triangulates the slabs; automatic means slab. The result is the same.
  DelaunayEngine delaunay = DelaunayEngine::automatic;
  /// Thickness of the solid made from a single section, centred on its plane. Without it a
  /// tenth of the larger side of the bounding box is taken, and a warning given.
  std::optional<double> thickness = {};
  /// The most work that a section or slab may take, in tets per vertex: a slab as many tets of
  /// its Delaunay triangulation; a section a 16th as many vertices to be inserted. With fewer than
  /// 2^15 vertices they may take what 2^15 may. Real stacks have 7 tets per vertex, 100 where large
  /// circles of 1,000 vertices lie about different centres; these grow with the product of their
  /// vertices. Beyond the limit reconstruct ends while it works, with ErrorCode::work_limit, naming
  /// the place. Above 0; infinity: no limit.
  double work_limit = kDefaultWorkLimit;
  Execution execution = {};  ///< threads share the sections and slabs
};

/// How often each rule of the method fired; see src/reconstruct/README.md for each.
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
};
inline constexpr int kRules = 16;
[[nodiscard]] TETLOFT_API const char* name_of(Rule rule);

/// The steps that time is told for.
enum class Step : std::uint8_t {
  sections,        ///< validation, nesting, conforming triangulations
  delaunay,        ///< D of every slab
  correspondence,  ///< classes
  complex,         ///< seed and completion
  subdivision,     ///< midpoints, lifting, truncation
  contact,         ///< exact contact tests
  assembly,        ///< gluing and numbering
};
inline constexpr int kSteps = 7;
[[nodiscard]] TETLOFT_API const char* name_of(Step step);

struct ReconstructReport {
  std::size_t slices = 0;
  std::size_t contours = 0;
  std::size_t input_vertices = 0;
  std::size_t split_vertices = 0;
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

struct Reconstruction {
  Model model;
  ReconstructReport report;
  /// The components as a partition of contours.
  ContourPartition partition;
  std::vector<Warning> warnings;
};

/// Reconstructs a solid that keeps the four guarantees (README), or refuses: invalid_input
/// for an invalid stack or labels, unrepresentable where double precision holds no valid
/// model, naming the place, work_limit where that is exceeded, naming the place, usage for
/// options out of range, cancelled if it was stopped.
/// May be called from many threads at once. All coordinates (and the thickness) times 2^k give the
/// same model times 2^k, bit for bit, as long as all coordinates of both stacks and both models are
/// doubles without loss.
[[nodiscard]] TETLOFT_API Result<Reconstruction> reconstruct(
    const SectionStack& stack, const ReconstructOptions& options = {});

}  // namespace tetloft
