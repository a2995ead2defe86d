// Phase 1, decide: which regions belong together, over the whole stack.
#pragma once

#include <optional>
#include <vector>

#include "correspondence/correspondence.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

class Decision {
 public:
  /// Both must outlive this.
  Decision(const PreparedStack& prepared, const ReconstructOptions& options)
      : prepared_(prepared), options_(options), candidates_(prepared.slab_count()) {}

  /// The correspondence, looking for candidates in these slabs anew (all, the first time).
  [[nodiscard]] Result<Correspondence> make(const std::vector<SlabId>& slabs,
                                            const WatchedWork& work);

  /// Does it depend on how sections were conformed?
  [[nodiscard]] bool depends_on_triangulations() const {
    return options_.correspondence.criterion == Criterion::reverse;
  }

 private:
  [[nodiscard]] std::optional<Error> find_candidates(SlabId slab);
  [[nodiscard]] std::optional<Error> add_drift_links(const WatchedWork& work);

  const PreparedStack& prepared_;
  const ReconstructOptions& options_;
  IdVector<SlabId, std::vector<Link>> candidates_;
};

}  // namespace tetloft::internal
