// Edges of one section, and most of two, are in order by the side on which the ends of one lie of
// the other. Where they cross, their heights are compared: polynomials of degree three, by
// intervals and, where these do not tell, by integers.
#include "sections/overlay_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <tetloft/predicates.hpp>

#include "arithmetic/big_integer.hpp"
#include "arithmetic/interval.hpp"

namespace tetloft::internal::sections {

namespace {

// The height of the line a b over x less that of c d, times both widths.
template <class Number>
Number height(const Number& x, const std::array<Number, 4>& ab, const std::array<Number, 4>& cd) {
  const auto& [ax, ay, bx, by] = ab;
  const auto& [cx, cy, dx, dy] = cd;
  const Number width_ab = bx - ax;
  const Number width_cd = dx - cx;
  return ((ay - cy) * width_ab + (by - ay) * (x - ax)) * width_cd - (dy - cy) * (x - cx) * width_ab;
}

// Intervals neither over- nor underflow in three factors of two such coordinates.
constexpr double kIntervalLimit = 0x1p300;

// The sign of it. Requires a.x < b.x, and c lower than d in canonical order: a line straight up
// rises from below all, to its left, to above all.
int height_sign(double x, const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const std::array<double, 9> all = {x, a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  const bool moderate =
      std::all_of(all.begin(), all.end(), [](double v) { return std::abs(v) < kIntervalLimit; });
  if (moderate) {
    std::array<Interval, 9> v;
    std::transform(all.begin(), all.end(), v.begin(), [](double w) { return Interval{w, w}; });
    const Interval h = height<Interval>(v[0], {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7], v[8]});
    if (h.positive()) return 1;
    if (h.negative()) return -1;
  }
  int unit = std::numeric_limits<int>::max();
  for (const double v : all) {
    if (v != 0) unit = std::min(unit, Dyadic(v).exponent);
  }
  std::array<BigInteger, 9> v;
  std::transform(all.begin(), all.end(), v.begin(),
                 [&](double w) { return BigInteger::from_double(w, unit); });
  return height<BigInteger>(v[0], {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7], v[8]}).sign();
}

// Where both ends of an edge lie of a line: above or on it, below or on it, on it, or on both
// sides.
enum class Beside : std::uint8_t { above, below, on, parted };

Beside beside(const Point2& low, const Point2& high, const Point2& c, const Point2& d) {
  const int side_c = static_cast<int>(orient2d(low, high, c));
  const int side_d = static_cast<int>(orient2d(low, high, d));
  if (side_c * side_d < 0) return Beside::parted;
  const int side = side_c + side_d;
  return side > 0 ? Beside::above : side < 0 ? Beside::below : Beside::on;
}

}  // namespace

// Is f above e just right of x? Requires that both run from x or left of it to right of it.
bool OverlayRay::is_above(const Edge& f, const Edge& e, double x) const {
  const Point2& a = curves_[e.section]->low(e.edge);
  const Point2& b = curves_[e.section]->high(e.edge);
  const Point2& c = curves_[f.section]->low(f.edge);
  const Point2& d = curves_[f.section]->high(f.edge);
  const Beside f_of_e = beside(a, b, c, d);
  if (f_of_e != Beside::parted) return f_of_e == Beside::above;
  const Beside e_of_f = beside(c, d, a, b);
  if (e_of_f != Beside::parted) return e_of_f == Beside::below;
  const int e_over_f = height_sign(x, a, b, c, d);
  return e_over_f != 0 ? e_over_f < 0 : orient2d(a, b, d) == Sign::positive;
}

OverlayRay::Edge OverlayRay::edge_below(const Point2& p) const {
  Edge best;
  double within = std::numeric_limits<double>::max();
  // Boxes by how far below p they begin; none beside the ray, none above p. (Rounded differences
  // are in order, too.)
  const auto offset = [&](const Box2& box) {
    return box.x0 <= p.x && p.x < box.x1 && box.y0 < p.y ? std::max(p.y - box.y1, 0.0)
                                                         : std::numeric_limits<double>::infinity();
  };
  for (std::uint32_t s = 0; s < 2; ++s) {
    const OverlayCurves& curves = *curves_[s];
    const auto visit = [&](std::size_t block) {
      for (std::uint32_t k = curves.blocks()[block].first; k < curves.blocks()[block].last; ++k) {
        const Point2& low = curves.low(k);
        const Point2& high = curves.high(k);
        if (!(low.x <= p.x && p.x < high.x) || orient2d(low, high, p) != Sign::positive) continue;
        // Of edges that run together the lower section's stays.
        if (best.edge != kNone && !is_above({s, k}, best, p.x)) continue;
        best = {s, k};
        within = std::min(within, p.y - std::min(low.y, high.y));
      }
    };
    curves.tree().query_least(offset, visit, [&] { return within; });
  }
  return best;
}

// Does the ray pass e to the right of a node on it?
bool OverlayRay::is_left(const OverlayNode& node, const Edge& e, double x) const {
  for (std::size_t s = 0; s < 2; ++s) {
    if (node.at_start[s]) return curves_[s]->start(node.edge[s]).x <= x;
  }
  const Point2& a = curves_[e.section]->low(e.edge);
  const Point2& b = curves_[e.section]->high(e.edge);
  const OverlayCurves& others = *curves_[1 - e.section];
  const std::uint32_t f = node.edge[1 - e.section];
  // The line of f is, to the right of the crossing, on the side of f's higher end.
  const int e_over_f = height_sign(x, a, b, others.low(f), others.high(f));
  const bool ends_above = orient2d(a, b, others.high(f)) == Sign::positive;
  return e_over_f == 0 || (e_over_f < 0) == ends_above;
}

std::uint32_t OverlayRay::half_of(const Edge& e, double x) const {
  const OverlayCurves& curves = *curves_[e.section];
  const OverlayNodes& nodes = graph_.nodes();
  const std::uint32_t contour = curves.contour(e.edge);
  const OverlayNodes::Range range = nodes.range[e.section][contour];
  const bool rises = curves.rises(e.edge);
  if (range.last == 0) {
    const std::uint32_t loop = graph_.loop(e.section, contour);
    return rises ? loop : loop ^ 1U;
  }
  const std::vector<std::uint32_t>& passes = nodes.passes[e.section];
  // The first pass after the ray, along the contour.
  const auto first = passes.begin() + range.first;
  const auto last = passes.begin() + range.last;
  const auto after = std::partition_point(first, last, [&](std::uint32_t n) {
    const OverlayNode& node = nodes.nodes[n];
    if (node.edge[e.section] != e.edge) return node.edge[e.section] < e.edge;
    return is_left(node, e, x) == rises;
  });
  const auto pass =
      static_cast<std::uint32_t>((after == first ? last : after) - passes.begin()) - 1;
  const std::uint32_t half = graph_.half_from(e.section, pass);
  return rises ? half : half ^ 1U;
}

std::uint32_t OverlayRay::half_below(const Point2& p) const {
  const Edge e = edge_below(p);
  return e.edge == kNone ? kNone : half_of(e, p.x);
}

bool OverlayRay::meets(const Point2& p) const {
  bool met = false;
  for (const OverlayCurves* curves : curves_) {
    curves->tree().query(box_of(p, p), [&](std::size_t block) {
      for (std::uint32_t k = curves->blocks()[block].first; k < curves->blocks()[block].last; ++k) {
        met = met || (box_of(curves->start(k), curves->end(k)).meets(box_of(p, p)) &&
                      orient2d(curves->start(k), curves->end(k), p) == Sign::zero);
      }
    });
  }
  return met;
}

}  // namespace tetloft::internal::sections
