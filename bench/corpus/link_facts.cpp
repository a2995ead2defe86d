#include "corpus/link_facts.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "corpus/outline_distance.hpp"
#include "correspondence/reverse_links.hpp"
#include "motion/region_motions.hpp"
#include "slab/delaunay.hpp"
#include "slab/slab.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::bench {

namespace {

using namespace internal;

// A region as a section of its own.
struct Alone {
  Section section;
  Nesting nesting;
  Box2 box;
  [[nodiscard]] RegionOutline outline() const {
    return tetloft::outline(section, nesting, RegionId(0));
  }
};

// Nothing where rounding leaves no such region.
std::optional<Alone> moved(const RegionOutline& region, const Point2& by) {
  Section section;
  for (const Contour* contour : region.contours) {
    Contour copy = *contour;
    for (Point2& p : copy.vertices) p = {p.x + by.x, p.y + by.y};
    section.contours.push_back(std::move(copy));
  }
  SectionStack stack;
  stack.sections.push_back(std::move(section));
  if (!validate(stack)) return std::nullopt;
  Alone result{std::move(stack.sections[SectionId(0)]), {}, {}};
  result.nesting = nest(result.section);
  if (result.nesting.outer.size() != 1) return std::nullopt;
  for (const Point2& p : result.section.contours[ContourId(0)].vertices) result.box.add(p);
  return result;
}

double ratio(const std::optional<Alone>& a, const std::optional<Alone>& b) {
  if (!a || !b || !a->box.meets(b->box)) return 0;
  return overlap_ratio(a->outline(), b->outline());
}

// A region of a slab: as it lies, its motion, the least ratio of its overlaps.
struct Region {
  std::optional<Alone> here;
  Point2 motion;
  double least = std::numeric_limits<double>::infinity();
  bool rests = false, wanted = false;
};

std::vector<Region> regions_of(const Section& section, const Nesting& nesting) {
  std::vector<Region> result;
  for (const RegionOutline& region : outlines(section, nesting)) {
    result.push_back({moved(region, {0, 0}), {}});
  }
  return result;
}

// Those within kReach, with what they are as they lie.
std::vector<PairFacts> near_pairs(const std::vector<Region>& lows, const std::vector<Region>& highs,
                                  double gap) {
  std::vector<PairFacts> result;
  const double reach = kReach * gap;
  for (std::size_t i = 0; i < lows.size(); ++i) {
    const Box2& box = lows[i].here->box;
    const Box2 wide{box.x0 - reach, box.y0 - reach, box.x1 + reach, box.y1 + reach};
    for (std::size_t j = 0; j < highs.size(); ++j) {
      if (!wide.meets(highs[j].here->box)) continue;
      PairFacts pair{i, j};
      pair.plain = ratio(lows[i].here, highs[j].here);
      if (pair.plain == 0) {
        pair.distance =
            outline_distance(lows[i].here->outline(), highs[j].here->outline(), reach) / gap;
      }
      if (pair.distance < kReach) result.push_back(pair);
    }
  }
  return result;
}

// Which regions rest, and which are to be moved.
void find_movers(const std::vector<PairFacts>& pairs, double rest, std::vector<Region>& lows,
                 std::vector<Region>& highs) {
  for (const PairFacts& p : pairs) {
    lows[p.low].wanted = highs[p.high].wanted = true;
    if (p.plain == 0) continue;
    lows[p.low].rests = highs[p.high].rests = true;
    lows[p.low].least = std::min(lows[p.low].least, p.plain);
    highs[p.high].least = std::min(highs[p.high].least, p.plain);
  }
  for (const PairFacts& p : pairs) {
    if (p.plain == 0 || std::min(lows[p.low].least, highs[p.high].least) >= rest) continue;
    lows[p.low].rests = highs[p.high].rests = false;
  }
  for (std::vector<Region>* regions : {&lows, &highs}) {
    for (Region& region : *regions) region.wanted = region.wanted && !region.rests;
  }
}

void move(SlabId slab, const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
          std::vector<Region>& lows, std::vector<Region>& highs) {
  const auto wanted = [](const std::vector<Region>& regions) {
    std::vector<RegionId> result;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (regions[r].wanted) result.emplace_back(r);
    }
    return result;
  };
  const SlabMotions motions =
      estimate_motions(slab, stack, nestings, {wanted(lows), wanted(highs)});
  for (std::size_t r = 0; r < lows.size(); ++r) {
    lows[r].motion = motions.lower[RegionId(r)].value_or(Point2{});
  }
  for (std::size_t r = 0; r < highs.size(); ++r) {
    highs[r].motion = motions.upper[RegionId(r)].value_or(Point2{});
  }
}

void compare_moved(const Region& low, const Region& high, PairFacts& pair) {
  if (low.rests && high.rests) {
    pair.moved_low = pair.moved_high = pair.moved_both = pair.plain;
    return;
  }
  const Point2& u = low.motion;
  const Point2& v = high.motion;
  pair.moved_low = ratio(moved(low.here->outline(), u), high.here);
  pair.moved_high = ratio(low.here, moved(high.here->outline(), {-v.x, -v.y}));
  pair.moved_both =
      ratio(moved(low.here->outline(), {(u.x + v.x) / 2, (u.y + v.y) / 2}), high.here);
}

Pairs reverse_pairs(SlabId slab, const ConformingSection& below, const ConformingSection& above) {
  TetMesh mesh = slab_delaunay(slab, below, above, DelaunayEngine::slab,
                               std::numeric_limits<double>::infinity())
                     .value();
  Pairs pairs;
  for (const Link& l : reverse_links(slab, Slab(below, above, std::move(mesh)))) {
    pairs.emplace_back(l.lower.index(), l.upper.index());
  }
  return pairs;
}

}  // namespace

std::vector<SlabFacts> facts_of(const SectionStack& stack, double rest) {
  IdVector<SectionId, Nesting> nestings;
  IdVector<SectionId, ConformingSection> conforming;
  for (const Section& section : stack.sections) {
    nestings.push_back(nest(section));
    conforming.push_back(conform(section, conforming.end_id(), {}).value());
  }
  std::vector<SlabFacts> result;
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    const SectionId below(k), above(k + 1);
    std::vector<Region> lows = regions_of(stack.sections[below], nestings[below]);
    std::vector<Region> highs = regions_of(stack.sections[above], nestings[above]);
    SlabFacts slab;
    slab.gap = stack.sections[above].z - stack.sections[below].z;
    slab.pairs = near_pairs(lows, highs, slab.gap);
    find_movers(slab.pairs, rest, lows, highs);
    move(SlabId(k), stack, nestings, lows, highs);
    for (PairFacts& pair : slab.pairs) compare_moved(lows[pair.low], highs[pair.high], pair);
    for (const Region& r : lows) {
      slab.low_area.push_back(area(r.here->outline()));
      slab.moving += r.wanted ? 1U : 0U;
    }
    for (const Region& r : highs) {
      slab.high_area.push_back(area(r.here->outline()));
      slab.moving += r.wanted ? 1U : 0U;
    }
    slab.reverse = reverse_pairs(SlabId(k), conforming[below], conforming[above]);
    result.push_back(std::move(slab));
  }
  return result;
}

}  // namespace tetloft::bench
