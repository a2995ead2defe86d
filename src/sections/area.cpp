// Areas of contours and regions: intervals, and integers where these cannot tell the sign.
#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/overlap.hpp>

#include "sections/interiors.hpp"
#include "sections/trapezoids.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::Trapezoid;
using sections::Trapezoids;

// Twice a signed area as value · 2^scale; value has the exact sign.
struct ScaledArea {
  double value = 0;
  int scale = 0;

  [[nodiscard]] double rounded() const { return std::ldexp(value, scale); }
};

ScaledArea twice_area_of(const Trapezoids& shape) {
  if (shape.edges.empty()) return {};
  const int scale = sections::scale_of(shape.box);
  std::vector<Trapezoid> scaled = shape.edges;
  if (sections::rescale(scaled, scale)) {
    const Interval area = sections::twice_area(scaled);
    if (area.positive() || area.negative()) {
      return {area.lo + (area.hi - area.lo) / 2, -2 * scale};
    }
  }
  const int unit = std::min(sections::lattice_exponent(shape.edges), 0);
  const BigInteger area =
      sections::twice_area(sections::in_units<BigInteger>(shape.edges, {0, 0}, unit));
  const int shift = static_cast<int>(area.bits());
  return {area.to_double(-shift), shift + 2 * unit};
}

}  // namespace

double twice_area(const Contour& contour) {
  sections::require_finite(contour);
  return twice_area_of(sections::trapezoids_of(contour)).rounded();
}

Sign area_sign(const Contour& contour) {
  sections::require_finite(contour);
  const double value = twice_area_of(sections::trapezoids_of(contour)).value;
  return value > 0 ? Sign::positive : (value < 0 ? Sign::negative : Sign::zero);
}

double area(const RegionOutline& region) {
  sections::require_outline(region);
  return twice_area_of(sections::trapezoids_of(region)).rounded() / 2;
}

Sign compare_area(const RegionOutline& region, double side) {
  sections::require_outline(region);
  if (!std::isfinite(side)) return Sign::negative;
  const Trapezoids shape = sections::trapezoids_of(region);
  const int scale = sections::scale_of(shape.box);
  std::vector<Trapezoid> scaled = shape.edges;
  const double scaled_side = std::abs(side) * std::ldexp(1, scale);
  // Scaled coordinates are far below that, and its square is far from overflow.
  if (scaled_side > 0x1p30) return Sign::negative;
  if (sections::rescale(scaled, scale)) {
    const Interval sides = Interval{downwards(scaled_side), upwards(scaled_side)};
    const Interval excess = sections::twice_area(scaled) - Interval{2, 2} * (sides * sides);
    if (excess.positive()) return Sign::positive;
    if (excess.negative()) return Sign::negative;
  }
  int unit = std::min(sections::lattice_exponent(shape.edges), 0);
  if (side != 0) unit = std::min(unit, Dyadic(side).exponent);
  const BigInteger sides = BigInteger::from_double(side, unit);
  const BigInteger area =
      sections::twice_area(sections::in_units<BigInteger>(shape.edges, {0, 0}, unit));
  return static_cast<Sign>((area - BigInteger(2) * sides * sides).sign());
}

}  // namespace tetloft
