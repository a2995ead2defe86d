#include "reconstruct/decide.hpp"

#include <utility>

#include "correspondence/chain_links.hpp"
#include "correspondence/decisions.hpp"
#include "correspondence/lone_links.hpp"
#include "correspondence/moved_links.hpp"
#include "correspondence/overlap_links.hpp"
#include "correspondence/reverse_links.hpp"
#include "reconstruct/section_uses.hpp"
#include "reconstruct/stack_errors.hpp"
#include "slab/delaunay.hpp"

namespace tetloft::internal {

Decision::Decision(const PreparedStack& prepared, const ReconstructOptions& options)
    : prepared_(prepared),
      options_(options),
      motions_(prepared.slab_count()),
      by_criterion_(prepared.slab_count()) {
  sections_.reserve(prepared.section_count());
  for (const SectionId s : prepared.nestings.ids()) {
    sections_.push_back(SectionRegions(prepared.stack.sections[s], prepared.nestings[s]));
  }
}

Result<Correspondence> Decision::make(const std::vector<SlabId>& slabs, const WatchedWork& work) {
  SectionUses uses(sections_.size(), slabs);
  auto error = first_error(slabs, options_.execution.threads, work, [&](SlabId slab) {
    auto failed = find_by_criterion(slab);
    uses.done(slab, [&](SectionId s) { sections_[s].forget_edges(); });
    return failed;
  });
  candidates_ = by_criterion_;
  const CorrespondenceOptions& rule = options_.correspondence;
  if (rule.criterion != Criterion::reverse) {
    if (!error && rule.chain) error = find_chains(work);
    if (!error && rule.lone) error = find_lone(work);
    forget_edges(sections_);
  }
  if (error) return *error;
  return decide();
}

Result<Correspondence> Decision::make_without(const Link& link) {
  dropped_.insert(link);
  return decide();
}

Result<Correspondence> Decision::decide() const {
  const CorrespondenceOptions& rule = options_.correspondence;
  return decide_correspondence(prepared_.stack, prepared_.nestings, sections_, candidates_,
                               {rule.labels, rule.decisions}, dropped_);
}

std::optional<Error> Decision::find_by_criterion(SlabId slab) {
  const SectionRegions& below = sections_[lower_section(slab)];
  const SectionRegions& above = sections_[upper_section(slab)];
  const double tau = threshold_of(options_.correspondence);
  switch (options_.correspondence.criterion) {
    case Criterion::reverse: return find_reverse(slab);
    case Criterion::overlap: by_criterion_[slab] = overlap_links(slab, below, above, tau); break;
    case Criterion::moved: {
      const std::vector<OverlappingPair> overlapping = overlapping_pairs(below, above);
      motions_[slab] = motions_where_unclear(slab, prepared_.stack, prepared_.nestings, below,
                                             above, overlapping);
      by_criterion_[slab] = moved_links(slab, below, above, overlapping, motions_[slab], tau);
      break;
    }
  }
  return std::nullopt;
}

std::optional<Error> Decision::find_reverse(SlabId slab) {
  const ConformingSection& lower = prepared_.sections[lower_section(slab)];
  const ConformingSection& upper = prepared_.sections[upper_section(slab)];
  by_criterion_[slab].clear();
  if (lower.vertex_count() == 0 || upper.vertex_count() == 0) return std::nullopt;
  Result<SlabDelaunay> d =
      slab_delaunay(slab, lower, upper, options_.delaunay, options_.work_limit);
  if (!d) return d.error();
  for (const Link& link : reverse_links(slab, Slab(lower, upper, std::move(*d)))) {
    LinkCandidate candidate = asked_for(link, sections_, Evidence::reverse);
    candidate.margin = candidate.ratio;
    by_criterion_[slab].push_back(candidate);
  }
  return std::nullopt;
}

std::optional<Error> Decision::find_chains(const WatchedWork& work) {
  StackCandidates further(candidates_.size());
  auto error = first_error(all_ids<SlabId>(candidates_.size()), options_.execution.threads, work,
                           [&](SlabId slab) -> std::optional<Error> {
                             further[slab] = chain_links(slab, sections_, by_criterion_);
                             return std::nullopt;
                           });
  for (const SlabId slab : candidates_.ids()) {
    for (const LinkCandidate& link : further[slab]) add_candidate(candidates_[slab], link);
  }
  return error;
}

std::optional<Error> Decision::find_lone(const WatchedWork& work) {
  IdVector<SectionId, std::vector<LinkCandidate>> further(sections_.size());
  auto error = first_error(all_ids<SectionId>(sections_.size()), options_.execution.threads, work,
                           [&](SectionId section) -> std::optional<Error> {
                             further[section] =
                                 lone_links(section, sections_, candidates_, motions_);
                             return std::nullopt;
                           });
  for (const auto& of_section : further) {
    for (const LinkCandidate& link : of_section) add_candidate(candidates_[link.link.slab], link);
  }
  return error;
}

std::vector<RegionMotion> Decision::motions() const {
  std::vector<RegionMotion> motions;
  for (const SlabId slab : motions_.ids()) {
    for (const bool upper : {false, true}) {
      const auto& of_regions = upper ? motions_[slab].upper : motions_[slab].lower;
      const Nesting& nesting = prepared_.nestings[section_of(slab, upper)];
      for (const RegionId r : of_regions.ids()) {
        const std::optional<Point2>& by = of_regions[r];
        if (by && (by->x != 0 || by->y != 0)) {
          motions.push_back({slab, upper, nesting.outer[r], *by});
        }
      }
    }
  }
  return motions;
}

}  // namespace tetloft::internal
