#include "motion/region_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <tetloft/overlap.hpp>

#include "motion/distance_samples.hpp"

namespace tetloft::internal {

namespace {

double env(const char* name, double value) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::atof(text) : value;
}
const double kSteps = env("M_STEPS", 4);   // samples per gap
const double kRadius = env("M_R", 1.0);    // gaps
const double kReach = env("M_REACH", 2.6); // gaps
const double kStiffness = env("M_LAMBDA", 0.005);
const double kNeighbour = env("M_NB", 0.5);
const double kLimit = env("M_LIMIT", 1.0);
const long kStride = static_cast<long>(env("M_STRIDE", 2));
const double kLargest = env("M_LARGEST", 1e9);  // gaps
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A displacement of samples by whole steps and a fraction.
struct Shift {
  std::int64_t i, j;
  double fx, fy;
};

Shift shift_by(double i, double j) {
  const double fi = std::floor(i), fj = std::floor(j);
  return {static_cast<std::int64_t>(fi), static_cast<std::int64_t>(fj), i - fi, j - fj};
}

double shifted(const double* row, std::size_t nx, std::int64_t k, const Shift& s) {
  if (s.fx == 0 && s.fy == 0) return row[k];
  const double* const next = row + nx;
  const double low = row[k] + s.fx * (row[k + 1] - row[k]);
  const double high = next[k] + s.fx * (next[k + 1] - next[k]);
  return low + s.fy * (high - low);
}

// Sections k - 1 to k + 2 of a slab; the outer ones may be missing.
struct SlabSamples {
  std::array<const DistanceSamples*, 4> section{};
  double below = 0, above = 0;  // gaps there by the gap here
};

struct Kernel {
  std::int64_t first = 0;  // index of the first sample
  std::vector<double> weight;
  double sum = 0;
};

// Around [low, high], in lattice units.
Kernel kernel(double low, double high, double reach) {
  Kernel k;
  const double stride = static_cast<double>(kStride);
  k.first = static_cast<std::int64_t>(std::ceil((low - reach) / stride)) * kStride;
  for (std::int64_t i = k.first; static_cast<double>(i) <= high + reach; i += kStride) {
    const double x = static_cast<double>(i);
    const double t = std::max({low - x, x - high, 0.0}) / reach;
    const double w = (1 - t * t) * (1 - t * t);
    k.weight.push_back(w);
    k.sum += w;
  }
  return k;
}

class Search {
 public:
  Search(const SlabSamples& samples, bool upper, const Box2& box)
      : here_(*samples.section[upper ? 2 : 1]),
        there_(*samples.section[upper ? 1 : 2]),
        behind_(samples.section[upper ? 3 : 0]),
        beyond_(samples.section[upper ? 0 : 3]),
        back_(upper ? samples.above : samples.below),
        on_(1 + (upper ? samples.below : samples.above)),
        columns_(kernel(box.x0, box.x1, kReach * kSteps)),
        rows_(kernel(box.y0, box.y1, kReach * kSteps)),
        scale_(1 / (columns_.sum * rows_.sum * kSteps * kSteps)) {}

  // The mean cost of the displacement by (i, j), or infinity where it is `most` or more.
  double cost(std::int64_t i, std::int64_t j, double most) const {
    const double length2 = static_cast<double>(i * i + j * j);
    const double rest = kStiffness * length2 / (kSteps * kSteps);
    const Shift back = shift_by(-back_ * static_cast<double>(i), -back_ * static_cast<double>(j));
    const Shift on = shift_by(on_ * static_cast<double>(i), on_ * static_cast<double>(j));
    double sum = 0;
    for (std::size_t y = 0; y < rows_.weight.size(); ++y) {
      const std::int64_t row = rows_.first + static_cast<std::int64_t>(y) * kStride;
      sum += rows_.weight[y] * row_cost(row, i, j, back, on);
      if (sum * scale_ + rest >= most) return kInfinity;
    }
    return sum * scale_ + rest;
  }

 private:
  double row_cost(std::int64_t row, std::int64_t i, std::int64_t j, const Shift& back,
                  const Shift& on) const {
    const double* const here = here_.at(columns_.first, row);
    const double* const there = there_.at(columns_.first + i, row + j);
    double main = 0, side = 0;
    const std::size_t n = columns_.weight.size();
    for (std::size_t x = 0; x < n; ++x) {
      const std::int64_t k = static_cast<std::int64_t>(x) * kStride;
      const double e = there[k] - here[k];
      main += columns_.weight[x] * (e * e);
    }
    if (behind_ != nullptr) {
      const double* const behind = behind_->at(columns_.first + back.i, row + back.j);
      for (std::size_t x = 0; x < n; ++x) {
        const std::int64_t k = static_cast<std::int64_t>(x) * kStride;
        const double e = here[k] - shifted(behind, behind_->window.nx(), k, back);
        side += columns_.weight[x] * (e * e);
      }
    }
    if (beyond_ != nullptr) {
      const double* const beyond = beyond_->at(columns_.first + on.i, row + on.j);
      for (std::size_t x = 0; x < n; ++x) {
        const std::int64_t k = static_cast<std::int64_t>(x) * kStride;
        const double e = shifted(beyond, beyond_->window.nx(), k, on) - there[k];
        side += columns_.weight[x] * (e * e);
      }
    }
    return main + kNeighbour * side;
  }

  const DistanceSamples& here_;
  const DistanceSamples& there_;
  const DistanceSamples* behind_;
  const DistanceSamples* beyond_;
  double back_, on_;
  Kernel columns_, rows_;
  double scale_;
};

struct Step {
  std::int64_t i, j;
};

// All displacements within the radius, the shortest first.
std::vector<Step> displacements() {
  const double radius = kRadius * kSteps;
  const auto r = static_cast<std::int64_t>(radius);
  std::vector<Step> result;
  for (std::int64_t j = -r; j <= r; ++j) {
    for (std::int64_t i = -r; i <= r; ++i) {
      if (static_cast<double>(i * i + j * j) <= radius * radius) result.push_back({i, j});
    }
  }
  std::sort(result.begin(), result.end(), [](const Step& a, const Step& b) {
    const std::int64_t la = a.i * a.i + a.j * a.j, lb = b.i * b.i + b.j * b.j;
    if (la != lb) return la < lb;
    return a.i != b.i ? a.i < b.i : a.j < b.j;
  });
  return result;
}

// Where the parabola through the values at -1, 0 and 1, the least of which is at 0, has its least.
double vertex(double before, double at, double after) {
  const double bend = before + after - 2 * at;
  return bend > 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0.0;
}

// In lattice units, in the sense from the region's plane to the other.
Point2 displacement(const Search& search, const std::vector<Step>& steps) {
  Step best{0, 0};
  double least = kInfinity;
  for (const Step& s : steps) {
    const double cost = search.cost(s.i, s.j, least);
    if (cost < least) {
      least = cost;
      best = s;
    }
  }
  const auto around = [&](std::int64_t i, std::int64_t j) {
    return search.cost(best.i + i, best.j + j, kInfinity);
  };
  return {static_cast<double>(best.i) + vertex(around(-1, 0), least, around(1, 0)),
          static_cast<double>(best.j) + vertex(around(0, -1), least, around(0, 1))};
}

struct Wanted {
  bool upper;
  RegionId region;
  Box2 box;  // lattice units
};

LatticeWindow window_of(const Box2& box) {
  const double reach = kReach * kSteps;
  return {static_cast<std::int64_t>(std::floor(box.x0 - reach)),
          static_cast<std::int64_t>(std::floor(box.y0 - reach)),
          static_cast<std::int64_t>(std::floor(box.x1 + reach)) + 2,
          static_cast<std::int64_t>(std::floor(box.y1 + reach)) + 2};
}

struct Group {
  LatticeWindow window;
  std::vector<Wanted> wanted;
};

std::vector<Group> grouped(const std::vector<Wanted>& all) {
  std::vector<Group> groups;
  for (const Wanted& w : all) {
    const LatticeWindow window = window_of(w.box);
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return g.window.joined(window).size() <= g.window.size() + window.size();
    });
    if (at == groups.end()) {
      groups.push_back({window, {w}});
    } else {
      at->window = at->window.joined(window);
      at->wanted.push_back(w);
    }
  }
  return groups;
}

double rounded(double u, double gap) {
  const double unit = std::ldexp(1.0, std::ilogb(gap) - 10);
  return std::floor(u / unit + 0.5) * unit;
}

}  // namespace

SlabMotions estimate_motions(SlabId slab, const SectionStack& stack,
                             const IdVector<SectionId, Nesting>& nestings,
                             const WantedRegions& wanted) {
  const std::size_t k = slab.index();
  const auto z = [&](std::size_t s) { return stack.sections[SectionId(s)].z; };
  const double gap = z(k + 1) - z(k);
  const double step = gap / kSteps;
  SlabMotions result;
  std::vector<Wanted> all;
  const auto collect = [&](bool upper, const std::vector<RegionId>& regions,
                           IdVector<RegionId, std::optional<Point2>>& motions) {
    const SectionId s(k + (upper ? 1 : 0));
    motions.resize(nestings[s].outer.size());
    for (const RegionId r : regions) {
      motions[r] = Point2{0, 0};
      Box2 box;
      for (const Point2& p : stack.sections[s].contours[nestings[s].outer[r]].vertices) {
        box.add(Point2{p.x / step, p.y / step});
      }
      if (std::max(box.x1 - box.x0, box.y1 - box.y0) > kLargest * kSteps) continue;
      all.push_back({upper, r, box});
    }
  };
  collect(false, wanted.lower, result.lower);
  collect(true, wanted.upper, result.upper);
  if (all.empty()) return result;

  SlabSamples samples;
  if (k > 0) samples.below = (z(k) - z(k - 1)) / gap;
  if (k + 2 < stack.sections.size()) samples.above = (z(k + 2) - z(k + 1)) / gap;
  const bool has_below = k > 0 && samples.below <= 2;
  const bool has_above = k + 2 < stack.sections.size() && samples.above <= 2;
  std::array<std::optional<LatticeEdges>, 4> edges;
  for (std::size_t s = 0; s < 4; ++s) {
    if ((s == 0 && !has_below) || (s == 3 && !has_above)) continue;
    edges[s].emplace(stack.sections[SectionId(k + s - 1)], step);
  }
  const std::vector<Step> steps = displacements();
  const double r = std::floor(kRadius * kSteps) + 1;
  for (const Group& group : grouped(all)) {
    std::array<DistanceSamples, 4> fields;
    for (std::size_t s = 0; s < 4; ++s) {
      if (!edges[s]) continue;
      const double on = s == 0 ? 1 + samples.below : s == 3 ? 1 + samples.above : 1;
      const auto margin = static_cast<std::int64_t>(std::ceil(r * on)) + 1;
      fields[s] = sample_distances(*edges[s], group.window.widened(margin), kLimit * kSteps);
      samples.section[s] = &fields[s];
    }
    for (const Wanted& w : group.wanted) {
      const Point2 u = displacement(Search(samples, w.upper, w.box), steps);
      const double sign = w.upper ? -1 : 1;
      (w.upper ? result.upper : result.lower)[w.region] =
          Point2{rounded(sign * u.x * step, gap), rounded(sign * u.y * step, gap)};
    }
  }
  return result;
}

}  // namespace tetloft::internal
