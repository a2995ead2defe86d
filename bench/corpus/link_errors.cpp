#include "corpus/link_errors.hpp"

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

UnionErrors union_errors(std::size_t lows, const std::vector<std::size_t>& piece,
                         const Pairs& links) {
  const std::size_t n = piece.size();
  UnionFind got(n), want(n), joint(n);
  for (const auto& [low, high] : links) {
    got.unite(low, lows + high);
    joint.unite(low, lows + high);
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (piece[a] != piece[b]) continue;
      want.unite(a, b);
      joint.unite(a, b);
    }
  }
  const std::size_t both = class_count(joint);
  return {class_count(got) - both, class_count(want) - both};
}

std::size_t component_count(const std::vector<SlabFacts>& slabs, const std::vector<Pairs>& links) {
  std::vector<std::size_t> first{0};
  for (const SlabFacts& slab : slabs) first.push_back(first.back() + slab.low_area.size());
  UnionFind sets(first.back() + (slabs.empty() ? 0 : slabs.back().high_area.size()));
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    for (const auto& [low, high] : links[s]) sets.unite(first[s] + low, first[s + 1] + high);
  }
  return class_count(sets);
}

}  // namespace tetloft::bench
