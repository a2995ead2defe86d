// The voids of a slab as its two sections have them, and their classes: what links of voids unite
// in this slab (include/tetloft/voids.hpp).
#pragma once

#include <array>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "core/union_find.hpp"
#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

/// A void of a slab: of its lower section, then of its upper one, each the exterior first and then
/// holes by their lowest vertices, as sections/complement.hpp numbers them.
using SlabVoidId = Id<struct SlabVoidTag>;
using SlabVoidNumbering = SlabNumbering<RegionId, SlabVoidId>;
/// A void class of a slab: 0 is that of the exteriors.
using VoidClassId = Id<struct VoidClassTag>;

/// The voids of a section: the holes that name them, the exterior first; and the void that each
/// contour bounds, on its outer side or, of a hole, its inner one.
struct SectionVoids {
  std::vector<ContourId> hole{ContourId()};
  IdVector<ContourId, RegionId> of_contour;
};
[[nodiscard]] SectionVoids voids_of(const ConformingSection& section);

class SlabVoids {
 public:
  /// Of links, `lower` and `upper` are voids. The exteriors are linked in any case. Sections may
  /// have exterior vertices (pits.hpp).
  SlabVoids(const ConformingSection& lower, const ConformingSection& upper,
            const std::vector<Link>& links);

  [[nodiscard]] std::size_t void_count() const { return numbering_.size(); }
  [[nodiscard]] std::size_t class_count() const { return class_count_; }
  [[nodiscard]] const SlabVoidNumbering& numbering() const { return numbering_; }
  [[nodiscard]] VoidClassId class_of(SlabVoidId v) const { return class_of_[v]; }
  /// The hole that names a void; invalid for the exterior.
  [[nodiscard]] ContourId hole(SlabVoidId v) const { return hole_[v]; }

  /// The void that an external triangle lies in; invalid for an internal one.
  [[nodiscard]] SlabVoidId at(bool upper, TriangleId t) const {
    return of_triangle_[upper ? 1 : 0][t];
  }
  /// The void that an external edge of a section lies in.
  [[nodiscard]] SlabVoidId at(bool upper, const ConformingSection::Edge& edge) const {
    return at(upper, edge.left.valid() ? edge.left : edge.right);
  }
  [[nodiscard]] SlabVoidId exterior(bool upper) const {
    return numbering_.in_slab(upper, RegionId(0));
  }

  /// Makes one class of those of two voids, since nothing can part them.
  void unite(SlabVoidId a, SlabVoidId b);

 private:
  void number_classes();

  SlabVoidNumbering numbering_;
  IdVector<SlabVoidId, ContourId> hole_;
  UnionFind sets_;
  IdVector<SlabVoidId, VoidClassId> class_of_;
  std::size_t class_count_ = 0;
  std::array<IdVector<TriangleId, SlabVoidId>, 2> of_triangle_;
};

}  // namespace tetloft::internal
