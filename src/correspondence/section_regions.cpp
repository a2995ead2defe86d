#include "correspondence/section_regions.hpp"

#include <algorithm>
#include <cmath>

#include "sections/distance.hpp"

namespace tetloft::internal {

namespace {

// More than all roundings of a few operations amount to, relative.
constexpr double kSlack = 0x1p-48;

IdVector<RegionId, Box2> boxes_of(const Section& section, const Nesting& nesting) {
  IdVector<RegionId, Box2> boxes(nesting.outer.size());
  for (const RegionId r : boxes.ids()) {
    for (const Point2& p : section.contours[nesting.outer[r]].vertices) boxes[r].add(p);
  }
  return boxes;
}

}  // namespace

SectionRegions::SectionRegions(const Section& section, const Nesting& nesting)
    : z(section.z),
      outline(outlines(section, nesting)),
      box(boxes_of(section, nesting)),
      tree_(box.raw()),
      edges_(outline.size()) {
  for (std::unique_ptr<Edges>& edges : edges_) edges = std::make_unique<Edges>();
}

const sections::ContourEdges& SectionRegions::edges(RegionId r) const {
  Edges& edges = *edges_[r];
  const std::lock_guard lock(edges.mutex);
  if (!edges.tree) edges.tree.emplace(outline[r]);
  return *edges.tree;
}

void SectionRegions::forget_edges() const {
  for (const std::unique_ptr<Edges>& edges : edges_) edges->tree.reset();
}

void forget_edges(const StackSections& sections) {
  for (const SectionRegions& section : sections) section.forget_edges();
}

std::optional<double> gaps_apart(const SectionRegions& below, RegionId lower,
                                 const SectionRegions& above, RegionId upper, double reach) {
  const double gap = above.z - below.z;
  // The limit only saves work: a little more than what may pass the comparison of d itself.
  const double limit = gap * reach * (1 + kSlack);
  const std::optional<double> distance =
      sections::measure(below.edges(lower), above.edges(upper), limit).distance;
  if (!distance || *distance / gap > reach) return std::nullopt;
  return *distance / gap;
}

Box2 grown(const Box2& box, double by) {
  const double largest =
      std::max({std::abs(box.x0), std::abs(box.y0), std::abs(box.x1), std::abs(box.y1), by});
  const double side = by + largest * kSlack;
  return {box.x0 - side, box.y0 - side, box.x1 + side, box.y1 + side};
}

}  // namespace tetloft::internal
