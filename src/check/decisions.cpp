// Rule 4, what the user decided on single links; and rule 8, what a model says it could not
// realise.
#include <algorithm>
#include <utility>

#include "check/partition.hpp"

namespace tetloft::internal::checking {

namespace {

// The link of the regions that contour `lower` of section s and `upper` of the next one bound.
std::optional<Link> link_of(const Regions& regions, SlabId slab, ContourId lower, ContourId upper) {
  const std::size_t s = slab.index();
  if (!slab.valid() || s + 1 >= regions.section_count()) return std::nullopt;
  if (lower.index() >= regions.nesting[s].region.size()) return std::nullopt;
  if (upper.index() >= regions.nesting[s + 1].region.size()) return std::nullopt;
  return Link{regions.of(s, lower.index()), regions.of(s + 1, upper.index())};
}

// Why a link may not have been dropped, or nothing.
const char* objection_to_dropping(const Regions& regions, const Link& link,
                                  const std::vector<Candidate>& candidates) {
  const auto candidate =
      std::lower_bound(candidates.begin(), candidates.end(), link,
                       [](const Candidate& c, const Link& other) { return c.link < other; });
  if (candidate == candidates.end() || candidate->link != link) return "it is no candidate";
  if (candidate->joined) return "a decision joins it";
  if (regions.distance(link).value() == 0) return "the regions meet";
  return nullptr;
}

}  // namespace

Result<DecidedLinks> decided_links(const Regions& regions,
                                   const std::vector<LinkDecision>& decisions) {
  DecidedLinks decided;
  for (const LinkDecision& decision : decisions) {
    Place place;
    place.section = decision.slab.index();
    place.contour = decision.lower.index();
    const auto link = link_of(regions, decision.slab, decision.lower, decision.upper);
    if (!link.has_value()) {
      return Error{ErrorCode::invalid_input, "a decision names a contour that does not exist",
                   place};
    }
    (decision.join ? decided.joined : decided.parted).insert(*link);
    if (decided.joined.count(*link) != 0 && decided.parted.count(*link) != 0) {
      return Error{ErrorCode::invalid_input, "decisions both join and part its region and another",
                   place};
    }
  }
  return decided;
}

DroppedLinks dropped_links(const Regions& regions, std::span<const RegionLink> claims,
                           const std::vector<Candidate>& candidates) {
  DroppedLinks dropped;
  for (const RegionLink& claim : claims) {
    if (claim.fate != LinkFate::unrealisable) continue;
    const auto wrong = [&](const char* why) {
      dropped.wrong.push_back("link in slab " + std::to_string(claim.slab.index()) + ", contours " +
                              std::to_string(claim.lower.index()) + " and " +
                              std::to_string(claim.upper.index()) + ": " + why);
    };
    const auto link = link_of(regions, claim.slab, claim.lower, claim.upper);
    const std::size_t s = claim.slab.index();
    if (!link.has_value() || !regions.is_outer(s, claim.lower.index()) ||
        !regions.is_outer(s + 1, claim.upper.index())) {
      wrong("no such outer contours");
    } else if (dropped.links.count(*link) != 0) {
      wrong("told twice");
    } else if (const char* why = objection_to_dropping(regions, *link, candidates)) {
      wrong(why);
    } else {
      dropped.links.insert(*link);
    }
  }
  return dropped;
}

}  // namespace tetloft::internal::checking
