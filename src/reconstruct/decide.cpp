#include "reconstruct/decide.hpp"

#include <utility>

#include "correspondence/drift_links.hpp"
#include "correspondence/overlap_links.hpp"
#include "correspondence/reverse_links.hpp"
#include "reconstruct/stack_errors.hpp"
#include "slab/delaunay.hpp"

namespace tetloft::internal {

Result<Correspondence> Decision::make(const std::vector<SlabId>& slabs, const WatchedWork& work) {
  auto error = first_error(slabs, options_.execution.threads, work,
                           [&](SlabId slab) { return find_candidates(slab); });
  if (!error && options_.correspondence.drift) error = add_drift_links(work);
  if (error) return *error;
  return decide_correspondence(prepared_.stack, prepared_.nestings, candidates_,
                               options_.correspondence.labels);
}

std::optional<Error> Decision::find_candidates(SlabId slab) {
  const SectionId below = lower_section(slab);
  const SectionId above = upper_section(slab);
  if (options_.correspondence.criterion == Criterion::overlap) {
    candidates_[slab] = overlap_links(slab, prepared_.stack.sections[below],
                                      prepared_.nestings[below], prepared_.stack.sections[above],
                                      prepared_.nestings[above], options_.correspondence.tau);
    return std::nullopt;
  }
  const ConformingSection& lower = prepared_.sections[below];
  const ConformingSection& upper = prepared_.sections[above];
  if (lower.vertex_count() == 0 || upper.vertex_count() == 0) return std::nullopt;
  Result<TetMesh> d = slab_delaunay(slab, lower, upper, options_.delaunay, options_.work_limit);
  if (!d) return d.error();
  candidates_[slab] = reverse_links(slab, Slab(lower, upper, std::move(*d)));
  return std::nullopt;
}

std::optional<Error> Decision::add_drift_links(const WatchedWork& work) {
  IdVector<SlabId, std::vector<Link>> further(candidates_.size());
  auto error = first_error(all_ids<SlabId>(candidates_.size()), options_.execution.threads, work,
                           [&](SlabId slab) -> std::optional<Error> {
                             further[slab] =
                                 drift_links(slab, prepared_.stack, prepared_.nestings, candidates_,
                                             *options_.correspondence.drift);
                             return std::nullopt;
                           });
  for (const SlabId slab : candidates_.ids()) {
    candidates_[slab].insert(candidates_[slab].end(), further[slab].begin(), further[slab].end());
  }
  return error;
}

}  // namespace tetloft::internal
