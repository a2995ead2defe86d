// The links of small stacks, as pairs of regions.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/links.hpp>
#include <tetloft/nesting.hpp>

#include "correspondence/section_regions.hpp"

namespace tetloft::testing {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

inline IdVector<SectionId, Nesting> nestings_of(const SectionStack& stack) {
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  return nestings;
}

/// The stack and the nestings must outlive the result.
inline internal::StackSections sections_of(const SectionStack& stack,
                                           const IdVector<SectionId, Nesting>& nestings) {
  internal::StackSections sections;
  for (const SectionId s : nestings.ids()) {
    sections.push_back(internal::SectionRegions(stack.sections[s], nestings[s]));
  }
  return sections;
}

/// All links of a slab with this evidence and fate, by region, sorted.
inline Pairs links_of(const SectionStack& stack, std::size_t slab,
                      const CorrespondenceOptions& options, Evidence evidence,
                      LinkFate fate = LinkFate::made) {
  const Result<StackLinks> found = find_links(stack, {options, {.threads = 1}});
  if (!found) {
    ADD_FAILURE() << to_string(found.error());
    return {};
  }
  const Nesting below = nest(stack.sections[SectionId(slab)]);
  const Nesting above = nest(stack.sections[SectionId(slab + 1)]);
  Pairs pairs;
  for (const RegionLink& link : found->links) {
    if (link.slab != SlabId(slab) || link.evidence != evidence || link.fate != fate) continue;
    pairs.emplace_back(below.region[link.lower].index(), above.region[link.upper].index());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The entry of two contours.
inline std::optional<RegionLink> link_between(const SectionStack& stack, std::size_t slab,
                                              std::size_t lower, std::size_t upper,
                                              const CorrespondenceOptions& options) {
  const Result<StackLinks> found = find_links(stack, {options, {.threads = 1}});
  if (!found) {
    ADD_FAILURE() << to_string(found.error());
    return std::nullopt;
  }
  for (const RegionLink& link : found->links) {
    if (link.slab == SlabId(slab) && link.lower == ContourId(lower) &&
        link.upper == ContourId(upper)) {
      return link;
    }
  }
  return std::nullopt;
}

inline std::size_t components_by(const SectionStack& stack, const CorrespondenceOptions& options) {
  const Result<StackLinks> found = find_links(stack, {options, {.threads = 1}});
  if (!found) ADD_FAILURE() << to_string(found.error());
  return found ? found->components : 0;
}

inline SectionStack upside_down(SectionStack stack) {
  std::reverse(stack.sections.begin(), stack.sections.end());
  for (Section& section : stack.sections) section.z = -section.z;
  return stack;
}

}  // namespace tetloft::testing
