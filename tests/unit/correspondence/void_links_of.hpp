// The links of voids of small stacks, and what they are by the whole complements.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include <tetloft/links.hpp>
#include <tetloft/overlap.hpp>

#include "links_of.hpp"
#include "sections/complement.hpp"

namespace tetloft::testing {

/// In place of a hole.
inline constexpr std::size_t kOutside = 4294967295;
static_assert(ContourId().index() == kOutside);

using Told = std::vector<std::tuple<std::size_t, std::size_t, std::size_t, Evidence, LinkFate>>;
using Pairs3 = std::vector<std::tuple<std::size_t, std::size_t, std::size_t>>;

inline StackLinks found_links(const SectionStack& stack, const CorrespondenceOptions& options = {},
                              unsigned threads = 1) {
  Result<StackLinks> found = find_links(stack, {options, {.threads = threads}});
  if (!found) ADD_FAILURE() << to_string(found.error());
  return found ? std::move(*found) : StackLinks();
}

/// (slab, hole below, hole above, evidence, fate), in the order of the report.
inline Told told(const SectionStack& stack, const CorrespondenceOptions& options = {},
                 unsigned threads = 1) {
  Told links;
  for (const VoidLink& link : found_links(stack, options, threads).void_links) {
    links.emplace_back(link.slab.index(), link.lower.index(), link.upper.index(), link.evidence,
                       link.fate);
  }
  return links;
}

/// Those made, sorted.
inline Pairs3 made(const SectionStack& stack, const CorrespondenceOptions& options = {}) {
  Pairs3 links;
  for (const auto& [slab, lower, upper, evidence, fate] : told(stack, options)) {
    if (fate == LinkFate::made) links.emplace_back(slab, lower, upper);
  }
  std::sort(links.begin(), links.end());
  return links;
}

inline std::size_t cavities_of(const SectionStack& stack,
                               const CorrespondenceOptions& options = {}) {
  return found_links(stack, options).cavities;
}

/// All complements, whole.
struct Voids {
  explicit Voids(const SectionStack& stack) {
    const double half_side = internal::sections::far_outside(stack);
    for (const Section& section : stack.sections) {
      complements.push_back(internal::sections::complement_of(section, nest(section), half_side));
    }
    for (const auto& complement : complements) {
      outline.push_back(outlines(complement.section, complement.nesting));
    }
  }
  IdVector<SectionId, internal::sections::Complement> complements;
  IdVector<SectionId, IdVector<RegionId, RegionOutline>> outline;
};

inline const VoidLink* find_link(const StackLinks& found, SlabId slab, ContourId lower,
                                 ContourId upper) {
  for (const VoidLink& link : found.void_links) {
    if (link.slab == slab && link.lower == lower && link.upper == upper) return &link;
  }
  return nullptr;
}

/// V1 of one slab; counts the pairs that overlap.
inline void expect_overlaps_of_all(const Voids& voids, SlabId slab, const StackLinks& found,
                                   std::size_t& overlaps) {
  const SectionId below(slab.index());
  const SectionId above(slab.index() + 1);
  for (const RegionId i : voids.outline[below].ids()) {
    for (const RegionId j : voids.outline[above].ids()) {
      if (i.index() == 0 && j.index() == 0) continue;
      const RegionOutline& a = voids.outline[below][i];
      const RegionOutline& b = voids.outline[above][j];
      const double ratio = overlap_ratio(a, b);
      const VoidLink* const link = find_link(found, slab, voids.complements[below].hole(i),
                                             voids.complements[above].hole(j));
      const bool candidate = compare_overlap(a, b, kVoidOverlap) == Sign::positive;
      EXPECT_EQ(
          link != nullptr && link->evidence == Evidence::overlap && link->fate == LinkFate::made,
          candidate);
      if (ratio == 0) continue;
      ++overlaps;
      ASSERT_NE(link, nullptr);
      EXPECT_EQ(link->ratio, ratio);
    }
  }
}

/// V3 of one slab, its links of V1 and V2 given; counts those within reach.
inline void expect_rims_of_all(const Voids& voids, SlabId slab, const StackLinks& found,
                               std::size_t& rims) {
  const auto is_linked_otherwise = [&](bool upper, ContourId hole) {
    return std::any_of(found.void_links.begin(), found.void_links.end(), [&](const VoidLink& link) {
      return link.slab == slab && link.fate == LinkFate::made && link.evidence != Evidence::rim &&
             (upper ? link.upper : link.lower) == hole;
    });
  };
  for (const bool upper : {false, true}) {
    const SectionId own(slab.index() + (upper ? 1 : 0));
    const SectionId other(slab.index() + (upper ? 0 : 1));
    const double gap = voids.complements[SectionId(slab.index() + 1)].section.z -
                       voids.complements[SectionId(slab.index())].section.z;
    for (const RegionId r : voids.outline[own].ids()) {
      const ContourId hole = voids.complements[own].hole(r);
      if (!hole.valid()) continue;
      const double d =
          region_distance(voids.outline[own][r], voids.outline[other][RegionId(0)]) / gap;
      const VoidLink* const link =
          find_link(found, slab, upper ? ContourId() : hole, upper ? hole : ContourId());
      const bool due = !is_linked_otherwise(upper, hole) && d < kRimReach;
      EXPECT_EQ(link != nullptr && link->evidence == Evidence::rim && link->fate == LinkFate::made,
                due);
      if (!due || link == nullptr) continue;
      ++rims;
      EXPECT_EQ(link->distance, d);
    }
  }
}

}  // namespace tetloft::testing
