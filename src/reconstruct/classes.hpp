// Classes of a slab: the unions of the links accepted in this slab alone. Two regions of
// one component that only other slabs connect are different classes here, and stay apart.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/sections.hpp>

#include "reconstruct/correspondence.hpp"

namespace tetloft {

using ClassId = Id<struct ClassTag>;

/// The regions of a slab in one numbering: the lower section's first, then the upper's.
using SlabRegionId = Id<struct SlabRegionTag>;

class SlabClasses {
 public:
  SlabClasses(const ConformingSection& lower, const ConformingSection& upper,
              const std::vector<Link>& links);

  [[nodiscard]] std::size_t class_count() const { return members_.size(); }
  [[nodiscard]] std::size_t region_count() const { return class_of_region_.size(); }
  [[nodiscard]] ClassId of_region(SlabRegionId r) const { return class_of_region_[r]; }
  /// Regions of a class, by id.
  [[nodiscard]] const std::vector<SlabRegionId>& regions(ClassId c) const { return members_[c]; }
  /// A class without counterpart in the other plane: a single region.
  [[nodiscard]] bool is_lone(ClassId c) const { return members_[c].size() == 1; }

  /// The class of exterior vertices (pits.hpp), which has no region; invalid without any.
  [[nodiscard]] ClassId exterior() const { return exterior_; }

  /// Region and class of a slab vertex (numbering of Slab). Exterior vertices have the region
  /// behind the last one.
  [[nodiscard]] SlabRegionId region(VertexId v) const { return region_of_vertex_[v]; }
  [[nodiscard]] ClassId of(VertexId v) const { return class_of_region_[region_of_vertex_[v]]; }

  [[nodiscard]] bool is_upper(SlabRegionId r) const { return r.index() >= lower_regions_; }
  /// The region's id in its own section.
  [[nodiscard]] RegionId in_section(SlabRegionId r) const {
    return RegionId(is_upper(r) ? r.index() - lower_regions_ : r.index());
  }

 private:
  std::size_t lower_regions_;
  ClassId exterior_;
  IdVector<SlabRegionId, ClassId> class_of_region_;
  IdVector<ClassId, std::vector<SlabRegionId>> members_;
  IdVector<VertexId, SlabRegionId> region_of_vertex_;
};

}  // namespace tetloft
