// From a stack of sections to a solid: the method of Nonato, Minghim, Oliveira and Tavares
// (2000), see src/reconstruct/README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/report.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/valid_stack.hpp>

namespace tetloft {

/// How the model ends at the first and last section.
enum class Ends : std::uint8_t {
  flat,  ///< at the section's plane
  half,  ///< half a gap beyond it: a prism over the section's region
};

struct ReconstructOptions {
  CorrespondenceOptions correspondence = {};
  Ends ends = Ends::flat;
  /// Sections put between two neighbouring given ones, interpolated, for the shape between: so
  /// many, or, without a number, as many as the slab's gap and contour edges call for (none where
  /// sections are dense). The given ones stay bit for bit. A slab gets none where its solid would
  /// hang together in another way, or have another topology, than the links of regions and voids
  /// imply. 0: none.
  std::optional<std::size_t> between = std::nullopt;
  /// The engine that triangulates the slabs; automatic means slab. The result is the same.
  DelaunayEngine delaunay = DelaunayEngine::automatic;
  /// Divide long edges of contours of few vertices where they differ from section to section: what
  /// lies between follows both contours then. Where sections have many vertices, as from images, no
  /// edge is; nor by Criterion::reverse, which asks D of the contours as they are. Sections for
  /// which that is too much, or that have no valid model so, are taken as they are, with a warning.
  bool divide_coarse = true;
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

struct Reconstruction {
  Model model;
  ReconstructReport report;
  /// The components as a partition of contours.
  ContourPartition partition;
  /// Links that were dropped, sections whose coarse contours could not be divided, and hints where
  /// a remedy is known: contours too coarse and not divided (refine()), most regions without a
  /// partner (gaps, units), far too many tets (snap()); each once.
  std::vector<Warning> warnings;
};

/// Reconstructs a solid that keeps the five guarantees (README), or refuses: invalid_input
/// for an invalid stack or labels, unrepresentable where double precision holds no valid
/// model, naming the place, work_limit where that is exceeded, naming the place, usage for
/// options out of range, cancelled if it was stopped.
/// May be called from many threads at once. All coordinates (and the thickness) times 2^k give the
/// same model times 2^k, bit for bit, as long as all coordinates of both stacks and both models are
/// doubles without loss.
[[nodiscard]] TETLOFT_API Result<Reconstruction> reconstruct(
    const SectionStack& stack, const ReconstructOptions& options = {});
/// The same of what need not be validated.
[[nodiscard]] TETLOFT_API Result<Reconstruction> reconstruct(
    const ValidStack& stack, const ReconstructOptions& options = {});

}  // namespace tetloft
