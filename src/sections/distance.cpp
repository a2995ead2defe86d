// Distances of regions: bounds in doubles first, exact integers where they cannot decide.
//
// Whether regions share a point is asked of predicates. If they do not, their distance is that of
// a vertex of one from an edge of the other, found through a box tree. Every vertex begins one
// edge: for each pair of edges near each other only their first vertices are measured.
#include "sections/distance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <tetloft/overlap.hpp>

#include "arithmetic/interval.hpp"
#include "sections/distance_exact.hpp"
#include "sections/interiors.hpp"
#include "sections/reported_bits.hpp"
#include "sections/segments.hpp"
#include "sections/trapezoids.hpp"

namespace tetloft::internal::sections {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How far u.x v.x ± u.y v.y, computed, may be off, for scaled differences u and v as computed, and
// m = |u.x v.x| + |u.y v.y|. Differences, products and the sum are rounded, which makes less than
// 5 · 2^-53 m; rounding m and adding the error make less than 2 · 2^-53 m. Where scaling leaves
// denormals it moves differences by 2^-1074, hence products with others, below 2^25, by 2^-1049.
double error_of(double m) { return m * 0x1p-50 + 0x1p-1040; }

Point2 scaled_difference(const Point2& a, const Point2& b, double factor) {
  return {a.x * factor - b.x * factor, a.y * factor - b.y * factor};
}

Interval bounds_of(double value, double magnitude) {
  const double error = error_of(magnitude);
  return {value - error, value + error};
}

Interval dot(const Point2& u, const Point2& v) {
  const double x = u.x * v.x;
  const double y = u.y * v.y;
  return bounds_of(x + y, std::abs(x) + std::abs(y));
}

Interval cross_product(const Point2& u, const Point2& v) {
  const double x = u.x * v.y;
  const double y = u.y * v.x;
  return bounds_of(x - y, std::abs(x) + std::abs(y));
}

// Of the squared distance of a point from an edge, coordinates multiplied by `factor`.
Interval squared_distance(const PointAndEdge& pair, double factor) {
  const auto& [a, b] = pair.edge;
  const Point2 v = scaled_difference(b, a, factor);
  const Point2 u = scaled_difference(pair.p, a, factor);
  const Interval from_a = dot(u, v);
  if (from_a.hi <= 0) return dot(u, u);
  const Point2 w = scaled_difference(pair.p, b, factor);
  const Interval from_b = dot(w, v);
  if (from_b.lo >= 0) return dot(w, w);
  // No point of the edge is nearer than its line, and none farther than the nearer end.
  const Interval length2 = dot(v, v);
  const Interval area = absolute(cross_product(v, u));
  Interval result{downwards(downwards(area.lo * area.lo) / length2.hi),
                  std::min(dot(u, u).hi, dot(w, w).hi)};
  if (from_a.lo >= 0 && from_b.hi <= 0 && length2.lo > 0) {
    result.hi = std::min(result.hi, upwards(upwards(area.hi * area.hi) / length2.lo));
  }
  return result;
}

const ContourEdges& fewer(const ContourEdges& a, const ContourEdges& b) {
  return b.edges().size() < a.edges().size() ? b : a;
}
const ContourEdges& more(const ContourEdges& a, const ContourEdges& b) {
  return b.edges().size() < a.edges().size() ? a : b;
}

bool share_a_point(const ContourEdges& a, const ContourEdges& b) {
  if (!a.box().meets(b.box())) return false;
  // If the contours do not touch, all vertices of the outer one of a lie in b like the first, or
  // those of b in a, or the regions are apart.
  const auto reaches = [](const ContourEdges& region, const ContourEdges& other) {
    return region.locate(other.edges().front().a) != ContourEdges::Where::outside;
  };
  if (reaches(a, b) || reaches(b, a)) return true;
  const ContourEdges& many = more(a, b);
  for (const auto& e : fewer(a, b).edges()) {
    bool met = false;
    many.tree().query(box_of(e.a, e.b), [&](std::size_t k) {
      const auto& f = many.edges()[k];
      met = met || touch(e.a, e.b, f.a, f.b);
    });
    if (met) return true;
  }
  return false;
}

// What is farther is above the limit after rounding to kReportedBits, too; the last term covers
// denormals, which have fewer bits.
double reach_of(double limit) { return limit + (limit * 0x1p-30 + 0x1p-1074); }

bool are_beyond(double reach, const Box2& a, const Box2& b) {
  const Point2 offset = a.offset(b);
  return std::max(offset.x, offset.y) > reach;
}

int common_scale(const ContourEdges& a, const ContourEdges& b) {
  Box2 box = a.box();
  box.add(b.box());
  return scale_of(box);
}

// The search for the least distance of regions without a common point. Squared distances are of
// coordinates times 2^scale_.
class NearestPair {
 public:
  using Edge = ContourEdges::Edge;

  NearestPair(const ContourEdges& a, const ContourEdges& b, double reach)
      : few_(fewer(a, b)),
        many_(more(a, b)),
        scale_(common_scale(a, b)),
        factor_(std::ldexp(1, scale_)),
        within_(upwards(reach * factor_ * (reach * factor_))) {}

  /// Infinite if nothing is within reach, or some distance beyond it.
  [[nodiscard]] double distance() {
    const auto nearest_to = [&](std::size_t k) {
      const Edge& e = few_.edges()[k];
      visit_near(e, [&](const Edge& f) { improve(e, f); });
    };
    // Some from all around first: what is near the nearest keeps the others' searches short.
    const std::size_t n = few_.edges().size();
    if (n > 0) nearest_to(0);
    for (std::size_t stride = std::bit_ceil(n) / 2; stride > 0; stride /= 2) {
      for (std::size_t k = stride; k < n; k += 2 * stride) nearest_to(k);
    }
    if (square_.hi == kInfinity) return kInfinity;
    // The smallest distances of all would round to zero.
    return std::max(rounded(), std::numeric_limits<double>::denorm_min());
  }
  [[nodiscard]] std::size_t pairs() const { return pairs_; }

 private:
  // Calls visit(f) for edges of many_ near e, and always for those within what is found so far.
  template <class Visit>
  void visit_near(const Edge& e, Visit visit) {
    const Box2 from = box_of(e.a, e.b);
    const auto offset = [&](const Box2& box) {
      const Point2 outside = box.offset(from);
      const Point2 scaled{outside.x * factor_, outside.y * factor_};
      return scaled.x * scaled.x + scaled.y * scaled.y;
    };
    const auto within = [&] { return within_ + error_of(within_); };
    if (offset(many_.box()) > within()) return;
    many_.tree().query_least(
        offset,
        [&](std::size_t k) {
          ++pairs_;
          visit(many_.edges()[k]);
        },
        within);
  }

  // By the first vertices of both.
  void improve(const Edge& e, const Edge& f) {
    const Interval found =
        minimum(squared_distance({e.a, f}, factor_), squared_distance({f.a, e}, factor_));
    square_ = minimum(square_, found);
    within_ = std::min(within_, found.hi);
  }

  [[nodiscard]] double rounded() {
    if (square_.lo > 0) {
      const double least = to_reported_bits(downwards(std::sqrt(square_.lo)));
      const double most = to_reported_bits(upwards(std::sqrt(square_.hi)));
      if (least == most) return std::ldexp(least, -scale_);
    }
    std::vector<PointAndEdge> nearest;
    const auto add = [&](const PointAndEdge& pair) {
      if (squared_distance(pair, factor_).lo <= square_.hi) nearest.push_back(pair);
    };
    for (const Edge& e : few_.edges()) {
      visit_near(e, [&](const Edge& f) {
        add({e.a, f});
        add({f.a, e});
      });
    }
    return smallest_distance(nearest, kReportedBits);
  }

  const ContourEdges& few_;
  const ContourEdges& many_;
  int scale_;
  double factor_;
  double within_;                          // no more than this can decide the result
  Interval square_{kInfinity, kInfinity};  // of the least one found
  std::size_t pairs_ = 0;
};

}  // namespace

Apart measure(const ContourEdges& a, const ContourEdges& b, double limit) {
  if (!(limit >= 0)) return {};
  const double reach = reach_of(limit);
  if (are_beyond(reach, a.box(), b.box())) return {};
  if (share_a_point(a, b)) return {0.0, 0};
  NearestPair nearest(a, b, reach);
  const double distance = nearest.distance();
  return {distance <= limit ? std::optional(distance) : std::nullopt, nearest.pairs()};
}

}  // namespace tetloft::internal::sections

namespace tetloft {

using namespace internal;

std::optional<double> region_distance_within(const RegionOutline& a, const RegionOutline& b,
                                             double limit) {
  sections::require_outline(a);
  sections::require_outline(b);
  // Before any tree is built.
  if (!(limit >= 0)) return std::nullopt;
  if (sections::are_beyond(sections::reach_of(limit), sections::bounds(a), sections::bounds(b))) {
    return std::nullopt;
  }
  return sections::measure(sections::ContourEdges(a), sections::ContourEdges(b), limit).distance;
}

double region_distance(const RegionOutline& a, const RegionOutline& b) {
  return *region_distance_within(a, b, std::numeric_limits<double>::infinity());
}

}  // namespace tetloft
