// Rule 3: a region that has no candidate on any side is joined with one that is near.
#include <set>
#include <tuple>

#include "check/partition.hpp"

namespace tetloft::internal::checking {

namespace {

class LoneFinder {
 public:
  LoneFinder(const Regions& regions, const MovedRatios& m) : regions_(regions), m_(m) {}

  // The link that region r prefers.
  [[nodiscard]] std::optional<Link> preferred(std::size_t r) const {
    std::set<Choice> choices;
    const std::size_t s = regions_.section[r];
    if (s > 0) add_choices(r, s - 1, choices);
    if (s + 1 < regions_.section_count()) add_choices(r, s + 1, choices);
    if (choices.empty()) return std::nullopt;
    return link_between(r, std::get<2>(*choices.begin()));
  }

 private:
  // −s, the slab, the other region: the best first.
  using Choice = std::tuple<double, std::size_t, std::size_t>;

  void add_choices(std::size_t r, std::size_t other_section, std::set<Choice>& choices) const {
    const double gap = regions_.gap(regions_.section[r], other_section);
    const bool small = compare_area(regions_.shape[r], gap / 2) == Sign::negative;
    const double reach = small ? kSmallLoneReach : kLoneReach;
    const std::size_t slab = std::min(regions_.section[r], other_section);
    const Box2 around = surroundings(regions_.box[r], reach * gap);
    regions_.for_each_meeting(other_section, around, [&](std::size_t q) {
      const Link pair = link_between(r, q);
      const std::optional<double> d = regions_.distance(pair, reach);
      if (d.has_value() && *d < reach) choices.emplace(*d - m_(pair), slab, q);
    });
  }

  const Regions& regions_;
  const MovedRatios& m_;
};

}  // namespace

std::vector<Link> lone_links(const Regions& regions, const MovedRatios& m,
                             const std::vector<Link>& candidates) {
  const LinkedRegions linked(regions.size(), candidates);
  const LoneFinder finder(regions, m);
  std::set<Link> links;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (!linked.up[r].empty() || !linked.down[r].empty()) continue;
    if (const auto link = finder.preferred(r)) links.insert(*link);
  }
  return {links.begin(), links.end()};
}

}  // namespace tetloft::internal::checking
