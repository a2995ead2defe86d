// The links of voids of small stacks, and what they are by the whole complements.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
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

/// V3 of one slab, its links of V1 and V2 given, by the distances of all pairs; counts its links.
inline void expect_rims_of_all(const Voids& voids, SlabId slab, const StackLinks& found,
                               const VoidOptions& rule, std::size_t& rims) {
  using Link = std::tuple<std::size_t, std::size_t, double>;  // of holes
  const bool near = rule.rule == VoidRule::near;
  const double reach = near ? rule.reach : kRimReach;
  std::set<Link> rim, due;
  std::set<ContourId> linked[2];
  for (const VoidLink& link : found.void_links) {
    if (link.slab != slab || link.fate != LinkFate::made) continue;
    if (link.evidence == Evidence::rim) {
      rim.emplace(link.lower.index(), link.upper.index(), link.distance);
    } else {
      linked[0].insert(link.lower);
      linked[1].insert(link.upper);
    }
  }
  const double gap = voids.complements[SectionId(slab.index() + 1)].section.z -
                     voids.complements[SectionId(slab.index())].section.z;
  for (const std::size_t upper : {std::size_t{0}, std::size_t{1}}) {
    const SectionId own(slab.index() + upper);
    const SectionId other(slab.index() + 1 - upper);
    for (const RegionId r : voids.outline[own].ids()) {
      const ContourId hole = voids.complements[own].hole(r);
      if (!hole.valid() || linked[upper].contains(hole)) continue;
      std::optional<std::pair<double, RegionId>> nearest;
      for (const RegionId q : voids.outline[other].ids()) {
        if (!near && q.index() > 0) break;
        const double d = region_distance(voids.outline[own][r], voids.outline[other][q]) / gap;
        if (!nearest || d < nearest->first) nearest = std::pair(d, q);
      }
      if (!(nearest->first < reach)) continue;
      const ContourId across = voids.complements[other].hole(nearest->second);
      due.emplace((upper != 0 ? across : hole).index(), (upper != 0 ? hole : across).index(),
                  nearest->first);
    }
  }
  EXPECT_EQ(rim, due);
  rims += due.size();
}

}  // namespace tetloft::testing
