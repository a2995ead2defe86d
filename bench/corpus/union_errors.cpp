#include "corpus/union_errors.hpp"

#include <algorithm>

#include "core/union_find.hpp"

namespace tetloft::bench {

namespace {

using internal::UnionFind;

std::size_t class_count(const UnionFind& sets) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < sets.size(); ++k) count += sets.find(k) == k ? 1U : 0U;
  return count;
}

}  // namespace

UnionErrors union_errors(const SectionStack& stack, const std::vector<RegionLink>& links,
                         const std::vector<std::vector<std::size_t>>& piece) {
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  UnionErrors errors;
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const Nesting& below = nestings[SectionId(k)];
    const Nesting& above = nestings[SectionId(k + 1)];
    const std::vector<std::size_t>& pieces = piece[k];
    UnionFind got(pieces.size()), want(pieces.size()), joint(pieces.size());
    for (const RegionLink& link : links) {
      if (link.slab != SlabId(k) || link.fate != LinkFate::made) continue;
      const std::size_t low = below.region[link.lower].index();
      const std::size_t high = below.outer.size() + above.region[link.upper].index();
      got.unite(low, high);
      joint.unite(low, high);
    }
    for (std::size_t a = 0; a < pieces.size(); ++a) {
      const auto first = std::find(pieces.begin(), pieces.end(), pieces[a]);
      const auto b = static_cast<std::size_t>(first - pieces.begin());
      want.unite(a, b);
      joint.unite(a, b);
    }
    const std::size_t both = class_count(joint);
    errors.missing += class_count(got) - both;
    errors.wrong += class_count(want) - both;
  }
  return errors;
}

}  // namespace tetloft::bench
