// Candidates by overlap, and the rule as a whole.
#include "check/partition.hpp"

#include <algorithm>
#include <utility>

#include <tetloft/overlap.hpp>

#include "check/box_tree.hpp"

namespace tetloft::internal::checking {

namespace {

Box2 bounds(const Contour& contour) {
  Box2 box{contour.vertices.front(), contour.vertices.front()};
  for (const Point2& p : contour.vertices) box.include({p, p});
  return box;
}

// Boxes of a section's regions: of their outer contours.
std::vector<Box2> region_boxes(const Section& section, const Nesting& nesting) {
  std::vector<Box2> boxes;
  for (const ContourId outer : nesting.outer) boxes.push_back(bounds(section.contours[outer]));
  return boxes;
}

struct Overlap {
  Link link;
  bool strong = false;  // r ≥ kStrongOverlap, 1/4
};

// All pairs of one slab with r > tau.
std::vector<Overlap> overlaps_in_slab(const SectionStack& stack, const Regions& regions,
                                      std::size_t slab, double tau) {
  const Section& below = stack.sections[SectionId(slab)];
  const Section& above = stack.sections[SectionId(slab + 1)];
  const BoxTree upper_boxes(region_boxes(above, regions.nesting[slab + 1]));
  const std::vector<Box2> lower_boxes = region_boxes(below, regions.nesting[slab]);
  std::vector<Overlap> overlaps;
  for (std::size_t r = 0; r < lower_boxes.size(); ++r) {
    const RegionOutline lower = outline(below, regions.nesting[slab], RegionId(r));
    upper_boxes.meeting(lower_boxes[r], [&](std::uint32_t q) {
      const RegionOutline upper = outline(above, regions.nesting[slab + 1], RegionId(q));
      if (compare_overlap(lower, upper, tau) == Sign::positive) {
        const bool strong = compare_overlap(lower, upper, kStrongOverlap) != Sign::negative;
        overlaps.push_back({{regions.first[slab] + r, regions.first[slab + 1] + q}, strong});
      }
      return true;
    });
  }
  return overlaps;
}

}  // namespace

Regions number_regions(const SectionStack& stack) {
  Regions regions;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    regions.nesting.push_back(nest(stack.sections[SectionId(s)]));
    regions.first.push_back(regions.section.size());
    regions.section.insert(regions.section.end(), regions.nesting.back().outer.size(), s);
  }
  regions.first.push_back(regions.section.size());
  return regions;
}

std::vector<Link> overlap_links(const SectionStack& stack, const Regions& regions, double tau) {
  std::vector<Link> links;
  for (std::size_t slab = 0; slab + 1 < stack.sections.size(); ++slab) {
    const std::vector<Overlap> overlaps = overlaps_in_slab(stack, regions, slab, tau);
    // A weak link has no strong one to discount: any strong link of its regions is another.
    std::vector<std::uint8_t> has_strong(regions.size(), 0);
    for (const Overlap& overlap : overlaps) {
      if (!overlap.strong) continue;
      has_strong[overlap.link.lower] = 1;
      has_strong[overlap.link.upper] = 1;
    }
    for (const auto& [link, strong] : overlaps) {
      if (!strong && has_strong[link.lower] != 0 && has_strong[link.upper] != 0) continue;
      links.push_back(link);
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

Result<std::vector<std::optional<std::uint32_t>>> label_regions(const Regions& regions,
                                                                const std::vector<Label>& labels) {
  std::vector<std::optional<std::uint32_t>> of_region(regions.size());
  for (const Label& label : labels) {
    Place place;
    place.section = label.section.index();
    place.contour = label.contour.index();
    if (label.section.index() >= regions.nesting.size() ||
        label.contour.index() >= regions.nesting[label.section.index()].region.size()) {
      return Error{ErrorCode::invalid_input, "a label names a contour that does not exist", place};
    }
    auto& of = of_region[regions.of(label.section.index(), label.contour.index())];
    if (of.has_value() && *of != label.label) {
      return Error{ErrorCode::invalid_input,
                   "two labels, " + std::to_string(*of) + " and " + std::to_string(label.label) +
                       ", in one region",
                   place};
    }
    of = label.label;
  }
  return of_region;
}

Result<ExpectedPartition> expected_partition(const SectionStack& stack, const SectionStack& refined,
                                             const CorrespondenceOptions& options) {
  const Regions regions = number_regions(stack);
  auto label = label_regions(regions, options.labels);
  if (!label.ok()) return label.error();
  std::vector<Link> candidates;
  if (options.criterion == Criterion::overlap) {
    candidates = overlap_links(stack, regions, threshold_of(options));
  } else {
    auto links = reverse_links(refined, regions);
    if (!links.ok()) return links.error();
    candidates = *std::move(links);
  }
  const RegionSets sets = unite_regions(stack, regions, candidates, *label);
  ExpectedPartition expected;
  expected.unrealised = sets.unrealised;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    for (std::size_t c = 0; c < stack.sections[SectionId(s)].contours.size(); ++c) {
      expected.set.push_back(sets.set[regions.of(s, c)]);
    }
  }
  return expected;
}

}  // namespace tetloft::internal::checking
