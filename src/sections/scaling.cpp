#include "sections/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace tetloft::internal::sections {

double largest_magnitude(const Section& section) {
  double largest = 0;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
  }
  return largest;
}

void include(const Section& section, UnitOfLength& unit) {
  unit.include(section.z);
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) unit.include(p);
  }
}

UnitOfLength unit_of(const SectionStack& stack) {
  UnitOfLength unit;
  for (const Section& section : stack.sections) include(section, unit);
  return unit;
}

Section scaled_in_plane(const Section& section, int exponent) {
  Section result = section;
  for (Contour& contour : result.contours) {
    for (Point2& p : contour.vertices) p = internal::scaled(p, exponent);
  }
  return result;
}

Section scaled(const Section& section, int exponent) {
  Section result = scaled_in_plane(section, exponent);
  result.z = std::ldexp(section.z, exponent);
  return result;
}

SectionStack scaled(const SectionStack& stack, int exponent) {
  SectionStack result;
  result.sections.reserve(stack.sections.size());
  for (const Section& section : stack.sections) {
    result.sections.push_back(scaled(section, exponent));
  }
  return result;
}

}  // namespace tetloft::internal::sections
