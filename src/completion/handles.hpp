// Handles that no link implies are filled: tunnels through the solid of a class that completion
// left open though its void needs them not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "completion/chi_groups.hpp"
#include "completion/completion.hpp"
#include "completion/slab_voids.hpp"

namespace tetloft::internal {

/// Which voids hang together through what a complex leaves empty: of each the lowest it does with.
[[nodiscard]] std::vector<SlabVoidId> joined_voids(const Slab& slab, const SlabClasses& classes,
                                                   const SlabVoids& voids, const Complex& complex);

/// What a completion's complex is like, computed when first asked for.
class ComplexState {
 public:
  /// All must outlive this.
  ComplexState(const ChiGroups& groups, const SlabVoids& voids, Completion& completion)
      : groups_(groups), voids_(voids), completion_(completion) {}

  [[nodiscard]] const ChiGroups& groups() const { return groups_; }
  [[nodiscard]] const SlabVoids& voids() const { return voids_; }
  [[nodiscard]] const Completion& completion() const { return completion_; }
  [[nodiscard]] const ChiGroups::Sums& sums();
  [[nodiscard]] const std::vector<SlabVoidId>& joined();

  /// Keeps the walls, and what the rules want besides, if that brings groups nearer to their ranges
  /// and parts no voids that hung together: by how much nearer; 0 if nothing was kept.
  std::int32_t try_walls(const std::vector<Wall>& walls);

 private:
  const ChiGroups& groups_;
  const SlabVoids& voids_;
  Completion& completion_;
  std::optional<ChiGroups::Sums> sums_;
  std::optional<std::vector<SlabVoidId>> joined_;
};

/// Keeps tets, the smallest first, each of which brings the characteristics of a group that is
/// below its range nearer to it. Returns how many handles went.
std::uint64_t fill_handles(ComplexState& state);

}  // namespace tetloft::internal
