// Trapezoids of contours and regions, their scaling and their areas.
#include "sections/trapezoids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sections/nesting.hpp"

namespace tetloft::internal::sections {

namespace {

// Both 2^scale and 2^-scale are doubles, also for coordinates up to kLargestCoordinate.
constexpr int kLargestScale = 1001;

// Appends the edges of `contour`, on whose left the region lies iff `left`.
void append(const Contour& contour, bool left, Trapezoids& to) {
  const std::vector<Point2>& vertices = contour.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Point2& p = vertices[v];
    const Point2& q = vertices[v + 1 == vertices.size() ? 0 : v + 1];
    to.box.add(p);
    if (p.x == q.x) continue;
    const bool leftwards = q.x < p.x;
    to.edges.push_back({leftwards ? q : p, leftwards ? p : q, leftwards == left ? 1 : -1});
  }
}

int exponent_of(double value) {
  const Dyadic d(value);
  return d.mantissa == 0 ? std::numeric_limits<int>::max() : d.exponent;
}

Int128 integer(double value, double origin, int unit, Int128) {
  // Both are multiples of 2^unit and their difference is small: subtraction is exact.
  return static_cast<Int128>(std::ldexp(value - origin, -unit));
}

BigInteger integer(double value, double origin, int unit, const BigInteger&) {
  return BigInteger::from_double(value, unit) - BigInteger::from_double(origin, unit);
}

template <class Int>
BigInteger twice_area_of(const std::vector<IntegerTrapezoid<Int>>& edges) {
  BigInteger sum;
  for (const IntegerTrapezoid<Int>& e : edges) {
    const BigInteger term{(e.x1 - e.x0) * (e.y0 + e.y1)};
    sum += e.side > 0 ? term : -term;
  }
  return sum;
}

}  // namespace

Trapezoids trapezoids_of(const Contour& contour) {
  Trapezoids result;
  append(contour, true, result);
  return result;
}

Trapezoids trapezoids_of(const RegionOutline& region) {
  Trapezoids result;
  for (std::size_t k = 0; k < region.contours.size(); ++k) {
    const Contour& contour = *region.contours[k];
    append(contour, is_counter_clockwise(contour) == (k == 0), result);
  }
  return result;
}

int scale_of(const Box2& box) {
  const double x = std::max(std::abs(box.x0), std::abs(box.x1));
  const double y = std::max(std::abs(box.y0), std::abs(box.y1));
  int exponent = 0;
  std::frexp(std::max(x, y), &exponent);
  return std::clamp(-exponent, -kLargestScale, kLargestScale);
}

bool rescale(std::vector<Trapezoid>& edges, int scale) {
  const double factor = std::ldexp(1, scale);
  const double inverse = std::ldexp(1, -scale);
  bool exact = true;
  const auto rescaled = [&](double& value) {
    const double before = value;
    value = before * factor;
    exact = exact && value * inverse == before;
  };
  for (Trapezoid& e : edges) {
    rescaled(e.left.x);
    rescaled(e.left.y);
    rescaled(e.right.x);
    rescaled(e.right.y);
  }
  return exact;
}

Interval twice_area(const std::vector<Trapezoid>& edges) {
  IntervalSum sum;
  if (edges.empty()) return {};
  // Heights above one of the vertices: the terms shrink to the size of the region.
  const double level = edges.front().left.y;
  for (const Trapezoid& e : edges) {
    const Interval term = difference(e.right.x, e.left.x) *
                          (difference(e.left.y, level) + difference(e.right.y, level));
    sum.add(e.side > 0 ? term : -term);
  }
  return sum.total();
}

int lattice_exponent(const std::vector<Trapezoid>& edges) {
  int exponent = std::numeric_limits<int>::max();
  for (const Trapezoid& e : edges) {
    exponent = std::min({exponent, exponent_of(e.left.x), exponent_of(e.left.y),
                         exponent_of(e.right.x), exponent_of(e.right.y)});
  }
  return exponent;
}

template <class Int>
std::vector<IntegerTrapezoid<Int>> in_units(const std::vector<Trapezoid>& edges,
                                            const Point2& origin, int unit) {
  std::vector<IntegerTrapezoid<Int>> result;
  result.reserve(edges.size());
  for (const Trapezoid& e : edges) {
    result.push_back({integer(e.left.x, origin.x, unit, Int{}),
                      integer(e.left.y, origin.y, unit, Int{}),
                      integer(e.right.x, origin.x, unit, Int{}),
                      integer(e.right.y, origin.y, unit, Int{}), e.side});
  }
  return result;
}

template std::vector<IntegerTrapezoid<Int128>> in_units(const std::vector<Trapezoid>&,
                                                        const Point2&, int);
template std::vector<IntegerTrapezoid<BigInteger>> in_units(const std::vector<Trapezoid>&,
                                                            const Point2&, int);

BigInteger twice_area(const std::vector<IntegerTrapezoid<BigInteger>>& edges) {
  return twice_area_of(edges);
}
BigInteger twice_area(const std::vector<IntegerTrapezoid<Int128>>& edges) {
  return twice_area_of(edges);
}

}  // namespace tetloft::internal::sections
