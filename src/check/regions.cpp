#include "check/regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::internal::checking {

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

}  // namespace

bool Regions::is_outer(std::size_t s, std::size_t contour) const {
  const ContourId c(contour);
  return nesting[s].outer[nesting[s].region[c]] == c;
}

double Regions::gap(std::size_t s, std::size_t t) const {
  return z[std::max(s, t)] - z[std::min(s, t)];
}

std::optional<double> Regions::distance(const Link& link, double most) const {
  const double in_one_gap = gap(link);
  // Farther ones need not be measured; what is as far as this is compared as the rule says.
  const double enough = most * in_one_gap * (1 + 0x1p-40);
  const auto apart = region_distance_within(shape[link.lower], shape[link.upper], enough);
  if (!apart.has_value()) return std::nullopt;
  const double d = *apart / in_one_gap;
  if (d > most) return std::nullopt;
  return d;
}

Regions number_regions(const SectionStack& stack) {
  Regions regions;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const Section& section = stack.sections[SectionId(s)];
    regions.nesting.push_back(nest(section));
    regions.first.push_back(regions.section.size());
    regions.z.push_back(section.z);
    const Nesting& nesting = regions.nesting.back();
    std::vector<Box2> boxes;
    for (const ContourId outer : nesting.outer) {
      boxes.push_back(bounding_box(section.contours[outer]));
    }
    for (const RegionOutline& shape : outlines(section, nesting)) regions.shape.push_back(shape);
    regions.section.insert(regions.section.end(), boxes.size(), s);
    regions.box.insert(regions.box.end(), boxes.begin(), boxes.end());
    regions.tree.emplace_back(std::move(boxes));
  }
  regions.first.push_back(regions.section.size());
  return regions;
}

Box2 bounding_box(const Contour& contour) {
  Box2 box{contour.vertices.front(), contour.vertices.front()};
  for (const Point2& p : contour.vertices) box.include({p, p});
  return box;
}

Box2 surroundings(const Box2& box, double by) {
  const auto less = [&](double x) { return std::nextafter(x - by, -kUnlimited); };
  const auto more = [&](double x) { return std::nextafter(x + by, kUnlimited); };
  return {{less(box.low.x), less(box.low.y)}, {more(box.high.x), more(box.high.y)}};
}

Link link_between(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

LinkedRegions::LinkedRegions(std::size_t regions, const std::vector<Link>& links)
    : up(regions), down(regions) {
  for (const Link& link : links) {
    up[link.lower].push_back(link.upper);
    down[link.upper].push_back(link.lower);
  }
}

}  // namespace tetloft::internal::checking
