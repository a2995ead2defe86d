// Motions by the definition in src/motion/README.md, written down once more without a line in
// common and without any haste: every edge for every sample, every displacement to its end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "unit/motion/distance_oracle.hpp"
#include "unit/motion/motion_stacks.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

double distance_at(const Section& section, double step, double x, double y) {
  return distance_by_all_edges(section, step, {x, y}, 4);
}

double interpolated(const Section& section, double step, double x, double y) {
  const double x0 = std::floor(x);
  const double y0 = std::floor(y);
  if (x0 == x && y0 == y) return distance_at(section, step, x, y);
  const auto along = [&](double row) {
    const double left = distance_at(section, step, x0, row);
    return left + (x - x0) * (distance_at(section, step, x0 + 1, row) - left);
  };
  const double low = along(y0);
  return low + (y - y0) * (along(y0 + 1) - low);
}

struct Around {
  const Section* behind;
  const Section* here;
  const Section* there;
  const Section* beyond;
  double step, back, on;
};

struct Weighted {
  double at, weight;
};

std::vector<Weighted> weights(double low, double high) {
  std::vector<Weighted> result;
  for (double x = 4 * std::ceil((low - 12) / 4); x <= high + 12; x += 4) {
    const double t = std::max({low - x, x - high, 0.0}) / 12;
    const double s = 1 - t * t;
    result.push_back({x, s * s});
  }
  return result;
}

double sum_of(const std::vector<Weighted>& weighted) {
  double sum = 0;
  for (const Weighted& w : weighted) sum += w.weight;
  return sum;
}

double misfit(const Around& a, const std::vector<Weighted>& columns,
              const std::vector<Weighted>& rows, double i, double j) {
  double sum = 0;
  for (const Weighted& y : rows) {
    double of_row = 0;
    for (const Weighted& x : columns) {
      const double here = distance_at(*a.here, a.step, x.at, y.at);
      const double there = distance_at(*a.there, a.step, x.at + i, y.at + j);
      double q = (there - here) * (there - here);
      if (a.behind != nullptr) {
        const double e =
            here - interpolated(*a.behind, a.step, x.at - a.back * i, y.at - a.back * j);
        q += e * e;
      }
      if (a.beyond != nullptr) {
        const double e =
            interpolated(*a.beyond, a.step, x.at + (1 + a.on) * i, y.at + (1 + a.on) * j) - there;
        q += e * e;
      }
      of_row += x.weight * q;
    }
    sum += y.weight * of_row;
  }
  return sum * (1 / (sum_of(columns) * sum_of(rows) * 16)) + (i * i + j * j) / 64 / 16;
}

Point2 motion_by_definition(const Around& a, const Contour& outer) {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  for (const Point2& p : outer.vertices) {
    x0 = std::min(x0, p.x / a.step);
    x1 = std::max(x1, p.x / a.step);
    y0 = std::min(y0, p.y / a.step);
    y1 = std::max(y1, p.y / a.step);
  }
  const std::vector<Weighted> columns = weights(x0, x1);
  const std::vector<Weighted> rows = weights(y0, y1);
  double least = std::numeric_limits<double>::infinity();
  double bi = 0, bj = 0;
  for (int length2 = 0; length2 <= 16; ++length2) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        if (i * i + j * j != length2) continue;
        const double f = misfit(a, columns, rows, i, j);
        if (f < least) {
          least = f;
          bi = i;
          bj = j;
        }
      }
    }
  }
  const auto refined = [&](double di, double dj) {
    const double before = misfit(a, columns, rows, bi - di, bj - dj);
    const double after = misfit(a, columns, rows, bi + di, bj + dj);
    const double bend = before + after - 2 * least;
    return bend > 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0.0;
  };
  const double gap = a.step * 4;
  int exponent = 0;
  std::frexp(gap, &exponent);
  const double unit = std::ldexp(1.0, exponent - 1 - 10);
  const auto rounded = [&](double u) { return std::round(u * a.step / unit) * unit; };
  return {rounded(bi + refined(1, 0)), rounded(bj + refined(0, 1))};
}

Around around_of(const SectionStack& stack, std::size_t slab, bool upper) {
  const auto at = [&](std::size_t s) { return &stack.sections[SectionId(s)]; };
  const double gap = at(slab + 1)->z - at(slab)->z;
  Around a{nullptr, at(slab), at(slab + 1), nullptr, gap / 4, 0, 0};
  if (slab > 0) a.back = (at(slab)->z - at(slab - 1)->z) / gap;
  if (slab > 0 && a.back <= 2) a.behind = at(slab - 1);
  const bool last = slab + 2 == stack.sections.size();
  if (!last) a.on = (at(slab + 2)->z - at(slab + 1)->z) / gap;
  if (!last && a.on <= 2) a.beyond = at(slab + 2);
  if (upper) {
    std::swap(a.behind, a.beyond);
    std::swap(a.here, a.there);
    std::swap(a.back, a.on);
  }
  return a;
}

void expect_as_defined(const SectionStack& stack, std::size_t slab) {
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const SlabMotions got = all_motions(stack, slab);
  for (const bool upper : {false, true}) {
    const SectionId section(upper ? slab + 1 : slab);
    const Around around = around_of(stack, slab, upper);
    for (const RegionId r : nestings[section].outer.ids()) {
      Point2 want = motion_by_definition(
          around, stack.sections[section].contours[nestings[section].outer[r]]);
      if (upper) want = {-want.x, -want.y};
      EXPECT_EQ((upper ? got.upper : got.lower)[r], want)
          << "slab " << slab << (upper ? ", upper" : ", lower") << " region " << r.index();
    }
  }
}

TEST(MotionDefinition, MotionsAreThoseOfTheDefinitionToTheLastBit) {
  const SectionStack stack = drifting_polygons(1, 4);
  for (std::size_t slab = 0; slab < 3; ++slab) expect_as_defined(stack, slab);
}

TEST(MotionDefinition, EqualGapsNeedNoInterpolation) {
  expect_as_defined(leaning_rods({{0, 0}, {1.1, 0.3}}, 0.3, {0.6, 0.25}, {0, 1, 2, 3}), 1);
}

TEST(MotionDefinition, ANeighbourMoreThanTwoGapsAwaySaysNothing) {
  const std::vector<Point2> centres{{0, 0}, {1.3, 0.4}};
  expect_as_defined(leaning_rods(centres, 0.3, {0.4, 0.1}, {-2.25, 0, 1, 3}), 1);
}

}  // namespace
}  // namespace tetloft::testing
