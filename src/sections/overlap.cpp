// Overlap of regions: interval arithmetic first, exact integers where it cannot decide.
//
// Whether the overlap is empty is a question of topology, which interiors.cpp answers
// without arithmetic: regions that only touch are ordinary, and no interval tells them
// from regions with a tiny overlap.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <tetloft/overlap.hpp>

#include "sections/interiors.hpp"
#include "sections/overlap_exact.hpp"
#include "sections/overlap_pairs.hpp"
#include "sections/reported_bits.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::Trapezoid;
using sections::Trapezoids;

// An interval that holds two rounded ratios is resolved exactly, up to this many pairs of
// edges (a second or so). More have contours of thousands of vertices folded hundreds of
// times, where intervals are wide and a ratio without the last of its bits must do.
constexpr std::size_t kMostExactPairs = 1'000'000;

// Bounds of ∫ 2 min(p (1 − t) + q t, 0) dt over 0 ≤ t ≤ 1; it increases with p and q.
double lower_bound_below(double p, double q) {
  if (p >= 0 && q >= 0) return 0;
  if (p <= 0 && q <= 0) return downwards(p + q);
  const double n = std::min(p, q);
  const double drop = downwards(std::max(p, q) - n);
  // Denormals: the triangle is never larger than its height.
  if (drop <= 0) return n;
  return -upwards(upwards(n * n) / drop);
}

double upper_bound_below(double p, double q) {
  if (p >= 0 && q >= 0) return 0;
  if (p <= 0 && q <= 0) return std::min(0.0, upwards(p + q));
  const double n = std::min(p, q);
  const double square = std::max(0.0, downwards(n * n));
  const double part = downwards(square / upwards(std::max(p, q) - n));
  return -std::max(0.0, part);
}

// The edges of both regions in one scale, with bounds of their slopes.
class IntervalOverlap {
 public:
  IntervalOverlap(const std::vector<Trapezoid>& a, const std::vector<Trapezoid>& b)
      : a_(a), b_(b), slope_a_(slopes(a)), slope_b_(slopes(b)) {}

  // False where an edge is too steep for doubles.
  [[nodiscard]] bool has_finite_slopes() const {
    const auto finite = [](const Interval& s) {
      return std::isfinite(s.lo) && std::isfinite(s.hi);
    };
    return std::all_of(slope_a_.begin(), slope_a_.end(), finite) &&
           std::all_of(slope_b_.begin(), slope_b_.end(), finite);
  }

  // Twice the area of the overlap; counts pairs. Requires finite slopes.
  [[nodiscard]] Interval twice_area(std::size_t& pairs) const {
    IntervalSum sum;
    sections::visit_pairs(a_, b_, [&](std::uint32_t i, std::uint32_t j) {
      ++pairs;
      const Trapezoid& e = a_[i];
      const Trapezoid& f = b_[j];
      const double l = std::max(e.left.x, f.left.x);
      const double r = std::min(e.right.x, f.right.x);
      const Interval at_l = height(e, slope_a_[i], f, slope_b_[j], l);
      const Interval at_r = height(e, slope_a_[i], f, slope_b_[j], r);
      if (at_l.lo >= 0 && at_r.lo >= 0) return;
      const Interval below{lower_bound_below(at_l.lo, at_r.lo),
                           upper_bound_below(at_l.hi, at_r.hi)};
      const Interval term = difference(r, l) * below;
      sum.add(e.side == f.side ? term : -term);
    });
    return sum.total();
  }

 private:
  static std::vector<Interval> slopes(const std::vector<Trapezoid>& edges) {
    std::vector<Interval> result;
    result.reserve(edges.size());
    for (const Trapezoid& e : edges) {
      const double dx = e.right.x - e.left.x;  // not zero: doubles underflow gradually
      const Interval width{std::max(downwards(dx), 0x1p-1074), upwards(dx)};
      result.push_back(quotient(difference(e.right.y, e.left.y), width));
    }
    return result;
  }

  // e(x) − f(x); x is an end of at least one of them, where its height is given.
  static Interval height(const Trapezoid& e, const Interval& slope_e, const Trapezoid& f,
                         const Interval& slope_f, double x) {
    const bool end_e = x == e.right.x;
    const bool end_f = x == f.right.x;
    Interval result = difference(end_e ? e.right.y : e.left.y, end_f ? f.right.y : f.left.y);
    if (!end_e && x != e.left.x) {
      result = result + slope_e * difference(x, e.left.x);
    }
    if (!end_f && x != f.left.x) {
      result = result - slope_f * difference(x, f.left.x);
    }
    return result;
  }

  const std::vector<Trapezoid>& a_;
  const std::vector<Trapezoid>& b_;
  std::vector<Interval> slope_a_;
  std::vector<Interval> slope_b_;
};

// Bounds of the overlap and of the smaller area, in one scale.
struct Bounds {
  Interval overlap, smaller;
  std::size_t pairs = 0;  // how many pairs of edges contributed
};

Bounds bounds(const Trapezoids& a, const Trapezoids& b) {
  // All that is known of areas of coordinates below 1.
  const Bounds unknown{{0, 8}, {0, 8}, 0};
  Box2 box = a.box;
  box.add(b.box);
  const int scale = sections::scale_of(box);
  std::vector<Trapezoid> all_a = a.edges;
  std::vector<Trapezoid> all_b = b.edges;
  if (!sections::rescale(all_a, scale) || !sections::rescale(all_b, scale)) return unknown;
  std::vector<Trapezoid> near_a = sections::edges_for_pairs(a.edges, b.box);
  std::vector<Trapezoid> near_b = sections::edges_for_pairs(b.edges, a.box);
  static_cast<void>(sections::rescale(near_a, scale));
  static_cast<void>(sections::rescale(near_b, scale));
  const IntervalOverlap overlap(near_a, near_b);
  if (!overlap.has_finite_slopes()) return unknown;
  Bounds result;
  result.overlap = overlap.twice_area(result.pairs);
  result.smaller = minimum(sections::twice_area(all_a), sections::twice_area(all_b));
  return result;
}

}  // namespace

std::array<Sign, 2> compare_overlap(const RegionOutline& a, const RegionOutline& b,
                                    const std::array<double, 2>& taus) {
  sections::require_outline(a);
  sections::require_outline(b);
  std::array<Sign, 2> signs{};
  const bool apart = !sections::bounds(a).overlaps(sections::bounds(b));
  // What the thresholds have in common is found when the first of them needs it.
  struct Overlap {
    Trapezoids a, b;
    Bounds areas;
  };
  std::optional<Overlap> overlap;
  for (std::size_t k = 0; k < taus.size(); ++k) {
    const double tau = taus[k];
    // A ratio is between 0 and 1. Nothing exceeds a tau that is not a number.
    if (tau < 0) {
      signs[k] = Sign::positive;
      continue;
    }
    if (!(tau <= 1)) {
      signs[k] = Sign::negative;
      continue;
    }
    if (apart) {
      signs[k] = tau == 0 ? Sign::zero : Sign::negative;
      continue;
    }
    if (!overlap) {
      overlap = Overlap{sections::trapezoids_of(a), sections::trapezoids_of(b), {}};
      overlap->areas = bounds(overlap->a, overlap->b);
    }
    const Bounds& areas = overlap->areas;
    if (tau == 0) {
      const bool some = areas.overlap.positive() || sections::interiors_meet(a, b);
      signs[k] = some ? Sign::positive : Sign::zero;
      continue;
    }
    const Interval excess = areas.overlap - Interval{tau, tau} * areas.smaller;
    if (excess.positive()) {
      signs[k] = Sign::positive;
    } else if (excess.negative()) {
      signs[k] = Sign::negative;
    } else {
      signs[k] = sections::compare(sections::exact_overlap(overlap->a, overlap->b), tau);
    }
  }
  return signs;
}

Sign compare_overlap(const RegionOutline& a, const RegionOutline& b, double tau) {
  return compare_overlap(a, b, {tau, -1})[0];
}

double overlap_ratio(const RegionOutline& a, const RegionOutline& b) {
  sections::require_outline(a);
  sections::require_outline(b);
  if (!sections::bounds(a).overlaps(sections::bounds(b))) return 0;
  const Trapezoids edges_a = sections::trapezoids_of(a);
  const Trapezoids edges_b = sections::trapezoids_of(b);
  const Bounds areas = bounds(edges_a, edges_b);
  if (!areas.overlap.positive() && !sections::interiors_meet(a, b)) return 0;
  if (areas.overlap.positive() && areas.smaller.positive()) {
    const Interval ratio = quotient(areas.overlap, areas.smaller);
    const double rounded = sections::to_reported_bits(ratio.lo);
    if (ratio.lo > 0 && rounded == sections::to_reported_bits(ratio.hi)) return rounded;
    if (areas.pairs > kMostExactPairs) {
      return std::min(sections::to_reported_bits(ratio.lo + (ratio.hi - ratio.lo) / 2), 1.0);
    }
  }
  // The smallest overlaps of all would round to zero.
  const double rounded =
      sections::rounded_ratio(sections::exact_overlap(edges_a, edges_b), sections::kReportedBits);
  return std::max(rounded, std::numeric_limits<double>::denorm_min());
}

}  // namespace tetloft
