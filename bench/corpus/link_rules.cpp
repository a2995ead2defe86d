#include "corpus/link_rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::bench {

namespace {

double evidence_of(Evidence evidence, const PairFacts& p) {
  switch (evidence) {
    case Evidence::plain: return p.plain;
    case Evidence::max: return std::max(p.moved_low, p.moved_high);
    case Evidence::mean: return (p.moved_low + p.moved_high) / 2;
    case Evidence::joint: return p.moved_joint;
    case Evidence::joint_max: return std::max(p.moved_joint, (p.moved_low + p.moved_high) / 2);
    case Evidence::three: return (p.moved_low + p.moved_high + 2*p.moved_joint) / 4;
  }
  return 0;
}

std::vector<double> evidence_of(const LinkRule& rule, const SlabFacts& slab) {
  std::vector<double> result;
  for (const PairFacts& p : slab.pairs) result.push_back(evidence_of(rule.evidence, p));
  return result;
}

struct Candidate {
  std::size_t slab = 0, pair = 0;
  double score = 0;
  bool found = false;
};

}  // namespace

StackLinks links_by(const LinkRule& rule, const std::vector<SlabFacts>& slabs) {
  StackLinks links(slabs.size());
  if (slabs.empty()) return links;
  // By section and region: has it a link?
  std::vector<std::vector<bool>> linked;
  for (const SlabFacts& slab : slabs) linked.emplace_back(slab.low_area.size(), false);
  linked.emplace_back(slabs.back().high_area.size(), false);
  std::vector<std::vector<double>> evidence;
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    const SlabFacts& slab = slabs[s];
    evidence.push_back(evidence_of(rule, slab));
    const std::vector<double>& m = evidence.back();
    std::vector<bool> strong_low(slab.low_area.size(), false),
        strong_high(slab.high_area.size(), false);
    for (std::size_t p = 0; p < m.size(); ++p) {
      if (m[p] >= rule.guard)
        strong_low[slab.pairs[p].low] = strong_high[slab.pairs[p].high] = true;
    }
    for (std::size_t p = 0; p < m.size(); ++p) {
      const PairFacts& pair = slab.pairs[p];
      if (!(m[p] > rule.tau + rule.slope * pair.distance)) continue;
      if (m[p] < rule.guard && strong_low[pair.low] && strong_high[pair.high]) continue;
      links[s].emplace_back(pair.low, pair.high);
      linked[s][pair.low] = linked[s + 1][pair.high] = true;
    }
  }
  if (!rule.lone) return links;
  // The best candidate of each lone region.
  std::vector<std::vector<Candidate>> best;
  for (const auto& section : linked) best.emplace_back(section.size());
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    const SlabFacts& slab = slabs[s];
    for (std::size_t p = 0; p < slab.pairs.size(); ++p) {
      const PairFacts& pair = slab.pairs[p];
      const double score = evidence[s][p] - pair.distance;
      const auto consider = [&](std::size_t section, std::size_t region, double area) {
        if (linked[section][region]) return;
        if (pair.distance >= 0.5 && !(area < slab.gap * slab.gap / 4)) return;
        Candidate& c = best[section][region];
        if (!c.found || score > c.score) c = {s, p, score, true};
      };
      consider(s, pair.low, slab.low_area[pair.low]);
      consider(s + 1, pair.high, slab.high_area[pair.high]);
    }
  }
  for (const auto& section : best) {
    for (const Candidate& c : section) {
      if (!c.found) continue;
      const PairFacts& pair = slabs[c.slab].pairs[c.pair];
      links[c.slab].emplace_back(pair.low, pair.high);
    }
  }
  return links;
}

}  // namespace tetloft::bench
