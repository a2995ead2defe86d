#include "corpus/link_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "motion/region_motions.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::bench {

namespace {

using namespace internal;

// A region's outline as a section of its own.
struct Outlined {
  Section section;
  Nesting nesting;
  Box2 box;
  [[nodiscard]] RegionOutline outline() const {
    return tetloft::outline(section, nesting, RegionId(0));
  }
};

// Nothing where rounding leaves no such region.
std::optional<Outlined> moved(const RegionOutline& region, const Point2& by) {
  SectionStack alone;
  Section section;
  for (const Contour* contour : region.contours) {
    Contour copy = *contour;
    for (Point2& p : copy.vertices) p = {p.x + by.x, p.y + by.y};
    section.contours.push_back(std::move(copy));
  }
  alone.sections.push_back(std::move(section));
  if (!validate(alone)) return std::nullopt;
  Outlined result{std::move(alone.sections[SectionId(0)]), {}, {}};
  result.nesting = nest(result.section);
  if (result.nesting.outer.size() != 1) return std::nullopt;
  for (const Point2& p : result.section.contours[ContourId(0)].vertices) result.box.add(p);
  return result;
}

double ratio(const std::optional<Outlined>& a, const std::optional<Outlined>& b) {
  if (!a || !b || !a->box.meets(b->box)) return 0;
  return overlap_ratio(a->outline(), b->outline());
}

double point_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t =
      std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double ex = p.x - a.x - t * dx, ey = p.y - a.y - t * dy;
  return ex * ex + ey * ey;
}

using Segments = std::vector<std::pair<Point2, Point2>>;

// The edges within reach of the box.
Segments edges_near(const RegionOutline& region, Box2 box, double reach) {
  box.x0 -= reach, box.y0 -= reach, box.x1 += reach, box.y1 += reach;
  Segments result;
  for (const Contour* c : region.contours) {
    Point2 last = c->vertices.back();
    for (const Point2& p : c->vertices) {
      if (box_of(last, p).meets(box)) result.emplace_back(last, p);
      last = p;
    }
  }
  return result;
}

// The distance of two outlines that do not overlap, or some number above `reach`.
double distance(const Outlined& a, const Outlined& b, double reach) {
  const Segments s = edges_near(a.outline(), b.box, reach);
  const Segments t = edges_near(b.outline(), a.box, reach);
  double least = 4 * reach * reach;
  for (const auto& e : s) {
    for (const auto& f : t) {
      least = std::min({least, point_segment(e.first, f.first, f.second),
                        point_segment(e.second, f.first, f.second),
                        point_segment(f.first, e.first, e.second),
                        point_segment(f.second, e.first, e.second)});
    }
  }
  return std::sqrt(least);
}

struct Placed {
  std::optional<Outlined> here, whole, half;
};

std::vector<Placed> placed(const Section& section, const Nesting& nesting,
                           const IdVector<RegionId, std::optional<Point2>>& motions, double sign) {
  std::vector<Placed> result;
  for (std::size_t r = 0; r < nesting.outer.size(); ++r) {
    const RegionOutline region = outline(section, nesting, RegionId(r));
    const Point2 u = motions[RegionId(r)].value();
    result.push_back({moved(region, {0, 0}), moved(region, {sign * u.x, sign * u.y}),
                      moved(region, {sign * u.x / 2, sign * u.y / 2})});
  }
  return result;
}

}  // namespace

std::vector<SlabFacts> facts_of(const SectionStack& stack) {
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  std::vector<SlabFacts> result;
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    const SectionId below(k), above(k + 1);
    SlabFacts slab;
    slab.gap = stack.sections[above].z - stack.sections[below].z;
    WantedRegions wanted;
    for (std::size_t r = 0; r < nestings[below].outer.size(); ++r) wanted.lower.emplace_back(r);
    for (std::size_t r = 0; r < nestings[above].outer.size(); ++r) wanted.upper.emplace_back(r);
    const SlabMotions motions = estimate_motions(SlabId(k), stack, nestings, wanted);
    const auto lows = placed(stack.sections[below], nestings[below], motions.lower, 1);
    const auto highs = placed(stack.sections[above], nestings[above], motions.upper, -1);
    for (const Placed& p : lows) slab.low_area.push_back(area(p.here->outline()));
    for (const Placed& p : highs) slab.high_area.push_back(area(p.here->outline()));
    const double reach = kReach * slab.gap;
    for (std::size_t i = 0; i < lows.size(); ++i) {
      for (std::size_t j = 0; j < highs.size(); ++j) {
        Box2 wide = lows[i].here->box;
        wide.x0 -= reach, wide.y0 -= reach, wide.x1 += reach, wide.y1 += reach;
        if (!wide.meets(highs[j].here->box)) continue;
        PairFacts pair{i, j};
        pair.plain = ratio(lows[i].here, highs[j].here);
        if (pair.plain == 0) {
          pair.distance = distance(*lows[i].here, *highs[j].here, reach) / slab.gap;
        }
        if (pair.distance >= kReach) continue;
        pair.moved_low = ratio(lows[i].whole, highs[j].here);
        pair.moved_high = ratio(lows[i].here, highs[j].whole);
        pair.moved_half = ratio(lows[i].half, highs[j].half);
        slab.pairs.push_back(pair);
      }
    }
    result.push_back(std::move(slab));
  }
  return result;
}

}  // namespace tetloft::bench
