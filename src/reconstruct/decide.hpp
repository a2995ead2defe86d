// Phase 1, decide: which regions belong together, over the whole stack.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "correspondence/correspondence.hpp"
#include "motion/region_motions.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

class Decision {
 public:
  /// Both must outlive this. The stack's sections must be conforming with `reverse`, not else.
  Decision(const PreparedStack& prepared, const ReconstructOptions& options);

  /// The correspondence, looking for candidates in these slabs anew (all, the first time).
  [[nodiscard]] Result<Correspondence> make(const std::vector<SlabId>& slabs,
                                            const WatchedWork& work);
  /// The same once more, without this link: rule 8.
  [[nodiscard]] Result<Correspondence> make_without(const Link& link);

  /// Does it depend on how sections were conformed?
  [[nodiscard]] bool depends_on_triangulations() const {
    return options_.correspondence.criterion == Criterion::reverse;
  }
  /// By `moved`: the motions that are not 0, in the unit of the prepared stack.
  [[nodiscard]] std::vector<RegionMotion> motions() const;

 private:
  [[nodiscard]] std::optional<Error> find_by_criterion(SlabId slab);
  [[nodiscard]] std::optional<Error> find_reverse(SlabId slab);
  // Rules 2 and 3.
  [[nodiscard]] std::optional<Error> find_chains(const WatchedWork& work);
  [[nodiscard]] std::optional<Error> find_lone(const WatchedWork& work);
  [[nodiscard]] Result<Correspondence> decide() const;

  const PreparedStack& prepared_;
  const ReconstructOptions& options_;
  StackSections sections_;
  IdVector<SlabId, SlabMotions> motions_;
  StackCandidates by_criterion_;
  StackCandidates candidates_;  // of rules 1 to 3
  std::set<Link> dropped_;
};

}  // namespace tetloft::internal
