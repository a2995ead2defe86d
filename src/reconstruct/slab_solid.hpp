// The solid of one slab: seed, completion, subdivision, lifting, truncation, ends, and the
// proof that the result is embedded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "completion/passages.hpp"
#include "reconstruct/slab_topology.hpp"
#include "sections/face_overlay.hpp"
#include "slab/link.hpp"
#include "slab/rules.hpp"
#include "subdivision/truncation.hpp"

namespace tetloft::internal {

/// What was decided about a slab.
struct SlabLinks {
  const std::vector<Link>& regions;
  /// Of voids (sections/complement.hpp numbers them); null where nothing was decided about them.
  const std::vector<Link>* voids = nullptr;
  /// The sections' overlay, maybe without its plane, where it has been made before.
  const sections::FaceOverlay* faces = nullptr;
};

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
  std::uint32_t sections_between = 0;
  std::uint32_t sections_given_up = 0;  ///< that were to be put between
  /// Euler characteristic of each class (SlabClasses).
  IdVector<ClassId, std::int32_t> chi;
  /// By region; none where nothing was decided about voids.
  std::vector<SlabDeviation> deviations;
  /// Links of voids that are none, since no opening could be had.
  std::vector<Link> unrealised;
  /// Voids that count as one though no link says so: rule V6 of voids.hpp. Of sections, lower and
  /// upper of the slab or two of one section.
  std::vector<Inseparable> united_voids;

  /// Of the pieces: slab vertices and constructed ones.
  [[nodiscard]] Nodes nodes() const { return Nodes(vertices.size()); }
};

/// Contours that are not all refined to Gabriel edges yet: what cannot be done may be with them.
/// Either a class of several regions has no Delaunay edge between its parts, or no wall can stand
/// between two voids.
struct RefineHere {
  std::array<std::vector<ContourId>, 2> contours;  ///< of the lower section, of the upper one
  /// Of both sections, in the plane: points of faces to be opened that circles of triangles inside
  /// the regions must not hold (ConformOptions::apart).
  std::vector<Point2> apart;
  /// Is it for the topology alone, which can be gone without?
  bool optional = false;
};

/// A class of several regions has no Delaunay edge between its parts though its contours are
/// refined.
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
  /// May the slab ask for finer contours to get the topology that links imply? Where they cannot be
  /// had it goes without.
  bool may_ask = true;
};

/// Builds the solid of a slab from its two conforming sections (either may be empty) and the
/// accepted links: a function of these alone. Fails (work_limit) naming the place.
[[nodiscard]] Result<SlabOutcome> build_slab(SlabId id, const ConformingSection& lower,
                                             const ConformingSection& upper, const SlabLinks& links,
                                             const SlabOptions& options);

/// The end of a stack: all regions of a section extruded to z. Above its plane the section is the
/// lower one of a slab whose upper one is empty; below, the other way round.
[[nodiscard]] SlabSolid build_end(const ConformingSection& section, double z);

}  // namespace tetloft::internal
