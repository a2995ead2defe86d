#include "corpus/link_rules.hpp"

#include <algorithm>
#include <cstddef>

namespace tetloft::bench {

namespace {

double evidence_of(const LinkRule& rule, const PairFacts& p) {
  switch (rule.evidence) {
    case Evidence::reverse: return 0;
    case Evidence::plain: return p.plain;
    case Evidence::moved_larger: return std::max(p.moved_low, p.moved_high);
    case Evidence::moved_mean: return (p.moved_low + p.moved_high) / 2;
    case Evidence::moved_both: return p.moved_both;
  }
  return 0;
}

Pairs slab_links(const LinkRule& rule, const SlabFacts& slab) {
  if (rule.evidence == Evidence::reverse) return slab.reverse;
  std::vector<bool> strong_low(slab.low_area.size(), false);
  std::vector<bool> strong_high(slab.high_area.size(), false);
  for (const PairFacts& p : slab.pairs) {
    if (evidence_of(rule, p) >= rule.guard) strong_low[p.low] = strong_high[p.high] = true;
  }
  Pairs links;
  for (const PairFacts& p : slab.pairs) {
    const double m = evidence_of(rule, p);
    if (!(m > rule.tau + rule.slope * p.distance)) continue;
    if (m < rule.guard && strong_low[p.low] && strong_high[p.high]) continue;
    links.emplace_back(p.low, p.high);
  }
  return links;
}

// The best link that a lone region could have.
struct Best {
  bool found = false;
  double score = 0;
  std::size_t slab = 0;
  std::pair<std::size_t, std::size_t> link;
};

// A lone region is linked with the candidate of largest evidence less distance (the lower slab's
// and the lower id's, if equal) within half a gap, or within a gap if the region is small: all at
// the same time.
void link_lone(const LinkRule& rule, const std::vector<SlabFacts>& slabs,
               std::vector<Pairs>& links) {
  std::vector<std::vector<Best>> best(slabs.size() + 1);
  std::vector<std::vector<bool>> linked(slabs.size() + 1);
  for (std::size_t s = 0; s <= slabs.size(); ++s) {
    const std::size_t n =
        s < slabs.size() ? slabs[s].low_area.size() : slabs[s - 1].high_area.size();
    best[s].resize(n);
    linked[s].resize(n, false);
  }
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    for (const auto& [low, high] : links[s]) linked[s][low] = linked[s + 1][high] = true;
  }
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    const SlabFacts& slab = slabs[s];
    for (const PairFacts& p : slab.pairs) {
      const double score = evidence_of(rule, p) - p.distance;
      const auto consider = [&](std::size_t section, std::size_t region, double area) {
        const bool small = area < slab.gap * slab.gap / 4;
        if (linked[section][region] || p.distance >= (small ? 1 : 0.5)) return;
        Best& b = best[section][region];
        if (!b.found || score > b.score) b = {true, score, s, {p.low, p.high}};
      };
      consider(s, p.low, slab.low_area[p.low]);
      consider(s + 1, p.high, slab.high_area[p.high]);
    }
  }
  for (const std::vector<Best>& section : best) {
    for (const Best& b : section) {
      if (b.found) links[b.slab].push_back(b.link);
    }
  }
}

}  // namespace

std::vector<LinkRule> link_rules() {
  return {
      {"reverse", Evidence::reverse},
      {"overlap 0.02", Evidence::plain, 0.02},
      {"overlap 0.02, guard 0.25", Evidence::plain, 0.02, 0, 0.25},
      {"overlap 0.02, guard 0.25, lone", Evidence::plain, 0.02, 0, 0.25, true},
      {"moved", Evidence::moved_mean, 0.1, 1},
      {"moved, lone", Evidence::moved_mean, 0.1, 1, 2, true},
      {"moved (the larger), lone", Evidence::moved_larger, 0.1, 1, 2, true},
      {"moved (by both), lone", Evidence::moved_both, 0.1, 1, 2, true},
  };
}

std::vector<Pairs> links_by(const LinkRule& rule, const std::vector<SlabFacts>& slabs) {
  std::vector<Pairs> links;
  for (const SlabFacts& slab : slabs) links.push_back(slab_links(rule, slab));
  if (rule.lone && !slabs.empty()) link_lone(rule, slabs, links);
  return links;
}

}  // namespace tetloft::bench
