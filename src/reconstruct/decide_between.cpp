#include "reconstruct/decide_between.hpp"

#include "between/sections_between.hpp"
#include "reconstruct/stack_errors.hpp"

namespace tetloft::internal {

std::optional<Error> decide_between(const PreparedStack& prepared,
                                    const ReconstructOptions& options,
                                    const std::vector<SlabId>& slabs, const WatchedWork& work,
                                    Plan& plan) {
  plan.between.resize(prepared.slab_count());
  if (options.between == 0) return std::nullopt;
  const LinkedStack linked{prepared.stack, prepared.nestings, plan.correspondence.links};
  return first_error(slabs, options.execution.threads, work,
                     [&](SlabId slab) -> std::optional<Error> {
                       plan.between[slab] = sections_between(linked, slab, options.between);
                       return std::nullopt;
                     });
}

}  // namespace tetloft::internal
