#include "corpus/link_rules.hpp"

#include <algorithm>
#include <cstdint>

namespace tetloft::bench {

namespace {

// Of each region of one side of a slab: does it stay where it is?
struct Clear {
  std::vector<bool> low, high;
};

Clear clear_regions(const LinkRule& rule, const SlabFacts& slab) {
  const std::size_t lows = slab.low_area.size(), highs = slab.high_area.size();
  std::vector<std::size_t> low(lows, 0), high(highs, 0);
  std::vector<double> worst_low(lows, 2), worst_high(highs, 2);
  std::vector<double> best_low(lows, 0), best_high(highs, 0);
  for (const PairFacts& p : slab.pairs) {
    if (!(p.plain > 0)) continue;
    ++low[p.low], ++high[p.high];
    worst_low[p.low] = std::min(worst_low[p.low], p.plain);
    worst_high[p.high] = std::min(worst_high[p.high], p.plain);
    best_low[p.low] = std::max(best_low[p.low], p.plain);
    best_high[p.high] = std::max(best_high[p.high], p.plain);
  }
  Clear clear{std::vector<bool>(lows, false), std::vector<bool>(highs, false)};
  for (const PairFacts& p : slab.pairs) {
    if (!(p.plain > 0)) continue;
    if (rule.mode == 0 && p.plain >= rule.clear && low[p.low] == 1 && high[p.high] == 1) {
      clear.low[p.low] = clear.high[p.high] = true;
    }
    if (rule.mode == 1) {
      if (worst_low[p.low] >= rule.clear) clear.low[p.low] = true;
      if (worst_high[p.high] >= rule.clear) clear.high[p.high] = true;
    }
    if (rule.mode == 2) {
      if (best_low[p.low] >= rule.clear) clear.low[p.low] = true;
      if (best_high[p.high] >= rule.clear) clear.high[p.high] = true;
    }
  }
  if (rule.mode == 3) {  // both ends of every overlap
    for (std::size_t i = 0; i < lows; ++i) clear.low[i] = low[i] > 0;
    for (std::size_t i = 0; i < highs; ++i) clear.high[i] = high[i] > 0;
    for (const PairFacts& p : slab.pairs) {
      if (!(p.plain > 0)) continue;
      if (worst_low[p.low] < rule.clear || worst_high[p.high] < rule.clear)
        clear.low[p.low] = clear.high[p.high] = false;
    }
  }
  return clear;
}

std::vector<double> evidence_of(const LinkRule& rule, const SlabFacts& slab) {
  const Clear clear = clear_regions(rule, slab);
  std::vector<double> result;
  for (const PairFacts& p : slab.pairs) {
    const double low = clear.low[p.low] ? p.plain : p.moved_low;
    const double high = clear.high[p.high] ? p.plain : p.moved_high;
    switch (rule.evidence) {
      case Evidence::plain: result.push_back(p.plain); break;
      case Evidence::moved_max: result.push_back(std::max(low, high)); break;
      case Evidence::moved_mean: result.push_back((low + high) / 2); break;
      case Evidence::moved_smaller:
        result.push_back(slab.low_area[p.low] <= slab.high_area[p.high] ? low : high);
        break;
      case Evidence::moved_half: result.push_back(p.moved_half); break;
    }
  }
  return result;
}

}  // namespace

std::pair<std::size_t, std::size_t> moving(const LinkRule& rule,
                                           const std::vector<SlabFacts>& slabs) {
  std::pair<std::size_t, std::size_t> result{0, 0};
  for (const SlabFacts& slab : slabs) {
    Clear clear = clear_regions(rule, slab);
    std::vector<bool> low(slab.low_area.size(), false), high(slab.high_area.size(), false);
    for (const PairFacts& p : slab.pairs) {
      if (p.distance < 0.9 && !clear.low[p.low]) low[p.low] = true;
      if (p.distance < 0.9 && !clear.high[p.high]) high[p.high] = true;
    }
    result.second += low.size() + high.size();
    for (bool b : low) result.first += b;
    for (bool b : high) result.first += b;
  }
  return result;
}

namespace {

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
