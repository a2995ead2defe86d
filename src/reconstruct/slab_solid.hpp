// The solid of one slab: seed, completion, subdivision, lifting, truncation, ends, and the
// proof that the result is embedded.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "reconstruct/completion.hpp"
#include "reconstruct/complex.hpp"
#include "reconstruct/truncation.hpp"

namespace tetloft {

/// Tets over the vertices of two sections (lower, then upper) and constructed ones.
struct SlabSolid {
  std::size_t section_vertices = 0;  ///< nodes below this are vertices of the sections
  std::vector<Point3> constructed;   ///< node section_vertices + i
  std::vector<PointOrigin> origin;   ///< of constructed nodes
  std::vector<Piece> pieces;
  RuleCounts rules{};
  double smallest_lift = 1;
  std::array<double, kSteps> seconds{};
  std::uint64_t work = 0;  ///< ReconstructReport::work
  /// Classes that D offers no edge to connect: their contours need Gabriel edges. If not
  /// empty, there is no solid.
  std::vector<Unconnectable> unconnectable;
};

/// Builds the solid of a slab, from its two conforming sections (either may be empty) and
/// the accepted links; `engine` triangulates. Fails (unrepresentable, work_limit) naming the
/// place.
[[nodiscard]] Result<SlabSolid> build_slab_solid(SlabId id, const ConformingSection& lower,
                                                 const ConformingSection& upper,
                                                 const std::vector<Link>& links,
                                                 DelaunayEngine engine, double work_limit);

/// The end of a stack: all regions of a section extruded to z (above or below its plane).
/// Nodes and regions are numbered as in a slab whose other section is empty.
[[nodiscard]] SlabSolid build_end(const ConformingSection& section, double z);

}  // namespace tetloft
