// The voids of a slab with sections between: which hang together from layer to layer, so that those
// of the slab's own sections do as its links say.
#pragma once

#include <optional>
#include <vector>

#include "core/union_find.hpp"
#include "correspondence/candidate.hpp"
#include "reconstruct/inner_links.hpp"
#include "reconstruct/layer_numbering.hpp"
#include "reconstruct/slab_solid.hpp"
#include "sections/face_overlay.hpp"
#include "slab/link.hpp"

namespace tetloft::internal {

/// Links of a slab's voids as its solid has them.
struct RealisedVoids {
  std::vector<Link> links, unrealised;
  /// As SlabSolid::united_voids.
  std::vector<Inseparable> united;
};

class LayeredVoids {
 public:
  /// `links`: of the voids of the slab's sections. All must outlive this.
  LayeredVoids(const Layers& layers, const std::vector<Link>& links);

  /// Links of voids in each slab between: those of the rule (tetloft/voids.hpp) in the stack of the
  /// layers, surest first, but for what would join voids that the slab's links do not. Nothing if
  /// the rule refuses.
  [[nodiscard]] std::optional<IdVector<SlabId, std::vector<Link>>> decide(
      const IdVector<SlabId, std::vector<Link>>& of_regions);
  /// What deciding has seen of the faces of a slab between, without their plane; null if nothing.
  [[nodiscard]] const sections::FaceOverlay* faces(SlabId slab) const {
    return overlays_.empty() || !overlays_[slab] ? nullptr : &*overlays_[slab];
  }

  /// What of the slab's links these solids have, or, without any, what they have at best; `links`:
  /// as decided. Nothing where voids of two classes hang together, or some without any of the
  /// slab's own.
  [[nodiscard]] std::optional<RealisedVoids> realised(
      const IdVector<SlabId, std::vector<Link>>& links,
      const std::vector<std::optional<SlabSolid>>& solids) const;

 private:
  [[nodiscard]] std::size_t last() const { return layers_.size() - 1; }
  [[nodiscard]] std::size_t none() const { return numbering_.size(); }
  [[nodiscard]] IdVector<SlabId, std::vector<Link>> parted(StackCandidates candidates) const;

  [[nodiscard]] RealisedVoids compare(const UnionFind& got) const;

  const Layers& layers_;
  const std::vector<Link>& links_;
  LayerNumbering numbering_;
  /// By void: the class it has by the slab's links, none() between.
  std::vector<std::size_t> class_of_;
  IdVector<SlabId, std::optional<sections::FaceOverlay>> overlays_;
};

}  // namespace tetloft::internal
