// See overlap_region.hpp.
#include "sections/overlap_region.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/unit_of_length.hpp"
#include "sections/interiors.hpp"
#include "sections/overlap_pairs.hpp"

namespace tetloft::internal::sections {

namespace {

// Products of four coordinates within 2^±200 are far from the ends of doubles.
constexpr int kModerateScale = 200;

SlopedEdge with_slope(const Trapezoid& e) {
  const double dy = e.right.y - e.left.y;
  return {e, dy / (e.right.x - e.left.x), std::abs(dy)};
}

}  // namespace

OverlapRegion::OverlapRegion(const RegionOutline& outline)
    : OverlapRegion(outline, (require_outline(outline), trapezoids_of(outline)), true) {}

OverlapRegion::OverlapRegion(const RegionOutline& outline, Trapezoids shape, bool usable)
    : outline_(&outline),
      box_(shape.box),
      twice_area_(sections::twice_area(shape.edges)),
      usable_(usable) {
  sort_for_pairs(shape.edges);
  edges_.reserve(shape.edges.size());
  for (const Trapezoid& e : shape.edges) edges_.push_back(with_slope(e));
}

std::vector<SlopedEdge> OverlapRegion::edges_near(const Box2& box) const {
  const auto end = std::lower_bound(edges_.begin(), edges_.end(), box.x1,
                                    [](const SlopedEdge& e, double x) { return e.left.x < x; });
  std::vector<SlopedEdge> near;
  std::copy_if(edges_.begin(), end, std::back_inserter(near),
               [&](const SlopedEdge& e) { return box.x0 < e.right.x; });
  return near;
}

bool OverlapRegion::is_moderate() const { return std::abs(scale_of(box_)) <= kModerateScale; }

OverlapRegion OverlapRegion::scaled(int scale) const {
  Trapezoids shape = trapezoids_of(*outline_);
  const bool exact = rescale(shape.edges, scale);
  for (double* side : {&shape.box.x0, &shape.box.y0, &shape.box.x1, &shape.box.y1}) {
    *side = internal::scaled(*side, scale);
  }
  return {*outline_, std::move(shape), exact};
}

}  // namespace tetloft::internal::sections
