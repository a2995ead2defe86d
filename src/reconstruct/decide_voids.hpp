// Phase 1, decide: which voids belong together, over the whole stack. The rule:
// include/tetloft/voids.hpp.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <tetloft/voids.hpp>

#include "correspondence/correspondence.hpp"
#include "reconstruct/prepare.hpp"
#include "sections/face_overlay.hpp"

namespace tetloft::internal {

[[nodiscard]] bool has_hole(const Nesting& nesting);

class VoidDecision {
 public:
  /// Both must outlive this.
  VoidDecision(const PreparedStack& prepared, const ReconstructOptions& options);

  /// The correspondence of voids, as of the regions of complements: of each section region 0 is the
  /// exterior, and the last contour the frame of all. Nothing by VoidRule::free.
  /// Refused: invalid_input for labels and decisions that name no hole, or contradict each other;
  /// unrepresentable for labels that cannot be realised.
  /// `of_regions`: their accepted links, sorted.
  [[nodiscard]] Result<std::optional<Correspondence>> make(
      const IdVector<SlabId, std::vector<Link>>& of_regions, const WatchedWork& work);
  /// The overlay of each slab that make() had to look at, without its plane.
  [[nodiscard]] IdVector<SlabId, std::optional<sections::FaceOverlay>> take_overlays() {
    return std::move(overlays_);
  }

  /// Of the complements; none by VoidRule::free, nor of a stack without holes.
  [[nodiscard]] const IdVector<SectionId, Nesting>& complements() const { return nestings_; }
  /// The candidates of a correspondence made by this, as their user sees them.
  [[nodiscard]] std::vector<VoidLink> links(const Correspondence& correspondence) const;

 private:
  [[nodiscard]] std::optional<Error> find(const IdVector<SlabId, std::vector<Link>>& of_regions,
                                          const WatchedWork& work, StackCandidates& candidates);

  const PreparedStack& prepared_;
  const ReconstructOptions& options_;
  // Complements; none by VoidRule::free, nor of a stack without holes.
  SectionStack stack_;
  IdVector<SectionId, Nesting> nestings_;
  StackSections sections_;
  IdVector<SlabId, std::optional<sections::FaceOverlay>> overlays_;
};

/// Components of voids but those that are open: to the exterior, or, in the first or last section,
/// at the end of the model.
[[nodiscard]] std::size_t cavities(const Correspondence& of_voids);

}  // namespace tetloft::internal
