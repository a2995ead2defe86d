// The API of links: decides as a reconstruction does, and builds nothing.
#include <tetloft/links.hpp>

#include <algorithm>

#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/unit_of_length.hpp"
#include "core/watched_work.hpp"
#include "correspondence/link_report.hpp"
#include "model/sureness.hpp"
#include "reconstruct/decide.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/prepare.hpp"
#include "reconstruct/stack_errors.hpp"

namespace tetloft {

using namespace internal;

namespace {

Result<StackLinks> links_of(const SectionStack& stack, const ReconstructOptions& options) {
  Result<void> sensible = check_correspondence_options(options.correspondence);
  if (!sensible) return sensible.error();
  WatchedWork work(options.execution, 0);
  const bool reverse = options.correspondence.criterion == Criterion::reverse;
  Result<PreparedStack> prepared =
      prepare(stack, Unit::of_the_stack, options, work, reverse ? Conform::all : Conform::none);
  if (!prepared) return prepared.error();
  Decision decision(*prepared, options);
  Result<Correspondence> decided = decision.make(all_ids<SlabId>(prepared->slab_count()), work);
  if (!decided) return decided.error();
  StackLinks result;
  result.links = region_links(decided->candidates, prepared->nestings);
  if (auto hint = hint_of_missing_partners(*prepared, decided->candidates)) {
    result.warnings.push_back(*std::move(hint));
  }
  result.motions = decision.motions();
  for (RegionMotion& motion : result.motions) motion.by = scaled(motion.by, -prepared->exponent);
  VoidDecision void_decision(*prepared, options);
  const Result<std::optional<Correspondence>> voids = void_decision.make(decided->links, work);
  if (!voids) return voids.error();
  if (*voids) {
    result.void_links = void_decision.links(**voids);
    result.cavities = cavities(**voids);
  }
  result.partition = std::move(decided->partition);
  for (const auto& section : result.partition) {
    for (const ComponentId id : section) {
      result.components = std::max(result.components, id.index() + 1);
    }
  }
  return result;
}

template <class Links>
void sort_by_sureness(Links& links) {
  std::stable_sort(links.begin(), links.end(), [](const RegionLink& a, const RegionLink& b) {
    return sureness(a) < sureness(b);
  });
}

}  // namespace

Result<StackLinks> find_links(const SectionStack& stack, const LinkOptions& given_options) {
  ReconstructOptions asked;
  asked.correspondence = given_options.correspondence;
  asked.execution = given_options.execution;
  return guard_threads(asked,
                       [&](const ReconstructOptions& options) { return links_of(stack, options); });
}

std::vector<RegionLink> least_sure_first(std::vector<RegionLink> links) {
  sort_by_sureness(links);
  return links;
}

std::vector<VoidLink> least_sure_first(std::vector<VoidLink> links) {
  sort_by_sureness(links);
  return links;
}

}  // namespace tetloft
