// Oblique tubes: a region that nothing overlaps is moved on by as much as it moved from the
// section before, in proportion to the gaps, and is matched with what it overlaps there.
#include "correspondence/drift_links.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <tetloft/overlap.hpp>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "correspondence/contour_box.hpp"

namespace tetloft::internal {

namespace {

// The links of a region in one slab: how many, and with which region the last of them is.
struct Partners {
  std::size_t count = 0;
  RegionId last;
};

using RegionPartners = IdVector<RegionId, Partners>;

RegionPartners partners_of(std::size_t regions, const std::vector<Link>& links, bool upper) {
  RegionPartners result(regions);
  for (const Link& link : links) {
    Partners& partners = result[upper ? link.upper : link.lower];
    ++partners.count;
    partners.last = upper ? link.lower : link.upper;
  }
  return result;
}

// A section and its regions.
struct Regions {
  const Section& section;
  const Nesting& nesting;
  [[nodiscard]] std::size_t size() const { return nesting.outer.size(); }
  [[nodiscard]] ContourBox box(RegionId r) const {
    return box_of(section.contours[nesting.outer[r]]);
  }
  [[nodiscard]] Point2 centre(RegionId r) const {
    const ContourBox b = box(r);
    return {(b.low.x + b.high.x) / 2, (b.low.y + b.high.y) / 2};
  }
};

// A region's outline as a section of its own; contour 0 is the outer one.
struct MovedRegion {
  Section section;
  Nesting nesting;
  [[nodiscard]] RegionOutline outline() const {
    return tetloft::outline(section, nesting, RegionId(0));
  }
};

// Nothing where rounding leaves no such region.
std::optional<MovedRegion> moved(const Regions& regions, RegionId r, const Point2& by) {
  Section section{regions.section.z, {}};
  for (const Contour* contour : outline(regions.section, regions.nesting, r).contours) {
    Contour copy = *contour;
    for (Point2& p : copy.vertices) p = {p.x + by.x, p.y + by.y};
    section.contours.push_back(std::move(copy));
  }
  SectionStack alone;
  alone.sections.push_back(std::move(section));
  if (!accepted(validate(alone))) return std::nullopt;
  MovedRegion result{std::move(alone.sections[SectionId(0)]), {}};
  result.nesting = nest(result.section);
  const IdVector<RegionId, ContourId>& outer = result.nesting.outer;
  if (outer.size() != 1 || outer[RegionId(0)] != ContourId(0)) return std::nullopt;
  return result;
}

// The single regions of a slab's two sections, and those of them that are moved from one
// section to the other.
class SlabSingles {
 public:
  SlabSingles(const Regions& below, const Regions& above, const std::vector<Link>& links)
      : below_{below, partners_of(below.size(), links, false)},
        above_{above, partners_of(above.size(), links, true)} {}

  // Calls match(r, q) for each single region r of one section, moved on from `behind`, and
  // single region q of the other that it overlaps. partners: those of r in the slab behind.
  template <class Match>
  void match_moved(bool upwards, const Regions& behind, const RegionPartners& partners,
                   double drift, const Match& match) const {
    const Side& from = upwards ? below_ : above_;
    const Side& to = upwards ? above_ : below_;
    const double z = from.regions.section.z;
    const double scale = std::abs(to.regions.section.z - z) / std::abs(z - behind.section.z);
    for (std::size_t r = 0; r < from.regions.size(); ++r) {
      const RegionId region(r);
      if (!from.is_single(region) || partners[region].count != 1) continue;
      const Point2 here = from.regions.centre(region);
      const Point2 there = behind.centre(partners[region].last);
      const auto on =
          moved(from.regions, region, {(here.x - there.x) * scale, (here.y - there.y) * scale});
      if (!on) continue;
      const ContourBox box = box_of(on->section.contours[ContourId(0)]);
      for (std::size_t q = 0; q < to.regions.size(); ++q) {
        const RegionId other(q);
        if (!to.is_single(other) || !box.meets(to.regions.box(other))) continue;
        const RegionOutline met = outline(to.regions.section, to.regions.nesting, other);
        if (compare_overlap(on->outline(), met, drift) == Sign::positive) match(region, other);
      }
    }
  }

 private:
  struct Side {
    Regions regions;
    RegionPartners partners;
    [[nodiscard]] bool is_single(RegionId r) const { return partners[r].count == 0; }
  };
  Side below_;
  Side above_;
};

}  // namespace

std::vector<Link> drift_links(SlabId slab, const SectionStack& stack,
                              const IdVector<SectionId, Nesting>& nestings,
                              const IdVector<SlabId, std::vector<Link>>& overlap, double drift) {
  const auto regions = [&](std::size_t s) {
    return Regions{stack.sections[SectionId(s)], nestings[SectionId(s)]};
  };
  const std::size_t k = slab.index();
  const Regions below = regions(k);
  const Regions above = regions(k + 1);
  const SlabSingles singles(below, above, overlap[slab]);
  std::vector<Link> links;
  if (k > 0) {
    singles.match_moved(true, regions(k - 1),
                        partners_of(below.size(), overlap[SlabId(k - 1)], true), drift,
                        [&](RegionId r, RegionId q) {
                          links.push_back({slab, r, q});
                        });
  }
  if (k + 1 < overlap.size()) {
    singles.match_moved(false, regions(k + 2),
                        partners_of(above.size(), overlap[SlabId(k + 1)], false), drift,
                        [&](RegionId r, RegionId q) {
                          links.push_back({slab, q, r});
                        });
  }
  sort_distinct(links);
  return links;
}

}  // namespace tetloft::internal
