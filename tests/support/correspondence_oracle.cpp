#include "support/correspondence_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "support/region_oracle.hpp"

namespace tetloft::oracle {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;  // of regions, the lower one first
using Labelled = std::vector<std::optional<std::uint32_t>>;

class Rule {
 public:
  Rule(const Model& model, const SectionStack& stack, const CorrespondenceOptions& options)
      : model_(model), stack_(stack), options_(options), regions_(regions_of(stack)) {
    for (std::size_t a = 0; a < regions_.size(); ++a) {
      for (std::size_t b = 0; b < regions_.size(); ++b) {
        if (regions_[b].section == regions_[a].section + 1) pairs_.emplace_back(a, b);
      }
    }
  }

  ExpectedSets run() {
    if (options_.criterion == Criterion::moved) {
      take_motions();
      by_moved_overlap();
    } else {
      by_overlap();
    }
    if (options_.chain) by_chains();
    if (options_.lone) by_loneness();
    decide();
    drop();
    set_.resize(regions_.size());
    for (std::size_t r = 0; r < set_.size(); ++r) set_[r] = r;
    take_labels();
    accept();
    if (!options_.labels.empty() && !result_.refused) connect_labels();
    result_.set.resize(stack_.contour_count());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (const std::size_t c : regions_[r].contours) result_.set[c] = set_[r];
    }
    return std::move(result_);
  }

 private:
  // What is measured.
  [[nodiscard]] double z(std::size_t section) const {
    return stack_.sections[SectionId(section)].z;
  }
  [[nodiscard]] double gap(std::size_t a, std::size_t b) const {
    return std::abs(z(regions_[a].section) - z(regions_[b].section));
  }
  const Rational& ratio(const Pair& pair) {
    const auto [at, fresh] = ratio_.try_emplace(pair);
    if (fresh) at->second = exact_ratio(regions_[pair.first], regions_[pair.second]);
    return at->second;
  }
  double distance(const Pair& pair) {
    const auto [at, fresh] = distance_.try_emplace(pair);
    if (fresh) {
      at->second = rounded_root(squared_distance(regions_[pair.first], regions_[pair.second])) /
                   gap(pair.first, pair.second);
    }
    return at->second;
  }
  double m(const Pair& pair);
  double half_of_m(std::size_t moving, std::size_t still, bool up);

  // Rule 1.
  bool at_rest(std::size_t r, bool up);
  [[nodiscard]] bool is_near_something(std::size_t r, bool up) const;
  void take_motions();
  bool take_motion(const RegionMotion& motion);
  void by_overlap();
  void by_moved_overlap();
  // Rules 2 and 3, from the candidates so far.
  [[nodiscard]] std::vector<std::size_t> partners(std::size_t r, std::size_t section) const;
  std::optional<std::size_t> origin(std::size_t r, std::size_t section);
  double ratio_moved_on(std::size_t r, std::size_t from, std::size_t onto, bool& enough);
  void by_chains();
  void by_loneness();
  // Rules 4 and 8.
  std::optional<Pair> pair_of(SlabId slab, ContourId lower, ContourId upper, bool outer) const;
  void decide();
  void drop();
  // Rules 5 to 7.
  void take_labels();
  bool unite(const Pair& pair);
  void accept();
  void connect_labels();
  bool connect(std::uint32_t label);
  double way(const Pair& pair) const;

  const Model& model_;
  const SectionStack& stack_;
  const CorrespondenceOptions& options_;
  std::vector<Region> regions_;
  std::vector<Pair> pairs_;
  std::map<Pair, Rational> ratio_;
  std::map<Pair, double> distance_;
  std::map<std::pair<std::size_t, bool>, Point2> motion_;  // of a region, upwards or down
  std::map<Pair, double> candidates_;                      // with s
  std::set<Pair> joined_, closed_;
  Labelled label_;                // of a region's set
  std::vector<std::size_t> set_;  // of regions
  ExpectedSets result_;
};

// Rule 1, moved.

double Rule::half_of_m(std::size_t moving, std::size_t still, bool up) {
  const auto by = motion_.find({moving, up});
  if (by == motion_.end()) return rounded(ratio(std::minmax(moving, still)));
  const double sign = up ? 1 : -1;
  const auto there = moved_by(regions_[moving], {sign * by->second.x, sign * by->second.y});
  return there ? rounded(exact_ratio(*there, regions_[still])) : 0;
}

double Rule::m(const Pair& pair) {
  return (half_of_m(pair.first, pair.second, true) + half_of_m(pair.second, pair.first, false)) / 2;
}

bool Rule::at_rest(std::size_t r, bool up) {
  const auto met = [&](std::size_t region, bool upwards) {
    std::vector<Pair> result;
    for (const Pair& pair : pairs_) {
      if ((upwards ? pair.first : pair.second) == region && ratio(pair).sign() > 0) {
        result.push_back(pair);
      }
    }
    return result;
  };
  const std::vector<Pair> own = met(r, up);
  const Rational least = Rational::exactly(kRestOverlap);
  for (const Pair& pair : own) {
    for (const Pair& other : met(up ? pair.second : pair.first, !up)) {
      if (ratio(other) < least) return false;
    }
    if (ratio(pair) < least) return false;
  }
  return !own.empty();
}

bool Rule::is_near_something(std::size_t r, bool up) const {
  const Bounds a = bounds(regions_[r]);
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    if ((up ? pair.first : pair.second) != r) return false;
    const Bounds b = bounds(regions_[up ? pair.second : pair.first]);
    const double g = gap(pair.first, pair.second);
    return a.low.x - g <= b.high.x && b.low.x <= a.high.x + g && a.low.y - g <= b.high.y &&
           b.low.y <= a.high.y + g;
  });
}

bool Rule::take_motion(const RegionMotion& motion) {
  const std::size_t section = std::size_t{motion.slab.value()} + (motion.upper ? 1 : 0);
  if (std::size_t{motion.slab.value()} + 1 >= stack_.sections.size()) return false;
  std::size_t number = motion.contour.value();
  for (std::size_t s = 0; s < section; ++s) {
    number += stack_.sections[SectionId(s)].contours.size();
  }
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (regions_[r].section != section || regions_[r].contours[0] != number) continue;
    const bool up = !motion.upper;
    if (!std::isfinite(motion.by.x) || !std::isfinite(motion.by.y)) return false;
    if (at_rest(r, up) || !is_near_something(r, up)) return false;
    return motion_.emplace(std::pair(r, up), motion.by).second;
  }
  return false;
}

void Rule::take_motions() {
  for (const RegionMotion& motion : model_.motions) {
    if (!take_motion(motion)) result_.claims_hold = false;
  }
}

void Rule::by_moved_overlap() {
  for (const Pair& pair : pairs_) {
    const double moved = m(pair);
    if (moved == 0) continue;
    const double d = distance(pair);
    if (moved > threshold_of(options_) + d) candidates_[pair] = moved - d;
  }
}

// Rule 1, overlap.

void Rule::by_overlap() {
  const Rational tau = Rational::exactly(threshold_of(options_));
  const Rational strong = Rational::exactly(kStrongOverlap);
  for (const Pair& pair : pairs_) {
    if (!(ratio(pair) > tau)) continue;
    const auto has_strong = [&](auto same) {
      return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& other) {
        return same(other) && ratio(other) > tau && ratio(other) >= strong;
      });
    };
    const bool outruled =
        ratio(pair) < strong &&
        has_strong([&](const Pair& other) { return other.first == pair.first; }) &&
        has_strong([&](const Pair& other) { return other.second == pair.second; });
    if (!outruled) candidates_[pair] = rounded(ratio(pair)) - distance(pair);
  }
}

// Rules 2 and 3.

std::vector<std::size_t> Rule::partners(std::size_t r, std::size_t section) const {
  std::vector<std::size_t> result;
  for (const auto& [pair, s] : candidates_) {
    if (pair.first == r && regions_[pair.second].section == section) result.push_back(pair.second);
    if (pair.second == r && regions_[pair.first].section == section) result.push_back(pair.first);
  }
  return result;
}

std::optional<std::size_t> Rule::origin(std::size_t r, std::size_t section) {
  const std::vector<std::size_t> known = partners(r, section);
  if (known.size() == 1) return known[0];
  std::optional<std::size_t> nearest;
  if (!known.empty()) return nearest;
  double least = kChainReach;
  for (std::size_t q = 0; q < regions_.size(); ++q) {
    if (regions_[q].section != section) continue;
    const double d = distance(std::minmax(r, q));
    if (nearest ? d < least : d <= least) {
      nearest = q;
      least = d;
    }
  }
  return nearest;
}

// The ratio of r, moved on as it came from section `from`, and `onto`.
double Rule::ratio_moved_on(std::size_t r, std::size_t from, std::size_t onto, bool& enough) {
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

void Rule::by_chains() {
  std::map<Pair, double> chains;
  for (const Pair& pair : pairs_) {
    const auto [a, b] = pair;
    const std::size_t s = regions_[a].section;
    if (!partners(a, s + 1).empty() || !partners(b, s).empty()) continue;
    const double d = distance(pair);
    if (d > kChainReach) continue;
    bool enough = false;
    const double from_below = ratio_moved_on(a, s - 1, b, enough);  // none is the last number
    const double from_above = ratio_moved_on(b, s + 2, a, enough);
    if (enough) chains[pair] = std::max(from_below, from_above) - d;
  }
  candidates_.insert(chains.begin(), chains.end());
}

void Rule::by_loneness() {
  std::map<Pair, double> chosen;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const bool linked = std::any_of(candidates_.begin(), candidates_.end(), [&](const auto& c) {
      return c.first.first == r || c.first.second == r;
    });
    if (linked) continue;
    std::optional<std::pair<Pair, double>> best;
    for (const Pair& pair : pairs_) {  // by slab, and of one region by the other
      if (pair.first != r && pair.second != r) continue;
      const Rational half = Rational::exactly(gap(pair.first, pair.second)) / Rational(2);
      const bool small = regions_[r].area < Rational(2) * half * half;
      const double d = distance(pair);
      if (!(d < (small ? kSmallLoneReach : kLoneReach))) continue;
      const double s = m(pair) - d;
      const auto slab = [&](const Pair& p) { return regions_[p.first].section; };
      if (!best || s > best->second || (s == best->second && slab(pair) < slab(best->first))) {
        best = {pair, s};
      }
    }
    if (best) chosen.insert(*best);
  }
  candidates_.insert(chosen.begin(), chosen.end());
}

// Rules 4 and 8.

std::optional<Pair> Rule::pair_of(SlabId slab, ContourId lower, ContourId upper, bool outer) const {
  const auto region = [&](std::size_t section, ContourId contour) {
    std::size_t number = contour.value();
    std::size_t first = 0;
    for (std::size_t s = 0; s < section && s < stack_.sections.size(); ++s) {
      first += stack_.sections[SectionId(s)].contours.size();
    }
    number += first;
    const auto at = std::find_if(regions_.begin(), regions_.end(), [&](const Region& r) {
      if (r.section != section) return false;
      const auto found = std::find(r.contours.begin(), r.contours.end(), number);
      return outer ? found == r.contours.begin() : found != r.contours.end();
    });
    return static_cast<std::size_t>(at - regions_.begin());
  };
  const Pair pair{region(slab.value(), lower), region(std::size_t{slab.value()} + 1, upper)};
  if (pair.first == regions_.size() || pair.second == regions_.size()) return std::nullopt;
  return pair;
}

void Rule::decide() {
  for (const LinkDecision& decision : options_.decisions) {
    const auto pair = pair_of(decision.slab, decision.lower, decision.upper, false);
    if (!pair) {
      result_.refused = true;
      continue;
    }
    (decision.join ? joined_ : closed_).insert(*pair);
  }
  for (const Pair& pair : joined_) {
    if (closed_.count(pair) != 0) result_.refused = true;
    candidates_.insert({pair, 0});
  }
  for (const Pair& pair : closed_) candidates_.erase(pair);
}

void Rule::drop() {
  std::set<Pair> dropped;
  for (const RegionLink& link : model_.links) {
    if (link.fate != LinkFate::unrealisable) continue;
    const auto pair = pair_of(link.slab, link.lower, link.upper, true);
    if (!pair || candidates_.count(*pair) == 0 || joined_.count(*pair) != 0 ||
        distance(*pair) == 0 || !dropped.insert(*pair).second) {
      result_.claims_hold = false;
    }
  }
  result_.dropped = dropped.size();
  for (const Pair& pair : dropped) {
    candidates_.erase(pair);
    closed_.insert(pair);
  }
}

// Rules 5 to 7.

void Rule::take_labels() {
  label_.resize(regions_.size());
  for (const Label& label : options_.labels) {
    std::size_t number = label.contour.value();
    for (std::size_t s = 0; s < label.section.index(); ++s) {
      number += stack_.sections[SectionId(s)].contours.size();
    }
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const auto& contours = regions_[r].contours;
      if (std::count(contours.begin(), contours.end(), number) == 0) continue;
      if (label_[r] && *label_[r] != label.label) result_.refused = true;
      label_[r] = label.label;
    }
  }
}

// False, and nothing done, if their labels differ.
bool Rule::unite(const Pair& pair) {
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
  return true;
}

void Rule::accept() {
  for (const Pair& pair : joined_) {
    if (!unite(pair)) result_.refused = true;
  }
  std::vector<std::pair<double, Pair>> others;
  for (const auto& [pair, s] : candidates_) {
    if (joined_.count(pair) == 0) others.emplace_back(-s, pair);
  }
  std::sort(others.begin(), others.end());
  for (const auto& [s, pair] : others) unite(pair);
}

double Rule::way(const Pair& pair) const {
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
bool Rule::connect(std::uint32_t label) {
  const auto first = std::find(label_.begin(), label_.end(), std::optional(label));
  using Path = std::pair<double, std::vector<Pair>>;
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
      for (const Pair& pair : best->second) unite(pair);
      return true;
    }
    std::map<std::size_t, Path> next;
    for (const Pair& pair : pairs_) {
      if (closed_.count(pair) != 0) continue;
      for (const auto& [from, to] : {pair, Pair{pair.second, pair.first}}) {
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

void Rule::connect_labels() {
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
      result_.realised = false;
      return;
    }
  }
}

}  // namespace

ExpectedSets expected_sets(const Model& model, const SectionStack& stack,
                           const CorrespondenceOptions& options) {
  return Rule(model, stack, options).run();
}

}  // namespace tetloft::oracle
