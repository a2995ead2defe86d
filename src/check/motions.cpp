#include "check/motions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/unit_of_length.hpp"

namespace tetloft::internal::checking {

namespace {

// Regions at rest, and all passages they rest in. A region that overlaps nothing is in motion.
class Rest {
 public:
  explicit Rest(const Regions& regions) : regions_(regions) {
    for (std::size_t a = 0; a < regions.size(); ++a) {
      const std::size_t above = regions.section[a] + 1;
      if (above == regions.section_count()) continue;
      regions.for_each_meeting(above, regions.box[a], [&](std::size_t b) { look_at({a, b}); });
    }
  }

  [[nodiscard]] bool at_rest(const Passage& passage) const {
    const auto met = met_.find(passage);
    if (met == met_.end() || weak_.count(passage) != 0) return false;
    return std::none_of(met->second.begin(), met->second.end(), [&](std::size_t partner) {
      return weak_.count({partner, !passage.up}) != 0;
    });
  }

 private:
  void look_at(const Link& link) {
    const RegionOutline& low = regions_.shape[link.lower];
    const RegionOutline& high = regions_.shape[link.upper];
    const std::array<Sign, 2> sign = compare_overlap(low, high, {0.0, kRestOverlap});
    if (sign[0] != Sign::positive) return;
    met_[{link.lower, true}].push_back(link.upper);
    met_[{link.upper, false}].push_back(link.lower);
    if (sign[1] != Sign::negative) return;
    weak_.insert({link.lower, true});
    weak_.insert({link.upper, false});
  }

  const Regions& regions_;
  std::map<Passage, std::vector<std::size_t>> met_;  // what a region overlaps
  std::set<Passage> weak_;                           // some of it by less than rest takes
};

std::size_t other_section(const Regions& regions, const Passage& passage) {
  return regions.section[passage.region] + (passage.up ? 1 : std::size_t(-1));
}

bool has_something_near(const Regions& regions, const Passage& passage) {
  const std::size_t other = other_section(regions, passage);
  const double gap = regions.gap(regions.section[passage.region], other);
  const auto& [low, high] = regions.box[passage.region];
  bool found = false;
  regions.for_each_meeting(other, {{low.x - gap, low.y - gap}, {high.x + gap, high.y + gap}},
                           [&](std::size_t) { found = true; });
  return found;
}

std::string text_of(const RegionMotion& claim) {
  return "motion in slab " + std::to_string(claim.slab.index()) + " of the region of " +
         (claim.upper ? "upper" : "lower") + " contour " + std::to_string(claim.contour.index());
}

}  // namespace

std::vector<Passage> moving_passages(const Regions& regions) {
  const Rest rest(regions);
  std::vector<Passage> moving;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const bool up : {false, true}) {
      const bool at_end = regions.section[r] == (up ? regions.section_count() - 1 : 0);
      if (at_end || rest.at_rest({r, up}) || !has_something_near(regions, {r, up})) continue;
      moving.push_back({r, up});
    }
  }
  return moving;
}

ClaimedMotions claimed_motions(const Regions& regions, std::span<const RegionMotion> claims) {
  const std::vector<Passage> moving = moving_passages(regions);
  ClaimedMotions result;
  for (const RegionMotion& claim : claims) {
    const auto wrong = [&](const char* why) { result.wrong.push_back(text_of(claim) + why); };
    const std::size_t slab = claim.slab.index();
    if (!claim.slab.valid() || slab + 1 >= regions.section_count()) {
      wrong(": no such slab");
      continue;
    }
    const std::size_t s = slab + (claim.upper ? 1 : 0);
    if (claim.contour.index() >= regions.nesting[s].region.size() ||
        !regions.is_outer(s, claim.contour.index())) {
      wrong(": no outer contour");
      continue;
    }
    if (!std::isfinite(claim.by.x) || !std::isfinite(claim.by.y)) {
      wrong(": not finite");
      continue;
    }
    const Passage passage{regions.of(s, claim.contour.index()), !claim.upper};
    if (!std::binary_search(moving.begin(), moving.end(), passage)) {
      wrong(": the region is at rest, or nothing is near it");
      continue;
    }
    if (!result.motions.emplace(passage, claim.by).second) wrong(": told twice");
  }
  return result;
}

Motions in_unit(Motions motions, int exponent) {
  for (auto& [passage, by] : motions) by = scaled(by, exponent);
  return motions;
}

MovedRatios::MovedRatios(const Regions& regions, const Motions& motions) : regions_(regions) {
  for (const auto& [passage, by] : motions) {
    if (by.x == 0 && by.y == 0) continue;
    const Point2 d = passage.up ? by : Point2{-by.x, -by.y};
    there_.emplace(passage, shifted(regions.shape[passage.region], d));
  }
}

double MovedRatios::operator()(const Link& link) const {
  const Passage up{link.lower, true};
  const Passage down{link.upper, false};
  if (there_.count(up) == 0 && there_.count(down) == 0) return regions_.ratio(link);
  return (one_way(up, link.upper) + one_way(down, link.lower)) / 2;
}

double MovedRatios::one_way(const Passage& moving, std::size_t still) const {
  const auto there = there_.find(moving);
  if (there == there_.end()) return regions_.ratio(link_between(moving.region, still));
  const std::optional<ShiftedRegion>& region = there->second;
  if (!region.has_value() || !region->box.meets(regions_.box[still])) return 0;
  return overlap_ratio(region->shape(), regions_.shape[still]);
}

std::vector<Link> MovedRatios::pairs() const {
  std::set<Link> pairs;
  const auto add = [&](std::size_t r, const Box2& box, std::size_t other_section) {
    regions_.for_each_meeting(other_section, box,
                              [&](std::size_t q) { pairs.insert(link_between(r, q)); });
  };
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const std::size_t above = regions_.section[r] + 1;
    if (above < regions_.section_count()) add(r, regions_.box[r], above);
  }
  for (const auto& [passage, region] : there_) {
    if (region.has_value()) {
      add(passage.region, region->box, other_section(regions_, passage));
    }
  }
  return {pairs.begin(), pairs.end()};
}

double score(const Regions& regions, const MovedRatios& m, const Link& link) {
  return m(link) - regions.distance(link).value();
}

}  // namespace tetloft::internal::checking
