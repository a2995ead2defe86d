// Classes of a slab: the unions of the links accepted in this slab alone. Two regions of
// one component that only other slabs connect are different classes here, and stay apart.
#pragma once

#include <vector>

#include <tetloft/conforming_section.hpp>

#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

using ClassId = Id<struct ClassTag>;

class SlabClasses {
 public:
  SlabClasses(const ConformingSection& lower, const ConformingSection& upper,
              const std::vector<Link>& links);

  [[nodiscard]] std::size_t class_count() const { return members_.size(); }
  [[nodiscard]] const SlabRegions& regions() const { return regions_; }
  [[nodiscard]] ClassId of_region(SlabRegionId r) const { return class_of_region_[r]; }
  /// Regions of a class, by id.
  [[nodiscard]] const std::vector<SlabRegionId>& regions(ClassId c) const { return members_[c]; }
  /// A class without counterpart in the other plane: a single region.
  [[nodiscard]] bool is_lone(ClassId c) const { return members_[c].size() == 1; }

  /// The class of exterior vertices (completion/pits.hpp), which has no region; invalid without
  /// any.
  [[nodiscard]] ClassId exterior() const { return exterior_; }

  /// Region and class of a slab vertex. Exterior vertices have the region behind the last one.
  [[nodiscard]] SlabRegionId region(SlabVertexId v) const { return region_of_vertex_[v]; }
  [[nodiscard]] ClassId of(SlabVertexId v) const { return class_of_vertex_[v]; }

 private:
  SlabRegions regions_;
  ClassId exterior_;
  IdVector<SlabRegionId, ClassId> class_of_region_;
  IdVector<ClassId, std::vector<SlabRegionId>> members_;
  IdVector<SlabVertexId, SlabRegionId> region_of_vertex_;
  IdVector<SlabVertexId, ClassId> class_of_vertex_;
};

}  // namespace tetloft::internal
