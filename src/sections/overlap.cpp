// Overlap of regions: interval arithmetic first, exact integers where it cannot decide.
//
// Whether the overlap is empty is a question of topology, which interiors.cpp answers
// without arithmetic: regions that only touch are ordinary, and no interval tells them
// from regions with a tiny overlap.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <tetloft/overlap.hpp>

#include "sections/interiors.hpp"
#include "sections/overlap_exact.hpp"
#include "sections/overlap_pairs.hpp"
#include "sections/overlap_region.hpp"
#include "sections/reported_bits.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::OverlapRegion;
using sections::SlopedEdge;

// An interval that holds two rounded ratios is resolved exactly, up to this many pairs of edges (a
// second or so). More have contours of thousands of vertices folded hundreds of times, where
// intervals are wide and their middle must do, if that is right to kRatioError: the last of its
// bits are those of the bounds, not of the exact ratio. They depend on the two outlines alone:
// terms are added in the order of their places, each rounded as written, so the bits are the same
// in every build and at any number of threads. Other bounds may change them, and with them which of
// two links comes first by evidence that is as near; no threshold: within kRatioError of one
// compare_overlap() is asked.
constexpr std::size_t kMostExactPairs = 1'000'000;

constexpr double kHalfUlp = 0x1p-53;  // u: relative, of one rounding

// ∫ 2 min(p (1 − t) + q t, 0) dt over 0 ≤ t ≤ 1, rounded three times at most; it changes by no more
// than p and q change by, together.
double integral_below(double p, double q) {
  if (p <= 0 && q <= 0) return p + q;
  if (p >= 0 && q >= 0) return 0;
  const double n = std::min(p, q);
  return -(n * n / (std::max(p, q) - n));
}

// e(x) − f(x) for x in the range of both.
double height(const SlopedEdge& e, const SlopedEdge& f, double x) {
  return e.left.y - f.left.y + e.slope * (x - e.left.x) - f.slope * (x - f.left.x);
}

bool has_finite_slopes(const std::vector<SlopedEdge>& edges) {
  return std::all_of(edges.begin(), edges.end(),
                     [](const SlopedEdge& e) { return std::isfinite(e.slope); });
}

// A sum in two doubles. Of n terms it is off by at most u of itself and (n u)² of the sum of their
// magnitudes (Ogita, Rump and Oishi, "Accurate sum and dot product", 2005, proposition 4.5).
struct CompensatedSum {
  double sum = 0;
  double error = 0;

  void add(double term) {
    const double next = sum + term;
    const double of_term = next - sum;
    error += (sum - (next - of_term)) + (term - of_term);
    sum = next;
  }
  [[nodiscard]] double total() const { return sum + error; }
};

// Twice the area of the overlap; counts pairs. Requires finite slopes.
//
// With r, s the rises of e and f: products of slope and distance are at most the rise, and five
// roundings off (difference twice, quotient, difference, product). The first difference is at
// most |p| + r + s, the first sum |p| + s, so a height p is off by
// u (|p| + r + s) + 5 u (r + s) + u (|p| + s) + u |p| ≤ 7 u (|p| + r + s), or 8 u for terms of
// higher order. The integral doubles that and adds three roundings, the term two more, of at
// most |p| + |q|: in all 21 u (|p| + |q| + r + s) times the width, raised to 24 u because these
// bounds are rounded and summed, too. Squares that underflow are of heights below 2^-480, and so
// are the integrals then; what else underflows is far smaller.
Interval twice_overlap(const std::vector<SlopedEdge>& a, const std::vector<SlopedEdge>& b,
                       std::size_t& pairs) {
  constexpr double kError = 24 * kHalfUlp;
  constexpr double kTiny = 0x1p-478;
  CompensatedSum sum;
  double size = 0;  // of all terms
  double width = 0;
  sections::visit_pairs(a, b, [&](std::uint32_t i, std::uint32_t j) {
    ++pairs;
    const SlopedEdge& e = a[i];
    const SlopedEdge& f = b[j];
    const double l = std::max(e.left.x, f.left.x);
    const double r = std::min(e.right.x, f.right.x);
    const double at_l = height(e, f, l);
    const double at_r = height(e, f, r);
    const double term = (r - l) * integral_below(at_l, at_r);
    sum.add(e.side == f.side ? term : -term);
    size += (r - l) * (std::abs(at_l) + std::abs(at_r) + e.rise + f.rise);
    width += r - l;
  });
  const double value = sum.total();
  const double lost = static_cast<double>(pairs) * kHalfUlp;
  const double error = upwards(upwards((kError + 2 * lost * lost) * size) +
                               upwards(2 * kHalfUlp * std::abs(value) + kTiny * (width + 1)));
  return {downwards(value - error), upwards(value + error)};
}

// Bounds of the overlap and of the smaller area, in one scale.
struct Bounds {
  Interval overlap, smaller;
  std::size_t pairs = 0;  // how many pairs of edges contributed
};

// Requires one scale, in which areas are moderate. Nothing where intervals cannot tell.
std::optional<Bounds> bounds_in_scale(const OverlapRegion& a, const OverlapRegion& b) {
  if (!a.is_usable() || !b.is_usable()) return std::nullopt;
  const std::vector<SlopedEdge> near_a = a.edges_near(b.box());
  const std::vector<SlopedEdge> near_b = b.edges_near(a.box());
  if (!has_finite_slopes(near_a) || !has_finite_slopes(near_b)) return std::nullopt;
  Bounds result;
  result.overlap = twice_overlap(near_a, near_b, result.pairs);
  result.smaller = minimum(a.twice_area(), b.twice_area());
  return result;
}

Bounds areas_within(const OverlapRegion& a, const OverlapRegion& b) {
  std::optional<Bounds> known;
  if (a.is_moderate() && b.is_moderate()) {
    known = bounds_in_scale(a, b);
  } else {
    Box2 box = a.box();
    box.add(b.box());
    const int scale = sections::scale_of(box);
    known = bounds_in_scale(a.scaled(scale), b.scaled(scale));
  }
  // No interval that holds 0 decides anything.
  return known ? *known : Bounds{{0, HUGE_VAL}, {0, HUGE_VAL}, 0};
}

// What needs no areas: a ratio is between 0 and 1, and nothing exceeds a tau that is not a number.
std::optional<Sign> sign_without_areas(double tau, bool apart) {
  if (tau < 0) return Sign::positive;
  if (!(tau <= 1)) return Sign::negative;
  if (apart) return tau == 0 ? Sign::zero : Sign::negative;
  return std::nullopt;
}

bool interiors_meet_of(const OverlapRegion& a, const OverlapRegion& b) {
  return sections::interiors_meet(a.outline(), a.box(), b.outline(), b.box());
}

sections::ExactOverlap exact_overlap_of(const OverlapRegion& a, const OverlapRegion& b) {
  return sections::exact_overlap(sections::trapezoids_of(a.outline()),
                                 sections::trapezoids_of(b.outline()));
}

}  // namespace

std::array<Sign, 2> sections::compare_overlap(const OverlapRegion& a, const OverlapRegion& b,
                                              const std::array<double, 2>& taus) {
  std::array<Sign, 2> signs{};
  const bool apart = !a.box().overlaps(b.box());
  // What the thresholds have in common is found when the first of them needs it.
  std::optional<Bounds> areas;
  for (std::size_t k = 0; k < taus.size(); ++k) {
    if (const std::optional<Sign> sign = sign_without_areas(taus[k], apart)) {
      signs[k] = *sign;
      continue;
    }
    if (!areas) areas = areas_within(a, b);
    if (taus[k] == 0) {
      const bool some = areas->overlap.positive() || interiors_meet_of(a, b);
      signs[k] = some ? Sign::positive : Sign::zero;
      continue;
    }
    const Interval excess = areas->overlap - Interval{taus[k], taus[k]} * areas->smaller;
    if (excess.positive()) {
      signs[k] = Sign::positive;
    } else if (excess.negative()) {
      signs[k] = Sign::negative;
    } else {
      signs[k] = sections::compare(exact_overlap_of(a, b), taus[k]);
    }
  }
  return signs;
}

double sections::overlap_ratio(const OverlapRegion& a, const OverlapRegion& b) {
  if (!a.box().overlaps(b.box())) return 0;
  const Bounds areas = areas_within(a, b);
  if (!areas.overlap.positive() && !interiors_meet_of(a, b)) return 0;
  if (areas.overlap.positive() && areas.smaller.positive()) {
    const Interval ratio = quotient(areas.overlap, areas.smaller);
    const double rounded = sections::to_reported_bits(ratio.lo);
    if (ratio.lo > 0 && rounded == sections::to_reported_bits(ratio.hi)) return rounded;
    if (areas.pairs > kMostExactPairs && ratio.hi - ratio.lo <= kRatioError / 2 * ratio.lo) {
      return std::min(sections::to_reported_bits(ratio.lo + (ratio.hi - ratio.lo) / 2), 1.0);
    }
  }
  // The smallest overlaps of all would round to zero.
  const double rounded = sections::rounded_ratio(exact_overlap_of(a, b), sections::kReportedBits);
  return std::max(rounded, std::numeric_limits<double>::denorm_min());
}

std::array<Sign, 2> compare_overlap(const RegionOutline& a, const RegionOutline& b,
                                    const std::array<double, 2>& taus) {
  sections::require_outline(a);
  sections::require_outline(b);
  const bool apart = !sections::bounds(a).overlaps(sections::bounds(b));
  const std::array<std::optional<Sign>, 2> known{sign_without_areas(taus[0], apart),
                                                 sign_without_areas(taus[1], apart)};
  if (known[0] && known[1]) return {*known[0], *known[1]};
  return sections::compare_overlap(OverlapRegion(a), OverlapRegion(b), taus);
}

Sign compare_overlap(const RegionOutline& a, const RegionOutline& b, double tau) {
  return compare_overlap(a, b, {tau, -1})[0];
}

double overlap_ratio(const RegionOutline& a, const RegionOutline& b) {
  sections::require_outline(a);
  sections::require_outline(b);
  if (!sections::bounds(a).overlaps(sections::bounds(b))) return 0;
  return sections::overlap_ratio(OverlapRegion(a), OverlapRegion(b));
}

}  // namespace tetloft
