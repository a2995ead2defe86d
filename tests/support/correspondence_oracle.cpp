#include "support/correspondence_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "support/link_rule.hpp"

namespace tetloft::oracle {

namespace {

using Pair = RegionPair;

class Rule : private LinkRule {
 public:
  Rule(const Model& model, const SectionStack& stack, const CorrespondenceOptions& options)
      : LinkRule(stack, options.labels, options.decisions, {}), model_(model), options_(options) {}

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
    take_labels();
    accept();
    if (!options_.labels.empty() && !refused_) connect_labels();
    result_.refused = refused_;
    result_.realised = realised_;
    result_.links = links_;
    result_.set.resize(stack_.contour_count());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (const std::size_t c : regions_[r].contours) result_.set[c] = set_[r];
    }
    return std::move(result_);
  }

 private:
  double m(const Pair& pair);
  double half_of_m(std::size_t moving, std::size_t still, bool up);

  // Rule 1.
  bool at_rest(std::size_t r, bool up);
  [[nodiscard]] bool is_near_something(std::size_t r, bool up) const;
  void take_motions();
  bool take_motion(const RegionMotion& motion);
  void by_overlap();
  void by_moved_overlap();
  // Rules 3 and 8, from the candidates so far.
  void by_loneness();
  void drop();

  const Model& model_;
  const CorrespondenceOptions& options_;
  std::map<std::pair<std::size_t, bool>, Point2> motion_;  // of a region, upwards or down
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

// Rule 3.

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

// Rule 8.

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

}  // namespace

ExpectedSets expected_sets(const Model& model, const SectionStack& stack,
                           const CorrespondenceOptions& options) {
  return Rule(model, stack, options).run();
}

}  // namespace tetloft::oracle
