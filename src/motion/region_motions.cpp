#include "motion/region_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <tetloft/overlap.hpp>

#include "motion/distance_samples.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

double env(const char* name, double value) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::atof(text) : value;
}
const double kSteps = env("M_STEPS", 5);        // samples per gap
const double kRadius = env("M_R", 1.2);         // gaps
const double kReach = env("M_REACH", 2.6);      // gaps
const double kStiffness = env("M_LAMBDA", 0.005);
const double kNeighbour = env("M_NB", 0.5);
const double kLimit = env("M_LIMIT", 1.0);

struct SlabSections {
  const Section* section[4] = {nullptr, nullptr, nullptr, nullptr};  // k-1 .. k+2
  double gap = 1, below = 0, above = 0;  // the ratios of gaps
};

struct Shifted {
  long i, j;       // whole steps
  double fx, fy;   // rest
};

Shifted shifted(double i, double j) {
  const double fi = std::floor(i), fj = std::floor(j);
  return {static_cast<long>(fi), static_cast<long>(fj), i - fi, j - fj};
}

// Samples on a window with a margin of m steps.
struct Field {
  std::vector<double> value;
  long nx = 0, ny = 0, margin = 0;
  [[nodiscard]] double at(long i, long j) const {
    return value[static_cast<std::size_t>((j + margin) * nx + i + margin)];
  }
  [[nodiscard]] double at(long i, long j, const Shifted& s) const {
    if (s.fx == 0 && s.fy == 0) return at(i + s.i, j + s.j);
    const long a = i + s.i, b = j + s.j;
    const double low = at(a, b) + s.fx * (at(a + 1, b) - at(a, b));
    const double high = at(a, b + 1) + s.fx * (at(a + 1, b + 1) - at(a, b + 1));
    return low + s.fy * (high - low);
  }
};

Field field(const Section& section, const LatticeWindow& w, long margin, double limit) {
  LatticeWindow wide = w;
  const auto m = static_cast<double>(margin);
  wide.origin = {w.origin.x - m * w.step, w.origin.y - m * w.step};
  wide.nx += static_cast<std::size_t>(2 * margin);
  wide.ny += static_cast<std::size_t>(2 * margin);
  std::vector<const Contour*> contours;
  Box2 box = box_of(wide.origin, {wide.x(wide.nx), wide.y(wide.ny)});
  for (const Contour& c : section.contours) {
    Box2 b;
    for (const Point2& p : c.vertices) b.add(p);
    b.x0 -= limit, b.x1 += limit, b.y0 -= limit, b.y1 += limit;
    if (b.meets(box)) contours.push_back(&c);
  }
  return {signed_distances(contours, wide, limit), static_cast<long>(wide.nx),
          static_cast<long>(wide.ny), margin};
}

Point2 estimate(const SlabSections& slab, bool upper, const RegionOutline& region) {
  Box2 box;
  for (const Point2& p : region.contours.front()->vertices) box.add(p);
  const double reach = kReach * slab.gap;
  const double side = std::max(box.x1 - box.x0, box.y1 - box.y0) + 2 * reach;
  const double step = std::max(slab.gap / kSteps, side / 100);
  LatticeWindow w;
  w.step = step;
  const double i0 = std::floor((box.x0 - reach) / step), j0 = std::floor((box.y0 - reach) / step);
  w.origin = {i0 * step, j0 * step};
  w.nx = static_cast<std::size_t>(std::ceil((box.x1 + reach) / step) - i0 + 1);
  w.ny = static_cast<std::size_t>(std::ceil((box.y1 + reach) / step) - j0 + 1);
  const double radius = kRadius * slab.gap / step;
  const long r = static_cast<long>(radius);
  const double limit = kLimit * slab.gap;

  // Weight.
  std::vector<double> weight = signed_distances(region.contours, w, reach);
  double total = 0;
  for (double& d : weight) {
    const double t = std::max(d, 0.0) / reach;
    d = t >= 1 ? 0 : (1 - t * t) * (1 - t * t);
    total += d;
  }
  const double sign = upper ? -1 : 1;
  const int here = upper ? 2 : 1, there = upper ? 1 : 2;
  const int behind = upper ? 3 : 0, beyond = upper ? 0 : 3;
  const double behind_ratio = upper ? slab.above : slab.below;
  const double beyond_ratio = upper ? slab.below : slab.above;
  const Field f_here = field(*slab.section[here], w, 0, limit);
  const Field f_there = field(*slab.section[there], w, r, limit);
  const auto margin = [&](double ratio) {
    return static_cast<long>(std::ceil(static_cast<double>(r) * ratio)) + 1;
  };
  Field f_behind, f_beyond;
  if (slab.section[behind]) f_behind = field(*slab.section[behind], w, margin(behind_ratio), limit);
  if (slab.section[beyond]) f_beyond = field(*slab.section[beyond], w, margin(1 + beyond_ratio), limit);

  const long n = 2 * r + 1;
  std::vector<double> cost(static_cast<std::size_t>(n * n), std::numeric_limits<double>::infinity());
  const auto at = [&](long i, long j) -> double& {
    return cost[static_cast<std::size_t>((j + r) * n + i + r)];
  };
  const double scale = 1 / (total * slab.gap * slab.gap);
  long bi = 0, bj = 0;
  for (long j = -r; j <= r; ++j) {
    for (long i = -r; i <= r; ++i) {
      const double length2 = static_cast<double>(i * i + j * j);
      if (length2 > radius * radius) continue;
      double main = 0, rest = 0;
      const Shifted s_behind = shifted(-static_cast<double>(i) * behind_ratio, -static_cast<double>(j) * behind_ratio);
      const Shifted s_beyond = shifted(static_cast<double>(i) * (1 + beyond_ratio), static_cast<double>(j) * (1 + beyond_ratio));
      std::size_t k = 0;
      for (long y = 0; y < static_cast<long>(w.ny); ++y) {
        for (long x = 0; x < static_cast<long>(w.nx); ++x, ++k) {
          if (weight[k] == 0) continue;
          const double d_here = f_here.value[k];
          const double d_there = f_there.at(x + i, y + j);
          const double e = d_there - d_here;
          main += weight[k] * (e * e);
          if (slab.section[behind]) {
            const double b = d_here - f_behind.at(x, y, s_behind);
            rest += weight[k] * (b * b);
          }
          if (slab.section[beyond]) {
            const double b = f_beyond.at(x, y, s_beyond) - d_there;
            rest += weight[k] * (b * b);
          }
        }
      }
      const double u = step / slab.gap;
      at(i, j) = (main + kNeighbour * rest) * scale + kStiffness * length2 * u * u;
      const double best = at(bi, bj);
      if (at(i, j) < best || (at(i, j) == best && i * i + j * j < bi * bi + bj * bj)) bi = i, bj = j;
    }
  }
  // Refine by parabolas.
  const auto refine = [&](double low, double mid, double high) {
    const double bend = low + high - 2 * mid;
    if (!(bend > 0) || !(bend < std::numeric_limits<double>::infinity())) return 0.0;
    return std::clamp((low - high) / (2 * bend), -0.5, 0.5);
  };
  const auto value = [&](long i, long j) {
    if (i < -r || i > r || j < -r || j > r) return std::numeric_limits<double>::infinity();
    return at(i, j);
  };
  const double fi = refine(value(bi - 1, bj), at(bi, bj), value(bi + 1, bj));
  const double fj = refine(value(bi, bj - 1), at(bi, bj), value(bi, bj + 1));
  return {sign * (static_cast<double>(bi) + fi) * step, sign * (static_cast<double>(bj) + fj) * step};
}

Point2 rounded(const Point2& u, double gap) {
  const double unit = std::ldexp(1.0, std::ilogb(gap) - 10);
  return {std::floor(u.x / unit + 0.5) * unit, std::floor(u.y / unit + 0.5) * unit};
}

}  // namespace

SlabMotions estimate_motions(SlabId slab, const SectionStack& stack,
                             const IdVector<SectionId, Nesting>& nestings,
                             const WantedRegions& wanted) {
  const std::size_t k = slab.index();
  SlabSections sections;
  sections.section[1] = &stack.sections[SectionId(k)];
  sections.section[2] = &stack.sections[SectionId(k + 1)];
  sections.gap = sections.section[2]->z - sections.section[1]->z;
  if (k > 0) {
    const Section& s = stack.sections[SectionId(k - 1)];
    sections.below = (sections.section[1]->z - s.z) / sections.gap;
    if (sections.below <= 2) sections.section[0] = &s;
  }
  if (k + 2 < stack.sections.size()) {
    const Section& s = stack.sections[SectionId(k + 2)];
    sections.above = (s.z - sections.section[2]->z) / sections.gap;
    if (sections.above <= 2) sections.section[3] = &s;
  }
  SlabMotions result;
  const auto all = [&](bool upper, const std::vector<RegionId>& regions,
                       IdVector<RegionId, std::optional<Point2>>& motions) {
    const SectionId s(k + (upper ? 1 : 0));
    motions.resize(nestings[s].outer.size());
    const auto outline = outlines(stack.sections[s], nestings[s]);
    for (const RegionId r : regions) {
      motions[r] = rounded(estimate(sections, upper, outline[r]), sections.gap);
    }
  };
  all(false, wanted.lower, result.lower);
  all(true, wanted.upper, result.upper);
  return result;
}

}  // namespace tetloft::internal
