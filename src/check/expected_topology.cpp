#include "check/expected_topology.hpp"

#include <algorithm>

#include "core/union_find.hpp"

namespace tetloft::internal::checking {

namespace {

// Regions and voids are numbered from the slab's lowest ones on.
class SlabReckoning {
 public:
  SlabReckoning(const StackVoids& stack, const Faces& faces, std::size_t slab)
      : stack_(stack),
        faces_(faces),
        slab_(slab),
        regions_(stack.regions()),
        voids_(stack.voids()),
        solid_(regions_.first[slab + 2] - regions_.first[slab]),
        pieces_(solid_.size()),
        met_(solid_.size()),
        groups_(solid_.size()),
        hollow_(voids_.first[slab + 2] - voids_.first[slab]),
        hollow_pieces_(hollow_.size()),
        hollow_met_(hollow_.size()),
        chi_(solid_.size()) {}

  void link_regions(const Link& link) {
    solid_.unite(link.lower - first_region(), link.upper - first_region());
  }
  void link_voids(const Link& link) {
    hollow_.unite(link.lower - first_void(), link.upper - first_void());
  }

  SlabTopology run() {
    for (std::size_t r = 0; r < solid_.size(); ++r) {
      chi_[solid_.find(r)].add(chi_of_region(regions_, first_region() + r));
    }
    for (const sections::RegionMeeting& meeting : faces_.meetings) count_solid(meeting);
    for (const sections::VoidTouch& touch : faces_.touching_voids) {
      const std::size_t lower = number(voids_, false, touch.lower);
      const std::size_t upper = number(voids_, true, touch.upper);
      if (!hollow_.same(lower, upper)) continue;
      hollow_met_.unite(lower, upper);
      // What is of two classes cannot be solid there.
      const bool void_only = !solid_.same(number(regions_, false, touch.lower_region),
                                          number(regions_, true, touch.upper_region));
      if (void_only) hollow_pieces_.unite(lower, upper);
    }
    for (const sections::OverlayFace& face : faces_.faces) {
      if (!face.lower.solid && !face.upper.solid) count_void(face);
    }
    count_bars();
    count_tunnels();
    return result();
  }

 private:
  [[nodiscard]] std::size_t first_region() const { return regions_.first[slab_]; }
  [[nodiscard]] std::size_t first_void() const { return voids_.first[slab_]; }
  [[nodiscard]] std::size_t number(const Regions& of, bool upper, RegionId id) const {
    return of.first[slab_ + (upper ? 1 : 0)] - of.first[slab_] + id.index();
  }

  void count_solid(const sections::RegionMeeting& meeting) {
    const std::size_t lower = number(regions_, false, meeting.lower);
    const std::size_t upper = number(regions_, true, meeting.upper);
    if (!solid_.same(lower, upper)) return;
    ChiRange& chi = chi_[solid_.find(lower)];
    chi.add(-meeting.chi);
    chi.least -= meeting.touches;
    chi.most += meeting.connections;
    met_.unite(lower, upper);
    if (meeting.overlap) pieces_.unite(lower, upper);
  }

  void count_void(const sections::OverlayFace& face) {
    const std::size_t lower = number(voids_, false, face.lower.id);
    const std::size_t upper = number(voids_, true, face.upper.id);
    if (hollow_.same(lower, upper)) {
      hollow_pieces_.unite(lower, upper);
      hollow_met_.unite(lower, upper);
      return;
    }
    // A plate hangs on all that is around, and holds together what is of one class there.
    std::map<std::size_t, std::size_t> first_of_class;
    for (const sections::BorderRegion& border : face.border) {
      const std::size_t r = number(regions_, border.upper, border.region);
      const auto [first, fresh] = first_of_class.emplace(solid_.find(r), r);
      if (!fresh) {
        pieces_.unite(first->second, r);
        met_.unite(first->second, r);
      }
      groups_.unite(first_of_class.begin()->first, solid_.find(r));
    }
    if (!first_of_class.empty()) chi_[first_of_class.begin()->first].add(face.chi);
  }

  // Pieces that faces leave apart need bars, but for those that touch.
  void count_bars() {
    for (std::size_t r = 0; r < solid_.size(); ++r) {
      if (solid_.find(r) == r) continue;
      ChiRange& chi = chi_[solid_.find(r)];
      if (pieces_.find(r) == r) --chi.most;
      if (met_.find(r) == r) --chi.least;
    }
  }

  void count_tunnels() {
    std::map<std::size_t, ChiRange> tunnels;  // by void class, where there are any
    for (std::size_t v = 0; v < hollow_.size(); ++v) {
      if (hollow_.find(v) == v || hollow_pieces_.find(v) != v) continue;
      ChiRange& of_class = tunnels[hollow_.find(v)];
      --of_class.most;
      if (hollow_met_.find(v) == v) --of_class.least;
    }
    std::map<std::size_t, std::size_t> around;  // of void classes with tunnels
    for (std::size_t v = 0; v < hollow_.size(); ++v) {
      const auto of_class = tunnels.find(hollow_.find(v));
      if (of_class == tunnels.end() || stack_.is_exterior(first_void() + v)) continue;
      const std::size_t region = stack_.region_around(first_void() + v) - first_region();
      const auto [first, fresh] = around.emplace(hollow_.find(v), solid_.find(region));
      if (fresh) {
        chi_[first->second].least += of_class->second.least;
        chi_[first->second].most += of_class->second.most;
      }
      groups_.unite(first->second, solid_.find(region));
    }
  }

  [[nodiscard]] SlabTopology result() const {
    SlabTopology slab;
    slab.first = first_region();
    for (std::size_t r = 0; r < solid_.size(); ++r) {
      const std::size_t of_class = solid_.find(r);
      const std::size_t group = groups_.find(of_class);
      slab.class_of.push_back(slab.first + of_class);
      slab.group_of.push_back(slab.first + group);
      if (of_class != r) continue;
      slab.chi[slab.first + group].least += chi_[r].least;
      slab.chi[slab.first + group].most += chi_[r].most;
    }
    return slab;
  }

  const StackVoids& stack_;
  const Faces& faces_;
  std::size_t slab_;
  const Regions& regions_;
  const Regions& voids_;
  UnionFind solid_;   // classes of regions
  UnionFind pieces_;  // of a class, which its faces hold together
  UnionFind met_;     // the same with what touches
  UnionFind groups_;  // of classes, by their lowest regions
  UnionFind hollow_;  // classes of voids
  UnionFind hollow_pieces_;
  UnionFind hollow_met_;
  std::vector<ChiRange> chi_;  // of a class, by its lowest region
};

}  // namespace

long chi_of_region(const Regions& regions, std::size_t region) {
  return 2 - static_cast<long>(regions.shape[region].contours.size());
}

std::vector<SlabTopology> expected_topology(const StackVoids& stack,
                                            const std::vector<Faces>& faces,
                                            const std::vector<Link>& links,
                                            const ExpectedVoids& voids) {
  std::vector<SlabTopology> slabs;
  auto link = links.begin();
  auto void_link = voids.links.begin();
  auto forced = voids.forced.begin();
  for (std::size_t s = 0; s + 1 < stack.section_count(); ++s) {
    SlabReckoning slab(stack, faces[s], s);
    for (; link != links.end() && stack.regions().section[link->lower] == s; ++link) {
      slab.link_regions(*link);
    }
    for (; void_link != voids.links.end() && stack.voids().section[void_link->lower] == s;
         ++void_link) {
      slab.link_voids(*void_link);
    }
    for (; forced != voids.forced.end() && forced->slab == s; ++forced) {
      slab.link_voids(forced->voids);
    }
    slabs.push_back(slab.run());
  }
  return slabs;
}

ChiRange expected_chi(const StackVoids& stack, const std::vector<SlabTopology>& slabs) {
  const Regions& regions = stack.regions();
  ChiRange chi;
  for (const SlabTopology& slab : slabs) {
    for (const auto& [group, of_group] : slab.chi) {
      chi.least += of_group.least;
      chi.most += of_group.most;
    }
  }
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const std::size_t s = regions.section[r];
    if (slabs.empty()) chi.add(chi_of_region(regions, r));
    if (s > 0 && s + 1 < regions.section_count()) chi.add(-chi_of_region(regions, r));
  }
  return chi;
}

std::vector<std::size_t> expected_void_sets(const StackVoids& stack, const ExpectedVoids& links) {
  const Regions& voids = stack.voids();
  UnionFind sets(voids.size());
  for (const Link& link : links.links) sets.unite(link.lower, link.upper);
  for (const SlabVoids& pair : links.forced) sets.unite(pair.voids.lower, pair.voids.upper);
  for (std::size_t v = 0; v < voids.size(); ++v) {
    const std::size_t s = voids.section[v];
    if (s == 0 || s + 1 == voids.section_count()) sets.unite(0, v);
  }
  std::vector<std::size_t> set;
  for (std::size_t v = 0; v < voids.size(); ++v) set.push_back(sets.find(v));
  return set;
}

}  // namespace tetloft::internal::checking
