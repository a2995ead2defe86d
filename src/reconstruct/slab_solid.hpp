// The solid of one slab: seed, completion, subdivision, lifting, truncation, ends, and the
// proof that the result is embedded.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "slab/link.hpp"
#include "slab/rules.hpp"
#include "subdivision/truncation.hpp"

namespace tetloft::internal {

/// Tets over the vertices of two sections and constructed ones, and what making them took.
struct SlabSolid {
  SlabVertices vertices;
  SlabRegions regions;
  IdVector<ConstructedId, Point3> constructed;
  IdVector<ConstructedId, PointOrigin> origin;
  std::vector<Piece> pieces;
  RuleCounts rules{};
  double smallest_lift = 1;
  StepSeconds seconds{};
  std::uint64_t work = 0;  ///< ReconstructReport::work

  /// Of the pieces: slab vertices and constructed ones.
  [[nodiscard]] Nodes nodes() const { return Nodes(vertices.size()); }
};

/// A class of several regions has no Delaunay edge between its parts, and contours of its that
/// are not refined to Gabriel edges yet: it may be connectable with them.
struct RefineHere {
  std::vector<SlabRegionId> regions;  ///< of the class
};

/// The same where all its contours are.
struct Unconnectable {
  std::vector<SlabRegionId> regions;
};

/// Doubles hold no valid solid; the error names the place.
struct Unrepresentable {
  Error error;
};

using SlabOutcome = std::variant<SlabSolid, RefineHere, Unconnectable, Unrepresentable>;

/// How slabs are built. The solid is the same for each.
struct SlabOptions {
  DelaunayEngine engine = DelaunayEngine::automatic;
  double work_limit;
};

/// Builds the solid of a slab from its two conforming sections (either may be empty) and the
/// accepted links, of regions and of voids: a function of these alone. void_links: as of regions of
/// complements; null where nothing is decided about voids. Fails (work_limit) naming the place.
[[nodiscard]] Result<SlabOutcome> build_slab(SlabId id, const ConformingSection& lower,
                                             const ConformingSection& upper,
                                             const std::vector<Link>& links,
                                             const std::vector<Link>* void_links,
                                             const SlabOptions& options);

/// The end of a stack: all regions of a section extruded to z. Above its plane the section is the
/// lower one of a slab whose upper one is empty; below, the other way round.
[[nodiscard]] SlabSolid build_end(const ConformingSection& section, double z);

}  // namespace tetloft::internal
