// Gluing: the solids of all slabs and ends become one model.
//
// Section vertices are shared, everything else is a slab's own: at a section plane two
// solids meet in exactly the region's triangles, so links that are discs on both sides
// glue to a disc or sphere.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include <tetloft/model.hpp>

#include "reconstruct/correspondence.hpp"
#include "reconstruct/slab_solid.hpp"

namespace tetloft {

/// A solid to be glued: its place in the stack and its sections (invalid: none).
struct Part {
  SlabId slab;
  SectionId lower;
  SectionId upper;
  SlabSolid solid;
};

/// What the parts of a model did, in sum.
struct PartTally {
  RuleCounts rules{};
  std::array<double, kSteps> seconds{};
  double smallest_lift = 1;
  std::uint64_t work = 0;
};

/// A model that grows part by part, so that a part is held no longer than those below it take.
/// Vertices are numbered by section (canonical order in each), then constructed ones by part;
/// those that no tet uses are left out.
class Assembly {
 public:
  /// Both must outlive the assembly and not change.
  Assembly(const IdVector<SectionId, ConformingSection>& sections,
           const Correspondence& correspondence);

  /// Glues the part that is the place-th from below, counted from 0; each place comes once.
  /// May be called from several threads, places in any order: a part that comes early waits.
  void add(std::size_t place, Part part);

  [[nodiscard]] const PartTally& tally() const { return tally_; }
  /// The model, handed out; requires that no part waits.
  [[nodiscard]] Model take();

 private:
  void add_section_vertices();
  VertexId add_point(const Point3& p, SectionId section, ContourId contour, PointOrigin origin);
  [[nodiscard]] ComponentId component_of(const Part& part, SlabRegionId region) const;
  void glue(const Part& part);

  const IdVector<SectionId, ConformingSection>& sections_;
  const Correspondence& correspondence_;
  std::mutex mutex_;                       // of all below
  std::vector<std::size_t> first_vertex_;  // of each section, in the model
  std::size_t next_ = 0;                   // the place to be glued next
  std::map<std::size_t, Part> waiting_;    // by place
  PartTally tally_;
  Model model_;
};

}  // namespace tetloft
