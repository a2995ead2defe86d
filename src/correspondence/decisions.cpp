#include "correspondence/decisions.hpp"

#include <limits>
#include <map>
#include <string>
#include <utility>

#include "correspondence/region_names.hpp"
#include "correspondence/void_links.hpp"

namespace tetloft::internal {

namespace {

Error decision_error(std::size_t section, ContourId contour, std::string message) {
  Place place;
  place.section = section;
  place.contour = contour.index();
  return {ErrorCode::invalid_input, std::move(message), place};
}

Result<Link> link_of(const IdVector<SectionId, Nesting>& nestings, const LinkDecision& decision) {
  if (decision.slab.index() + 1 >= nestings.size()) {
    return decision_error(decision.slab.index(), decision.lower,
                          "the decision names a section that does not exist, or has none above");
  }
  const SectionId below = lower_section(decision.slab);
  const SectionId above = upper_section(decision.slab);
  for (const auto& [section, contour] :
       {std::pair(below, decision.lower), std::pair(above, decision.upper)}) {
    if (contour.index() >= nestings[section].region.size()) {
      return decision_error(section.index(), contour,
                            "the decision names a contour that does not exist");
    }
  }
  return Link{decision.slab, nestings[below].region[decision.lower],
              nestings[above].region[decision.upper]};
}

}  // namespace

LinkCandidate asked_for(const Link& link, const StackSections& sections, Evidence evidence,
                        bool voids) {
  const SectionRegions& below = sections[lower_section(link.slab)];
  const SectionRegions& above = sections[upper_section(link.slab)];
  LinkCandidate candidate{link, evidence};
  candidate.ratio = candidate.moved =
      voids ? void_ratio(below, link.lower, above, link.upper)
            : overlap_ratio(below.outline[link.lower], above.outline[link.upper]);
  candidate.distance =
      gaps_apart(below, link.lower, above, link.upper, std::numeric_limits<double>::infinity())
          .value_or(0);
  candidate.margin = 1;
  return candidate;
}

Result<std::set<Link>> apply_decisions(const IdVector<SectionId, Nesting>& nestings,
                                       const StackSections& sections,
                                       const std::vector<LinkDecision>& decisions,
                                       StackCandidates& candidates, bool voids) {
  const RegionNames names(nestings, voids);
  std::map<Link, bool> joined;
  for (const LinkDecision& decision : decisions) {
    const Result<Link> link = link_of(nestings, decision);
    if (!link) return link.error();
    const auto [at, fresh] = joined.try_emplace(*link, decision.join);
    if (!fresh && at->second != decision.join) {
      return Error{ErrorCode::invalid_input,
                   "it is both joined to and parted from " +
                       names.of(upper_section(link->slab), link->upper) +
                       " of the section above, or their " + names.many() + " are",
                   names.place(lower_section(link->slab), link->lower)};
    }
  }
  std::set<Link> parted;
  for (const auto& [link, join] : joined) {
    SlabCandidates& of_slab = candidates[link.slab];
    if (join) {
      add_candidate(of_slab, asked_for(link, sections, Evidence::decision, voids));
      continue;
    }
    parted.insert(link);
    if (LinkCandidate* const known = find_candidate(of_slab, link)) {
      known->fate = LinkFate::decided_part;
    } else {
      LinkCandidate decided = asked_for(link, sections, Evidence::decision, voids);
      decided.fate = LinkFate::decided_part;
      add_candidate(of_slab, decided);
    }
  }
  return parted;
}

}  // namespace tetloft::internal
