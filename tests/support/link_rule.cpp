#include "support/link_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetloft::oracle {

LinkRule::LinkRule(const SectionStack& stack, const std::vector<Label>& labels,
                   const std::vector<LinkDecision>& decisions, const Words& words)
    : stack_(stack),
      regions_(regions_of(stack)),
      labels_(labels),
      decisions_(decisions),
      words_(words) {
  for (std::size_t a = 0; a < regions_.size(); ++a) {
    set_.push_back(a);
    for (std::size_t b = 0; b < regions_.size(); ++b) {
      if (regions_[b].section == regions_[a].section + 1) pairs_.emplace_back(a, b);
    }
  }
  label_.resize(regions_.size());
}

double LinkRule::gap(std::size_t a, std::size_t b) const {
  return std::abs(z(regions_[a].section) - z(regions_[b].section));
}

const Rational& LinkRule::ratio(const RegionPair& pair) {
  const auto [at, fresh] = ratio_.try_emplace(pair);
  if (fresh) at->second = exact_ratio(regions_[pair.first], regions_[pair.second]);
  return at->second;
}

double LinkRule::distance(const RegionPair& pair) {
  const auto [at, fresh] = distance_.try_emplace(pair);
  if (fresh) {
    at->second = rounded_root(squared_distance(regions_[pair.first], regions_[pair.second])) /
                 gap(pair.first, pair.second);
  }
  return at->second;
}

bool LinkRule::is_exterior(std::size_t r) const {
  return words_.exteriors && (r == 0 || regions_[r - 1].section != regions_[r].section);
}

// Rule 2.

std::vector<std::size_t> LinkRule::partners(std::size_t r, std::size_t section) const {
  std::vector<std::size_t> result;
  for (const auto& [pair, s] : candidates_) {
    if (pair.first == r && regions_[pair.second].section == section) result.push_back(pair.second);
    if (pair.second == r && regions_[pair.first].section == section) result.push_back(pair.first);
  }
  return result;
}

std::optional<std::size_t> LinkRule::origin(std::size_t r, std::size_t section) {
  const std::vector<std::size_t> known = partners(r, section);
  std::optional<std::size_t> nearest;
  if (known.size() == 1 && !is_exterior(known[0])) return known[0];
  if (!known.empty()) return nearest;
  double least = words_.chain_reach;
  for (std::size_t q = 0; q < regions_.size(); ++q) {
    if (regions_[q].section != section || is_exterior(q)) continue;
    const double d = distance(std::minmax(r, q));
    if (nearest ? d < least : d <= least) {
      nearest = q;
      least = d;
    }
  }
  return nearest;
}

// The ratio of r, moved on as it came from section `from`, and `onto`.
double LinkRule::ratio_moved_on(std::size_t r, std::size_t from, std::size_t onto, bool& enough) {
  if (from >= stack_.sections.size()) return 0;
  const std::optional<std::size_t> before = origin(r, from);
  if (!before) return 0;
  const double scale = gap(r, onto) / gap(r, *before);
  const auto centre = [&](std::size_t q) {
    const Bounds box = bounds(regions_[q]);
    return Point2{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  };
  const Point2 now = centre(r);
  const Point2 then = centre(*before);
  const auto there = moved_by(regions_[r], {(now.x - then.x) * scale, (now.y - then.y) * scale});
  if (!there) return 0;
  const Rational met = exact_ratio(*there, regions_[onto]);
  if (met > Rational::exactly(kChainOverlap)) enough = true;
  return rounded(met);
}

void LinkRule::by_chains() {
  std::map<RegionPair, double> chains;
  for (const RegionPair& pair : pairs_) {
    const auto [a, b] = pair;
    if (is_exterior(a) || is_exterior(b)) continue;
    const std::size_t s = regions_[a].section;
    if (!partners(a, s + 1).empty() || !partners(b, s).empty()) continue;
    const double d = distance(pair);
    if (d > words_.chain_reach) continue;
    bool enough = false;
    const double from_below = ratio_moved_on(a, s - 1, b, enough);  // none is the last number
    const double from_above = ratio_moved_on(b, s + 2, a, enough);
    if (enough) chains[pair] = std::max(from_below, from_above) - d;
  }
  candidates_.insert(chains.begin(), chains.end());
}

// Rule 4.

std::optional<std::size_t> LinkRule::named(std::size_t section, ContourId contour,
                                           bool outer) const {
  if (section >= stack_.sections.size()) return std::nullopt;
  std::size_t first = 0;
  for (std::size_t s = 0; s < section; ++s) first += stack_.sections[SectionId(s)].contours.size();
  const std::size_t number = contour.valid() ? first + contour.value() : 0;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (regions_[r].section != section) continue;
    if (words_.exteriors && is_exterior(r) == contour.valid()) continue;
    if (words_.exteriors && !contour.valid()) return r;
    const auto& contours = regions_[r].contours;
    const auto found = std::find(contours.begin(), contours.end(), number);
    if (outer ? found == contours.begin() : found != contours.end()) return r;
  }
  return std::nullopt;
}

std::optional<RegionPair> LinkRule::pair_of(SlabId slab, ContourId lower, ContourId upper,
                                            bool outer) const {
  const auto a = named(slab.value(), lower, outer);
  const auto b = named(std::size_t{slab.value()} + 1, upper, outer);
  if (!a || !b) return std::nullopt;
  return RegionPair{*a, *b};
}

void LinkRule::decide() {
  for (const LinkDecision& decision : decisions_) {
    const auto pair = pair_of(decision.slab, decision.lower, decision.upper, words_.exteriors);
    if (!pair || (is_exterior(pair->first) && is_exterior(pair->second))) {
      refused_ = true;
      continue;
    }
    (decision.join ? joined_ : closed_).insert(*pair);
  }
  for (const RegionPair& pair : joined_) {
    if (closed_.count(pair) != 0) refused_ = true;
    candidates_.insert({pair, 0});
  }
  for (const RegionPair& pair : closed_) candidates_.erase(pair);
}

// Rules 5 to 7.

void LinkRule::take_labels() {
  for (const Label& label : labels_) {
    const auto r = label.contour.valid()
                       ? named(label.section.index(), label.contour, words_.exteriors)
                       : std::nullopt;
    if (!r || (label_[*r] && *label_[*r] != label.label)) {
      refused_ = true;
    } else {
      label_[*r] = label.label;
    }
  }
}

// False, and nothing done, if their labels differ.
bool LinkRule::unite(const RegionPair& pair) {
  const auto one = label_[pair.first];
  const auto other = label_[pair.second];
  if (one && other && *one != *other) return false;
  const std::size_t a = set_[pair.first];
  const std::size_t b = set_[pair.second];
  for (std::size_t r = 0; r < set_.size(); ++r) {
    if (set_[r] != a && set_[r] != b) continue;
    set_[r] = std::min(a, b);
    label_[r] = one ? one : other;
  }
  links_.insert(pair);
  return true;
}

void LinkRule::accept() {
  for (const RegionPair& pair : joined_) {
    if (!unite(pair)) refused_ = true;
  }
  std::vector<std::pair<double, RegionPair>> others;
  for (const auto& [pair, s] : candidates_) {
    if (joined_.count(pair) == 0) others.emplace_back(-s, pair);
  }
  std::sort(others.begin(), others.end());
  for (const auto& [s, pair] : others) unite(pair);
}

double LinkRule::way(const RegionPair& pair) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& c : regions_[pair.first].shape) {
    for (const auto& d : regions_[pair.second].shape) {
      for (const Point2& p : c) {
        for (const Point2& q : d) least = std::min(least, std::hypot(p.x - q.x, p.y - q.y));
      }
    }
  }
  return std::hypot(least, gap(pair.first, pair.second));
}

// Rule 7, one path: all sets that k new links lead to, for k = 0, 1, …
bool LinkRule::connect(std::uint32_t label) {
  const auto first = std::find(label_.begin(), label_.end(), std::optional(label));
  using Path = std::pair<double, std::vector<RegionPair>>;
  std::map<std::size_t, Path> reached{{set_[static_cast<std::size_t>(first - label_.begin())], {}}};
  std::set<std::size_t> seen;
  while (!reached.empty()) {
    std::optional<Path> best;
    for (const auto& [set, path] : reached) {
      seen.insert(set);
      if (!path.second.empty() && label_[set] == std::optional(label) && (!best || path < *best)) {
        best = path;
      }
    }
    if (best) {
      for (const RegionPair& pair : best->second) unite(pair);
      return true;
    }
    std::map<std::size_t, Path> next;
    for (const RegionPair& pair : pairs_) {
      if (closed_.count(pair) != 0) continue;
      for (const auto& [from, to] : {pair, RegionPair{pair.second, pair.first}}) {
        const auto at = reached.find(set_[from]);
        if (at == reached.end() || seen.count(set_[to]) != 0) continue;
        if (label_[to] && *label_[to] != label) continue;
        Path longer = at->second;
        longer.first += way(pair);
        longer.second.push_back(pair);
        const auto [known, fresh] = next.try_emplace(set_[to], longer);
        if (!fresh && longer < known->second) known->second = longer;
      }
    }
    reached = std::move(next);
  }
  return false;
}

void LinkRule::connect_labels() {
  std::set<std::uint32_t> labels;
  for (const auto& label : label_) {
    if (label) labels.insert(*label);
  }
  for (const std::uint32_t label : labels) {
    const auto apart = [&] {
      std::set<std::size_t> sets;
      for (std::size_t r = 0; r < set_.size(); ++r) {
        if (label_[r] == std::optional(label)) sets.insert(set_[r]);
      }
      return sets.size() > 1;
    };
    while (apart()) {
      if (connect(label)) continue;
      realised_ = false;
      return;
    }
  }
}

}  // namespace tetloft::oracle
