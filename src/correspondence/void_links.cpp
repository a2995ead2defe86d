// Which voids overlap is read off the faces of the overlay: of many holes under one large outline
// only those are measured that cross it.
#include "correspondence/void_links.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/voids.hpp>

#include "core/sort_distinct.hpp"
#include "correspondence/overlap_links.hpp"
#include "sections/complement.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

using sections::FaceSide;
using sections::kExterior;
using sections::OverlayFace;

// The outermost contours of a section, by their boxes.
class Outermost {
 public:
  explicit Outermost(const RegionOutline& exterior)
      : contours_(exterior.contours.begin() + 1, exterior.contours.end()),
        boxes_(boxes_of(contours_)),
        tree_(boxes_) {}

  // Calls visit(contour, box) for those whose boxes meet this one, in any order.
  template <class Visit>
  void for_each_near(const Box2& near, const Visit& visit) const {
    tree_.query(near, [&](std::size_t c) { visit(contours_[c], boxes_[c]); });
  }

 private:
  static std::vector<Box2> boxes_of(const std::vector<const Contour*>& contours) {
    std::vector<Box2> boxes(contours.size());
    for (std::size_t c = 0; c < contours.size(); ++c) {
      for (const Point2& p : contours[c]->vertices) boxes[c].add(p);
    }
    return boxes;
  }

  std::vector<const Contour*> contours_;
  std::vector<Box2> boxes_;
  BoxTree2 tree_;
};

// The exterior near a hole: its contours that may meet the hole, in a square around them that is
// large enough. Its overlap with the hole is that of the whole exterior.
class ExteriorNear {
 public:
  ExteriorNear(const Outermost& outermost, const Box2& hole) {
    Box2 around = hole;
    outline_.contours.push_back(&frame_);
    outermost.for_each_near(hole, [&](const Contour* contour, const Box2& box) {
      around.add(box);
      outline_.contours.push_back(contour);
    });
    // Contours have a ninth of its area at most: the rest is more than the hole has.
    const Box2 box = grown(around, std::max(around.x1 - around.x0, around.y1 - around.y0));
    frame_.vertices = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  }
  ExteriorNear(const ExteriorNear&) = delete;
  ExteriorNear& operator=(const ExteriorNear&) = delete;

  [[nodiscard]] const RegionOutline& outline() const { return outline_; }

 private:
  Contour frame_;
  RegionOutline outline_;
};

// The voids of two sections, to measure pairs of them, of which one is a hole.
class VoidOutlines {
 public:
  VoidOutlines(const SectionRegions& below, const SectionRegions& above)
      : below_(below), above_(above) {}

  // Calls with(a, b): the outlines of two, of an exterior what is near the hole.
  template <class With>
  void for_pair(RegionId lower, RegionId upper, const With& with) {
    if (lower == kExterior) {
      const ExteriorNear near(outermost(below_, lower_), above_.box[upper]);
      with(near.outline(), above_.outline[upper]);
    } else if (upper == kExterior) {
      const ExteriorNear near(outermost(above_, upper_), below_.box[lower]);
      with(below_.outline[lower], near.outline());
    } else {
      with(below_.outline[lower], above_.outline[upper]);
    }
  }

  [[nodiscard]] double ratio(RegionId lower, RegionId upper) {
    double ratio = 0;
    for_pair(lower, upper,
             [&](const RegionOutline& a, const RegionOutline& b) { ratio = overlap_ratio(a, b); });
    return ratio;
  }

 private:
  static const Outermost& outermost(const SectionRegions& section,
                                    std::optional<Outermost>& known) {
    if (!known) known.emplace(section.outline[kExterior]);
    return *known;
  }

  const SectionRegions& below_;
  const SectionRegions& above_;
  std::optional<Outermost> lower_, upper_;  // once asked for
};

// What lies across from each void of a section, if that is one void alone.
class WhollyWithin {
 public:
  explicit WhollyWithin(std::size_t voids) : across_(voids), sole_(voids, 1) {}

  void add(RegionId of_void, const FaceSide& across) {
    std::optional<FaceSide>& known = across_[of_void];
    if (known && *known != across) sole_[of_void] = 0;
    known = across;
  }
  [[nodiscard]] bool one(RegionId of_void) const {
    return of_void != kExterior && sole_[of_void] != 0;
  }

 private:
  IdVector<RegionId, std::optional<FaceSide>> across_;
  IdVector<RegionId, std::uint8_t> sole_;
};

// V0, of one slab.
class BetweenRegions {
 public:
  BetweenRegions(SlabId slab, const sections::FaceOverlay& overlay, const RegionsAround& regions)
      : slab_(slab), overlay_(overlay), regions_(regions) {}

  [[nodiscard]] bool holds(const OverlayFace& face) const {
    if (face.chi != 0 || face.border.size() != 2) return false;
    const sections::BorderRegion& below = face.border[0];
    const sections::BorderRegion& above = face.border[1];
    if (below.upper || !above.upper) return false;
    if (!are_linked(below.region, above.region)) return false;
    if (are_linked(regions_.below[face.lower.id], regions_.above[face.upper.id])) return false;
    return std::none_of(overlay_.meetings().begin(), overlay_.meetings().end(),
                        [&](const auto& meeting) {
                          return meeting.lower == below.region && meeting.upper == above.region;
                        });
  }

 private:
  [[nodiscard]] bool are_linked(RegionId below, RegionId above) const {
    return std::binary_search(regions_.links.begin(), regions_.links.end(),
                              Link{slab_, below, above});
  }

  SlabId slab_;
  const sections::FaceOverlay& overlay_;
  const RegionsAround& regions_;
};

// Void by void, of one slab.
class Rims {
 public:
  Rims(SlabId slab, const SectionRegions& below, const SectionRegions& above,
       const SlabCandidates& candidates, const VoidOptions& rule)
      : slab_(slab),
        below_(below),
        above_(above),
        candidates_(candidates),
        rule_(rule),
        outlines_(below, above) {}

  [[nodiscard]] SlabCandidates links() {
    IdVector<RegionId, std::uint8_t> linked_below(below_.size(), 0);
    IdVector<RegionId, std::uint8_t> linked_above(above_.size(), 0);
    linked_below[kExterior] = linked_above[kExterior] = 1;
    for (const LinkCandidate& candidate : candidates_) {
      if (!candidate.made()) continue;
      linked_below[candidate.link.lower] = linked_above[candidate.link.upper] = 1;
    }
    SlabCandidates links;
    for (const bool upper : {false, true}) {
      const auto& linked = upper ? linked_above : linked_below;
      for (const RegionId r : linked.ids()) {
        if (linked[r] != 0) continue;
        if (const auto link = nearest(upper, r)) links.push_back(*link);
      }
    }
    return links;
  }

 private:
  [[nodiscard]] std::optional<LinkCandidate> nearest(bool upper, RegionId hole) {
    const bool near = rule_.rule == VoidRule::near;
    const double reach = near ? rule_.reach : kRimReach;
    // Farther than it reaches, so that what was nearest can be told.
    double lookout = std::max(reach, kVoidChainReach);
    std::optional<LinkCandidate> best;
    const auto try_void = [&](RegionId across) {
      const Link link = upper ? Link{slab_, across, hole} : Link{slab_, hole, across};
      if (is_outruled(link)) return;
      const auto d = gaps_apart(below_, link.lower, above_, link.upper, lookout);
      if (!d || (best && !(*d < best->distance))) return;
      best = LinkCandidate{link, Evidence::rim};
      best->distance = lookout = *d;
    };
    try_void(kExterior);
    if (near) {
      const SectionRegions& own = upper ? above_ : below_;
      const SectionRegions& other = upper ? below_ : above_;
      const Box2 around = grown(own.box[hole], lookout * (above_.z - below_.z));
      other.for_each_near(around, [&](RegionId across) {
        if (across != kExterior) try_void(across);
      });
    }
    if (!best) return std::nullopt;
    if (best->distance == 0) best->ratio = outlines_.ratio(best->link.lower, best->link.upper);
    best->moved = best->ratio;
    best->margin = reach - best->distance;
    if (!(best->distance < reach)) best->fate = LinkFate::too_weak;
    return best;
  }

  [[nodiscard]] bool is_outruled(const Link& link) const {
    const auto at = std::lower_bound(
        candidates_.begin(), candidates_.end(), link,
        [](const LinkCandidate& candidate, const Link& other) { return candidate.link < other; });
    return at != candidates_.end() && at->link == link && at->fate == LinkFate::outruled;
  }

  SlabId slab_;
  const SectionRegions& below_;
  const SectionRegions& above_;
  const SlabCandidates& candidates_;
  const VoidOptions& rule_;
  VoidOutlines outlines_;
};

}  // namespace

double void_ratio(const SectionRegions& below, RegionId lower, const SectionRegions& above,
                  RegionId upper) {
  return VoidOutlines(below, above).ratio(lower, upper);
}

SlabCandidates overlapping_voids(SlabId slab, const SectionRegions& below,
                                 const SectionRegions& above, const sections::FaceOverlay& overlay,
                                 const RegionsAround& regions) {
  std::vector<std::pair<RegionId, RegionId>> pairs;
  std::vector<std::pair<RegionId, RegionId>> open;  // those with a face that V0 leaves
  const BetweenRegions between(slab, overlay, regions);
  WhollyWithin lower_within(below.size());
  WhollyWithin upper_within(above.size());
  for (const OverlayFace& face : overlay.faces()) {
    if (!face.lower.solid) lower_within.add(face.lower.id, face.upper);
    if (!face.upper.solid) upper_within.add(face.upper.id, face.lower);
    if (face.lower.solid || face.upper.solid) continue;
    if (face.lower.id != kExterior || face.upper.id != kExterior) {
      pairs.emplace_back(face.lower.id, face.upper.id);
      if (!between.holds(face)) open.push_back(pairs.back());
    }
  }
  sort_distinct(pairs);
  sort_distinct(open);
  VoidOutlines outlines(below, above);
  SlabCandidates candidates;
  for (const auto& [lower, upper] : pairs) {
    LinkCandidate candidate{{slab, lower, upper}};
    if (lower_within.one(lower) || upper_within.one(upper)) {
      candidate.ratio = 1;
    } else {
      outlines.for_pair(lower, upper, [&](const RegionOutline& a, const RegionOutline& b) {
        candidate.ratio = overlap_ratio(a, b);
        if (compare_overlap(a, b, kVoidOverlap, candidate.ratio) != Sign::positive) {
          candidate.fate = LinkFate::too_weak;
        }
      });
    }
    candidate.moved = candidate.ratio;
    candidate.margin = candidate.ratio - kVoidOverlap;
    if (!std::binary_search(open.begin(), open.end(), std::pair(lower, upper))) {
      candidate.fate = LinkFate::outruled;
    }
    candidates.push_back(candidate);
  }
  return candidates;
}

SlabCandidates rim_links(SlabId slab, const SectionRegions& below, const SectionRegions& above,
                         const SlabCandidates& candidates, const VoidOptions& rule) {
  return Rims(slab, below, above, candidates, rule).links();
}

}  // namespace tetloft::internal
