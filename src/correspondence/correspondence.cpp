// The decision over the whole stack: union–find over regions, labels respected.
#include "correspondence/correspondence.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <tetloft/overlap.hpp>

#include "core/sort_distinct.hpp"
#include "correspondence/label_connector.hpp"
#include "correspondence/labelled_sets.hpp"

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

// Candidates in order of decreasing evidence.
std::vector<Link> by_evidence(const SectionStack& stack,
                              const IdVector<SectionId, Nesting>& nestings,
                              const IdVector<SlabId, std::vector<Link>>& candidates) {
  std::vector<std::pair<double, Link>> ranked;
  for (const std::vector<Link>& slab : candidates) {
    for (const Link& link : slab) {
      const SectionId below = lower_section(link.slab);
      const SectionId above = upper_section(link.slab);
      const double ratio =
          overlap_ratio(outline(stack.sections[below], nestings[below], link.lower),
                        outline(stack.sections[above], nestings[above], link.upper));
      ranked.emplace_back(-ratio, link);
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<Link> links;
  links.reserve(ranked.size());
  for (const auto& entry : ranked) links.push_back(entry.second);
  return links;
}

}  // namespace

Result<Correspondence> decide_correspondence(const SectionStack& stack,
                                             const IdVector<SectionId, Nesting>& nestings,
                                             const IdVector<SlabId, std::vector<Link>>& candidates,
                                             const std::vector<Label>& labels) {
  const StackRegions regions(nestings);
  const Result<RegionLabels> region_labels = labels_of_regions(nestings, regions, labels);
  if (!region_labels) return region_labels.error();
  LabelledSets sets(*region_labels);

  std::vector<Link> accepted;
  if (labels.empty()) {
    for (const std::vector<Link>& slab : candidates) {
      accepted.insert(accepted.end(), slab.begin(), slab.end());
    }
    for (const Link& link : accepted) sets.unite(regions.below(link), regions.above(link));
  } else {
    for (const Link& link : by_evidence(stack, nestings, candidates)) {
      const StackRegionId below = regions.below(link);
      const StackRegionId above = regions.above(link);
      if (!sets.may_unite(below, above)) continue;
      sets.unite(below, above);
      accepted.push_back(link);
    }
    if (Result<void> connected =
            connect_labels(stack, nestings, regions, *region_labels, sets, accepted);
        !connected) {
      return connected.error();
    }
  }

  Correspondence result;
  result.links.resize(candidates.size());
  sort_distinct(accepted);
  for (const Link& link : accepted) result.links[link.slab].push_back(link);

  // Components in order of their first contour.
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
  return result;
}

}  // namespace tetloft::internal
