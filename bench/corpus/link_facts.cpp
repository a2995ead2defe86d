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

// A region where it lies, and its motion; none where it is at rest.
struct Mover {
  Outlined here;
  Point2 u;
};

std::vector<Mover> movers(const Section& section, const Nesting& nesting,
                          const IdVector<RegionId, std::optional<Point2>>& motions) {
  std::vector<Mover> result;
  for (std::size_t r = 0; r < nesting.outer.size(); ++r) {
    result.push_back({moved(outline(section, nesting, RegionId(r)), {0, 0}).value(), motions[RegionId(r)].value()});
  }
  return result;
}

Point2 scaled(const Point2& u, double by) { return {u.x * by, u.y * by}; }

}  // namespace

std::vector<SlabFacts> facts_of(const SectionStack& stack, double rest) {
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
    auto lows = movers(stack.sections[below], nestings[below], motions.lower);
    auto highs = movers(stack.sections[above], nestings[above], motions.upper);
    for (const Mover& p : lows) slab.low_area.push_back(area(p.here.outline()));
    for (const Mover& p : highs) slab.high_area.push_back(area(p.here.outline()));
    const double reach = kReach * slab.gap;
    std::vector<double> worst_low(lows.size(), 2), worst_high(highs.size(), 2);
    for (std::size_t i = 0; i < lows.size(); ++i) {
      for (std::size_t j = 0; j < highs.size(); ++j) {
        Box2 wide = lows[i].here.box;
        wide.x0 -= reach, wide.y0 -= reach, wide.x1 += reach, wide.y1 += reach;
        if (!wide.meets(highs[j].here.box)) continue;
        PairFacts pair{i, j};
        pair.plain = ratio(lows[i].here, highs[j].here);
        if (pair.plain == 0) {
          pair.distance = distance(lows[i].here, highs[j].here, reach) / slab.gap;
        } else {
          worst_low[i] = std::min(worst_low[i], pair.plain);
          worst_high[j] = std::min(worst_high[j], pair.plain);
        }
        if (pair.distance >= kReach) continue;
        slab.pairs.push_back(pair);
      }
    }
    std::vector<bool> low_rests(lows.size(), false), high_rests(highs.size(), false);
    for (const PairFacts& p : slab.pairs) {
      if (p.plain > 0) low_rests[p.low] = high_rests[p.high] = true;
    }
    for (const PairFacts& p : slab.pairs) {
      if (p.plain == 0 || (worst_low[p.low] >= rest && worst_high[p.high] >= rest)) continue;
      low_rests[p.low] = high_rests[p.high] = false;
    }
    for (std::size_t i = 0; i < lows.size(); ++i) if (low_rests[i]) lows[i].u = {0, 0};
    for (std::size_t j = 0; j < highs.size(); ++j) if (high_rests[j]) highs[j].u = {0, 0};
    std::vector<bool> low(lows.size(), false), high(highs.size(), false);
    for (PairFacts& p : slab.pairs) {
      if (p.distance < 0.9) low[p.low] = high[p.high] = true;
      const Mover& a = lows[p.low];
      const Mover& b = highs[p.high];
      if (low_rests[p.low] && high_rests[p.high]) {
        p.moved_low = p.moved_high = p.moved_joint = p.plain;
        continue;
      }
      const auto mid = [&](double s, double t) { return Point2{s * a.u.x + t * b.u.x, s * a.u.y + t * b.u.y}; };
      p.moved_low = ratio(moved(a.here.outline(), a.u), b.here);
      p.moved_high = ratio(a.here, moved(b.here.outline(), scaled(b.u, -1)));
      p.moved_joint = ratio(moved(a.here.outline(), mid(0.5, 0.5)), b.here);
      p.moved_q = ratio(moved(a.here.outline(), mid(0.75, 0.25)), b.here);
      p.moved_r = ratio(moved(a.here.outline(), mid(0.25, 0.75)), b.here);
    }
    slab.regions = lows.size() + highs.size();
    for (std::size_t i = 0; i < lows.size(); ++i) slab.moving += low[i] && !low_rests[i];
    for (std::size_t i = 0; i < highs.size(); ++i) slab.moving += high[i] && !high_rests[i];
    result.push_back(std::move(slab));
  }
  return result;
}

}  // namespace tetloft::bench
