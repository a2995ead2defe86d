// The decision over the whole stack: union–find over regions, labels respected.
#include "correspondence/correspondence.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/sort_distinct.hpp"
#include "correspondence/decisions.hpp"
#include "correspondence/label_connector.hpp"
#include "correspondence/labelled_sets.hpp"
#include "correspondence/region_names.hpp"
#include "sections/complement.hpp"

namespace tetloft::internal {

namespace {

Error label_error(const Label& label, std::string message) {
  Place place;
  place.section = label.section.index();
  place.contour = label.contour.index();
  return {ErrorCode::invalid_input, std::move(message), place};
}

Result<RegionLabels> labels_of_regions(const IdVector<SectionId, Nesting>& nestings,
                                       const StackRegions& regions,
                                       const std::vector<Label>& labels) {
  RegionLabels result(regions.size());
  for (const Label& label : labels) {
    if (label.section.index() >= nestings.size()) {
      return label_error(label, "the label names a section that does not exist");
    }
    const Nesting& nesting = nestings[label.section];
    if (label.contour.index() >= nesting.region.size()) {
      return label_error(label, "the label names a contour that does not exist");
    }
    auto& slot = result[regions.of(label.section, nesting.region[label.contour])];
    if (slot && *slot != label.label) {
      return label_error(label, "two labels, " + std::to_string(*slot) + " and " +
                                    std::to_string(label.label) +
                                    ", on contours of one connected region");
    }
    slot = label.label;
  }
  return result;
}

// The candidates that are to be accepted: what the user joined first, then by decreasing score.
std::vector<LinkCandidate*> by_evidence(StackCandidates& candidates) {
  std::vector<LinkCandidate*> made;
  for (SlabCandidates& slab : candidates) {
    for (LinkCandidate& candidate : slab) {
      if (candidate.made()) made.push_back(&candidate);
    }
  }
  std::stable_sort(made.begin(), made.end(), [](const LinkCandidate* a, const LinkCandidate* b) {
    const bool joined_a = a->evidence == Evidence::decision;
    const bool joined_b = b->evidence == Evidence::decision;
    if (joined_a != joined_b) return joined_a;
    return !joined_a && a->score() > b->score();
  });
  return made;
}

// Rules 5 and 6. The error of a joined pair of different labels.
Result<void> accept(StackCandidates& candidates, const StackRegions& regions,
                    const RegionNames& names, LabelledSets& sets, std::vector<Link>& accepted) {
  for (LinkCandidate* const candidate : by_evidence(candidates)) {
    const Link& link = candidate->link;
    const StackRegionId below = regions.below(link);
    const StackRegionId above = regions.above(link);
    if (sets.may_unite(below, above)) {
      sets.unite(below, above);
      accepted.push_back(link);
      continue;
    }
    if (candidate->evidence == Evidence::decision) {
      return Error{ErrorCode::invalid_input,
                   "a decision joins this to " + names.of(upper_section(link.slab), link.upper) +
                       " of the section above, and labels, " + std::to_string(*sets.label(below)) +
                       " and " + std::to_string(*sets.label(above)) + ", part them",
                   names.place(lower_section(link.slab), link.lower)};
    }
    candidate->fate = LinkFate::labels_part;
  }
  return {};
}

void unite_exteriors(const StackRegions& regions, std::size_t slabs, LabelledSets& sets,
                     std::vector<Link>& accepted) {
  for (const SlabId slab : IdRange<SlabId>(slabs)) {
    const Link link{slab, sections::kExterior, sections::kExterior};
    sets.unite(regions.below(link), regions.above(link));
    accepted.push_back(link);
  }
}

// Components, in order of their first contour.
void number_components(const IdVector<SectionId, Nesting>& nestings, const StackRegions& regions,
                       const LabelledSets& sets, Correspondence& result) {
  IdVector<StackRegionId, ComponentId> component_of(regions.size());
  std::size_t components = 0;
  result.component.resize(nestings.size());
  result.partition.resize(nestings.size());
  for (std::size_t s = 0; s < nestings.size(); ++s) {
    const Nesting& nesting = nestings[SectionId(s)];
    auto& of_region = result.component[SectionId(s)];
    auto& of_contour = result.partition[SectionId(s)];
    of_region.resize(nesting.outer.size());
    of_contour.resize(nesting.region.size());
    for (std::size_t c = 0; c < nesting.region.size(); ++c) {
      const RegionId region = nesting.region[ContourId(c)];
      ComponentId& id = component_of[sets.find(regions.of(SectionId(s), region))];
      if (!id.valid()) id = ComponentId(components++);
      of_region[region] = id;
      of_contour[ContourId(c)] = id;
    }
  }
}

}  // namespace

Result<Correspondence> decide_correspondence(const SectionStack& stack,
                                             const IdVector<SectionId, Nesting>& nestings,
                                             const StackSections& sections,
                                             StackCandidates candidates, const Asked& asked,
                                             const std::set<Link>& dropped) {
  const StackRegions regions(nestings);
  const RegionNames names(nestings, asked.voids);
  const Result<RegionLabels> region_labels = labels_of_regions(nestings, regions, asked.labels);
  if (!region_labels) return region_labels.error();
  LabelledSets sets(*region_labels);
  Result<std::set<Link>> closed =
      apply_decisions(nestings, sections, asked.decisions, candidates, asked.voids);
  if (!closed) return closed.error();
  for (SlabCandidates& slab : candidates) {
    for (LinkCandidate& candidate : slab) {
      if (candidate.made() && dropped.contains(candidate.link)) {
        candidate.fate = LinkFate::unrealisable;
      }
    }
  }
  closed->insert(dropped.begin(), dropped.end());

  std::vector<Link> accepted;
  if (asked.voids) unite_exteriors(regions, candidates.size(), sets, accepted);
  if (Result<void> good = accept(candidates, regions, names, sets, accepted); !good) {
    return good.error();
  }
  if (!asked.labels.empty()) {
    const std::size_t before = accepted.size();
    if (Result<void> connected = connect_labels(stack, nestings, regions, *region_labels, names,
                                                *closed, sets, accepted);
        !connected) {
      return connected.error();
    }
    for (std::size_t k = before; k < accepted.size(); ++k) {
      add_candidate(candidates[accepted[k].slab],
                    asked_for(accepted[k], sections, Evidence::label, asked.voids));
    }
  }

  Correspondence result;
  result.links.resize(candidates.size());
  result.candidates = std::move(candidates);
  sort_distinct(accepted);
  for (const Link& link : accepted) result.links[link.slab].push_back(link);

  number_components(nestings, regions, sets, result);
  return result;
}

}  // namespace tetloft::internal
