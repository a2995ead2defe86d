// The complement's nesting follows from the section's: the square surrounds all, so each contour is
// one deeper; what was a hole is an outer contour, what was an outer contour is a hole of the void
// around it.
#include "sections/complement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sections/scaling.hpp"

namespace tetloft::internal::sections {

namespace {

Point2 lowest_vertex(const Contour& contour) {
  return *std::min_element(contour.vertices.begin(), contour.vertices.end(),
                           [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
}

// Holes by their lowest vertices.
std::vector<ContourId> ordered_holes(const Section& section, const Nesting& nesting) {
  struct Hole {
    Point2 lowest;
    ContourId contour;
  };
  std::vector<Hole> holes;
  for (const ContourId c : section.contours.ids()) {
    if (nesting.depth[c] % 2 != 0) holes.push_back({lowest_vertex(section.contours[c]), c});
  }
  std::sort(holes.begin(), holes.end(),
            [](const Hole& a, const Hole& b) { return canonical_less(a.lowest, b.lowest); });
  std::vector<ContourId> order;
  order.reserve(holes.size());
  for (const Hole& hole : holes) order.push_back(hole.contour);
  return order;
}

IdVector<ContourId, RegionId> voids_by(const std::vector<ContourId>& holes,
                                       const Nesting& nesting) {
  IdVector<ContourId, RegionId> voids(nesting.depth.size(), kExterior);
  for (std::size_t h = 0; h < holes.size(); ++h) voids[holes[h]] = RegionId(h + 1);
  for (const ContourId c : nesting.depth.ids()) {
    if (nesting.depth[c] % 2 == 0 && nesting.parent[c].valid()) voids[c] = voids[nesting.parent[c]];
  }
  return voids;
}

}  // namespace

double far_outside(const SectionStack& stack) {
  double largest = 0;
  for (const Section& section : stack.sections) {
    largest = std::max(largest, largest_magnitude(section));
  }
  return far_outside(largest);
}

double far_outside(double largest) {
  if (largest == 0) return 1;
  int exponent = 0;
  const double fraction = std::frexp(largest, &exponent);  // in [1/2, 1)
  return std::ldexp(4.0, fraction == 0.5 ? exponent - 1 : exponent);
}

IdVector<ContourId, RegionId> voids_of_contours(const Section& section, const Nesting& nesting) {
  return voids_by(ordered_holes(section, nesting), nesting);
}

Complement complement_of(const Section& section, const Nesting& nesting, double half_side) {
  const std::vector<ContourId> holes = ordered_holes(section, nesting);
  Complement result;
  result.section = section;
  const ContourId square = result.section.contours.push_back({{{-half_side, -half_side},
                                                               {half_side, -half_side},
                                                               {half_side, half_side},
                                                               {-half_side, half_side}}});
  result.nesting.parent = nesting.parent;
  result.nesting.depth = nesting.depth;
  for (const ContourId c : section.contours.ids()) {
    if (!result.nesting.parent[c].valid()) result.nesting.parent[c] = square;
    ++result.nesting.depth[c];
  }
  result.nesting.parent.push_back(ContourId());
  result.nesting.depth.push_back(0);
  result.nesting.region = voids_by(holes, nesting);
  result.nesting.region.push_back(kExterior);
  result.nesting.outer.push_back(square);
  for (const ContourId hole : holes) result.nesting.outer.push_back(hole);
  return result;
}

}  // namespace tetloft::internal::sections
