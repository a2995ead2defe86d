#include "reconstruct/slab_topology.hpp"

#include <algorithm>

#include "core/union_find.hpp"

namespace tetloft::internal {

namespace {

struct Range {
  std::int32_t least = 0, most = 0;
  void add(std::int32_t both) {
    least += both;
    most += both;
  }
};

class TopologyCounter {
 public:
  TopologyCounter(const ConformingSection& lower, const ConformingSection& upper,
                  const SlabFaceLinks& links)
      : nesting_{&lower.nesting, &upper.nesting},
        holes_{voids_of(lower).hole, voids_of(upper).hole},
        regions_(lower.nesting.outer.size(), upper.nesting.outer.size()),
        voids_(holes_[0].size(), holes_[1].size()),
        solid_(regions_.size()),
        pieces_(regions_.size()),
        touched_(regions_.size()),
        void_(voids_.size()),
        void_pieces_(voids_.size()),
        touched_voids_(voids_.size()),
        chi_(regions_.size()) {
    for (const Link& link : links.regions) {
      solid_.unite(regions_.in_slab(false, link.lower).index(),
                   regions_.in_slab(true, link.upper).index());
    }
    void_.unite(exterior(false).index(), exterior(true).index());
    for (const Link& link : links.voids) {
      void_.unite(voids_.in_slab(false, link.lower).index(),
                  voids_.in_slab(true, link.upper).index());
    }
    for (const auto& [a, b] : links.united_voids) void_.unite(a.index(), b.index());
  }

  std::vector<TopologyGroup> count(const sections::FaceOverlay& overlay) {
    for (const bool upper : {false, true}) {
      const Nesting& nesting = *nesting_[upper ? 1 : 0];
      // 1 less for each hole: the outer contour of a region, and its holes.
      for (const RegionId r : nesting.region) chi_[class_of(regions_.in_slab(upper, r))].add(-1);
      for (const RegionId r : nesting.outer.ids()) {
        chi_[class_of(regions_.in_slab(upper, r))].add(2);
      }
    }
    for (const sections::VoidTouch& touch : overlay.touching_voids()) count_touch(touch);
    UnionFind groups(regions_.size());
    for (const sections::RegionMeeting& meeting : overlay.meetings()) count_meeting(meeting);
    for (const sections::OverlayFace& face : overlay.faces()) count_face(face, groups);
    count_bars();
    count_tunnels(groups);
    return gather(groups);
  }

 private:
  [[nodiscard]] SlabVoidId exterior(bool upper) const { return voids_.in_slab(upper, RegionId(0)); }
  // The lowest region of its class.
  [[nodiscard]] SlabRegionId class_of(SlabRegionId r) const {
    return SlabRegionId(solid_.find(r.index()));
  }

  void count_meeting(const sections::RegionMeeting& meeting) {
    const SlabRegionId below = regions_.in_slab(false, meeting.lower);
    const SlabRegionId above = regions_.in_slab(true, meeting.upper);
    if (class_of(below) != class_of(above)) return;
    Range& range = chi_[class_of(below)];
    range.least -= meeting.chi + meeting.touches;
    range.most -= meeting.chi - meeting.connections;
    touched_.unite(below.index(), above.index());
    if (meeting.overlap) pieces_.unite(below.index(), above.index());
  }

  // Regions of different classes cannot be what is there: then it is void.
  void count_touch(const sections::VoidTouch& touch) {
    const std::size_t below = voids_.in_slab(false, touch.lower).index();
    const std::size_t above = voids_.in_slab(true, touch.upper).index();
    if (!void_.same(below, above)) return;
    touched_voids_.unite(below, above);
    const SlabRegionId lower = regions_.in_slab(false, touch.lower_region);
    const SlabRegionId upper = regions_.in_slab(true, touch.upper_region);
    if (class_of(lower) != class_of(upper)) void_pieces_.unite(below, above);
  }

  void count_face(const sections::OverlayFace& face, UnionFind& groups) {
    if (face.lower.solid || face.upper.solid) return;
    const SlabVoidId below = voids_.in_slab(false, face.lower.id);
    const SlabVoidId above = voids_.in_slab(true, face.upper.id);
    if (void_.same(below.index(), above.index())) {
      void_pieces_.unite(below.index(), above.index());
      touched_voids_.unite(below.index(), above.index());
      return;
    }
    // Closed by a plate, which joins what it reaches of one class.
    SlabRegionId first;
    for (const auto& [upper, region] : face.border) {
      const SlabRegionId r = regions_.in_slab(upper, region);
      if (!first.valid()) first = r;
      groups.unite(class_of(first).index(), class_of(r).index());
      for (const auto& [other_upper, other] : face.border) {
        const SlabRegionId q = regions_.in_slab(other_upper, other);
        if (class_of(q) != class_of(r)) continue;
        pieces_.unite(q.index(), r.index());
        touched_.unite(q.index(), r.index());
      }
    }
    chi_[class_of(first)].add(face.chi);
  }

  // Each class is its pieces and a bar less than it has of these.
  void count_bars() {
    for (const SlabRegionId r : chi_.ids()) {
      if (class_of(r) == r) continue;
      if (pieces_.find(r.index()) == r.index()) --chi_[class_of(r)].most;
      if (touched_.find(r.index()) == r.index()) --chi_[class_of(r)].least;
    }
  }

  // The same of void classes: tunnels through the solid around their holes.
  void count_tunnels(UnionFind& groups) {
    IdVector<SlabVoidId, Range> tunnels(voids_.size());
    for (std::size_t v = 0; v < voids_.size(); ++v) {
      Range& of_class = tunnels[SlabVoidId(void_.find(v))];
      if (void_.find(v) == v) continue;
      if (void_pieces_.find(v) == v) ++of_class.most;
      if (touched_voids_.find(v) == v) ++of_class.least;
    }
    IdVector<SlabVoidId, SlabRegionId> around(voids_.size());
    for (const bool upper : {false, true}) {
      const std::vector<ContourId>& holes = holes_[upper ? 1 : 0];
      for (std::size_t v = 1; v < holes.size(); ++v) {
        const SlabVoidId leader(void_.find(voids_.in_slab(upper, RegionId(v)).index()));
        if (tunnels[leader].most == 0) continue;
        const SlabRegionId r =
            class_of(regions_.in_slab(upper, nesting_[upper ? 1 : 0]->region[holes[v]]));
        if (!around[leader].valid()) around[leader] = r;
        groups.unite(around[leader].index(), r.index());
      }
    }
    for (const SlabVoidId v : tunnels.ids()) {
      if (tunnels[v].most == 0) continue;
      chi_[around[v]].least -= tunnels[v].least;
      chi_[around[v]].most -= tunnels[v].most;
    }
  }

  std::vector<TopologyGroup> gather(const UnionFind& groups) const {
    std::vector<TopologyGroup> result;
    IdVector<SlabRegionId, std::size_t> place(regions_.size(), 0);
    for (const SlabRegionId r : chi_.ids()) {
      const SlabRegionId leader(groups.find(class_of(r).index()));
      if (leader == r) {
        place[r] = result.size();
        result.push_back({});
      }
      TopologyGroup& group = result[place[leader]];
      group.regions.push_back(r);
      group.least += chi_[r].least;
      group.most += chi_[r].most;
    }
    return result;
  }

  std::array<const Nesting*, 2> nesting_;
  std::array<std::vector<ContourId>, 2> holes_;
  SlabRegions regions_;
  SlabVoidNumbering voids_;
  UnionFind solid_, pieces_, touched_;  // what touches, too, united
  UnionFind void_, void_pieces_, touched_voids_;
  IdVector<SlabRegionId, Range> chi_;  // at the lowest region of a class
};

}  // namespace

std::int32_t region_chi(const Nesting& nesting, RegionId r) {
  return 2 - static_cast<std::int32_t>(std::count(nesting.region.begin(), nesting.region.end(), r));
}

std::vector<TopologyGroup> expected_topology(const sections::FaceOverlay& overlay,
                                             const ConformingSection& lower,
                                             const ConformingSection& upper,
                                             const SlabFaceLinks& links) {
  return TopologyCounter(lower, upper, links).count(overlay);
}

std::vector<SlabDeviation> deviations(const std::vector<TopologyGroup>& groups,
                                      const SlabClasses& classes,
                                      const IdVector<ClassId, std::int32_t>& chi) {
  std::vector<SlabDeviation> result;
  for (const TopologyGroup& group : groups) {
    std::int32_t got = 0;
    for (const SlabRegionId r : group.regions) {
      const ClassId c = classes.of_region(r);
      if (classes.regions(c).front() == r) got += chi[c];
    }
    if (got < group.least || got > group.most) {
      result.push_back({group.regions.front(), group.least, group.most, got});
    }
  }
  return result;
}

}  // namespace tetloft::internal
