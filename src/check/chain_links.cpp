// Rule 2: a region that is single in a slab moves on as it came, and is joined with what it meets.
#include <algorithm>
#include <map>

#include "check/partition.hpp"

namespace tetloft::internal::checking {

namespace {

class ChainFinder {
 public:
  ChainFinder(const Regions& regions, const std::vector<Link>& by_criterion, const ChainRule& rule)
      : regions_(regions), linked_(regions.size(), by_criterion), rule_(rule) {}

  std::vector<Candidate> run() {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const std::size_t s = regions_.section[r];
      if (s + 1 == regions_.section_count() || is_exterior(r)) continue;
      if (s > 0 && linked_.up[r].empty()) move_on(r, s - 1, s + 1);
    }
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const std::size_t s = regions_.section[r];
      if (s == 0 || is_exterior(r)) continue;
      if (s + 1 < regions_.section_count() && linked_.down[r].empty()) move_on(r, s + 1, s - 1);
    }
    std::vector<Candidate> candidates;
    for (const auto& [link, met] : met_) {
      if (met.far_enough) candidates.push_back({link, met.ratio - *regions_.distance(link)});
    }
    return candidates;
  }

 private:
  // What came of a pair, moved on from below or from above.
  struct Met {
    double ratio = 0;         // the larger one
    bool far_enough = false;  // either is above the threshold
  };

  [[nodiscard]] bool is_exterior(std::size_t r) const {
    return rule_.exteriors && r == regions_.first[regions_.section[r]];
  }

  [[nodiscard]] const std::vector<std::size_t>& partners(std::size_t r, std::size_t s) const {
    return s > regions_.section[r] ? linked_.up[r] : linked_.down[r];
  }

  // Where region r came from in section s.
  [[nodiscard]] std::optional<std::size_t> origin(std::size_t r, std::size_t s) const {
    const std::vector<std::size_t>& known = partners(r, s);
    if (known.size() == 1 && !is_exterior(known.front())) return known.front();
    if (!known.empty()) return std::nullopt;
    std::vector<std::pair<double, std::size_t>> near;
    for_each_within_reach(r, s, [&](std::size_t q, double d) { near.emplace_back(d, q); });
    if (near.empty()) return std::nullopt;
    return std::min_element(near.begin(), near.end())->second;
  }

  // Calls visit(q, d) for the regions of section s in a neighbourhood of r, no exterior.
  template <class Visit>
  void for_each_within_reach(std::size_t r, std::size_t s, Visit&& visit) const {
    const double reach = rule_.reach * regions_.gap(regions_.section[r], s);
    const Box2 around = surroundings(regions_.box[r], reach);
    regions_.for_each_meeting(s, around, [&](std::size_t q) {
      if (is_exterior(q)) return;
      const auto d = regions_.distance(link_between(r, q), rule_.reach);
      if (d.has_value()) visit(q, *d);
    });
  }

  [[nodiscard]] Point2 centre(std::size_t r) const {
    const auto& [low, high] = regions_.box[r];
    return {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }

  // Region r, single on the side of section `to`, onto the regions there that are single too.
  void move_on(std::size_t r, std::size_t from, std::size_t to) {
    std::vector<std::size_t> goals;
    for_each_within_reach(r, to, [&](std::size_t q, double) {
      if (partners(q, regions_.section[r]).empty()) goals.push_back(q);
    });
    if (goals.empty()) return;
    const std::optional<std::size_t> before = origin(r, from);
    if (!before.has_value()) return;
    const std::size_t here = regions_.section[r];
    const double longer = regions_.gap(here, to) / regions_.gap(from, here);
    const Point2 now = centre(r);
    const Point2 then = centre(*before);
    const auto there =
        shifted(regions_.shape[r], {(now.x - then.x) * longer, (now.y - then.y) * longer});
    if (!there.has_value()) return;
    const RegionOutline shape = there->shape();
    for (const std::size_t q : goals) {
      Met& met = met_[link_between(r, q)];
      met.ratio = std::max(met.ratio, overlap_ratio(shape, regions_.shape[q]));
      if (compare_overlap(shape, regions_.shape[q], kChainOverlap) == Sign::positive) {
        met.far_enough = true;
      }
    }
  }

  const Regions& regions_;
  LinkedRegions linked_;
  ChainRule rule_;
  std::map<Link, Met> met_;
};

}  // namespace

std::vector<Candidate> chain_links(const Regions& regions, const std::vector<Link>& by_criterion,
                                   const ChainRule& rule) {
  return ChainFinder(regions, by_criterion, rule).run();
}

}  // namespace tetloft::internal::checking
