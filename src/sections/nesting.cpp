// Which contour lies in which: one sweep over the edges of a section.
//
// The edge next below the lowest vertex of a contour c decides: above it lies either the
// interior of its own contour d, then d is the parent of c, or its exterior, then c and d
// have the same parent. (d started before c in the sweep, so its parent is known.)
#include "sections/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/entry.hpp"
#include "core/guard.hpp"

namespace tetloft {

using namespace internal;

bool sections::is_counter_clockwise(const Contour& contour) {
  const std::vector<Point2>& vertices = contour.vertices;
  const std::size_t n = vertices.size();
  const auto lowest =
      std::min_element(vertices.begin(), vertices.end(),
                       [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  const auto v = static_cast<std::size_t>(lowest - vertices.begin());
  // The interior angle at the lowest vertex is below 180°: both neighbours are higher.
  return orient2d(vertices[v == 0 ? n - 1 : v - 1], vertices[v],
                  vertices[v + 1 == n ? 0 : v + 1]) == Sign::positive;
}

bool sections::has_contours(const Section& section) {
  return std::all_of(section.contours.begin(), section.contours.end(), [](const Contour& contour) {
    return contour.vertices.size() >= 3 &&
           std::all_of(contour.vertices.begin(), contour.vertices.end(),
                       [](const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  });
}

sections::Nester::Nester(const Section& section)
    : seen_(section.contours.size(), false), ccw_(section.contours.size(), false) {
  std::size_t count = 0;
  for (const Contour& contour : section.contours) count += contour.vertices.size();
  edges_.reserve(count);
  owner_.reserve(count);
  forward_.reserve(count);
  for (const ContourId c : section.contours.ids()) {
    const std::vector<Point2>& vertices = section.contours[c].vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Point2& a = vertices[v];
      const Point2& b = vertices[v + 1 == vertices.size() ? 0 : v + 1];
      const bool forward = canonical_less(a, b);
      edges_.push_back(forward ? SweepEdge{a, b} : SweepEdge{b, a});
      owner_.push_back(c);
      forward_.push_back(forward);
    }
  }
  const std::size_t contours = section.contours.size();
  nesting_.parent.resize(contours);
  nesting_.depth.assign(contours, 0);
  nesting_.region.resize(contours);
}

// At the lowest vertex of a contour its interior lies between both edges there, above the lower.
void sections::Nester::see(const SweepEvent& event) {
  if (event.outgoing.empty()) return;
  const std::uint32_t lowest = event.outgoing[0];
  const ContourId c = owner_[lowest];
  if (seen_[c.index()]) return;
  seen_[c.index()] = true;
  ccw_[c.index()] = forward_[lowest];
  if (event.below != kNoEdge) {
    const ContourId neighbour = owner_[event.below];
    nesting_.parent[c] = is_inside_above(event.below) ? neighbour : nesting_.parent[neighbour];
  }
  const ContourId parent = nesting_.parent[c];
  if (parent.valid()) nesting_.depth[c] = nesting_.depth[parent] + 1;
  nesting_.region[c] =
      nesting_.depth[c] % 2 == 0 ? nesting_.outer.push_back(c) : nesting_.region[parent];
}

Nesting nest(const Section& section) {
  require_fit(sections::has_contours(section), "contours of fewer than three finite vertices");
  sections::Nester nester(section);
  sections::Sweep(nester.edges()).run([&](const sections::SweepEvent& event) {
    nester.see(event);
    return true;
  });
  return nester.take();
}

namespace {

void require_nesting_of(const Section& section, const Nesting& nesting) {
  const std::size_t contours = section.contours.size();
  const std::size_t regions = nesting.outer.size();
  const bool fit = nesting.region.size() == contours &&
                   std::all_of(nesting.region.begin(), nesting.region.end(),
                               [&](RegionId r) { return r.index() < regions; }) &&
                   std::all_of(nesting.outer.begin(), nesting.outer.end(),
                               [&](ContourId c) { return c.index() < contours; });
  require_fit(fit, "the nesting is not that of the section");
}

}  // namespace

RegionOutline outline(const Section& section, const Nesting& nesting, RegionId region) {
  require_nesting_of(section, nesting);
  require_named(region.index() < nesting.outer.size(), "no region of the section");
  RegionOutline result;
  const ContourId outer = nesting.outer[region];
  result.contours.push_back(&section.contours[outer]);
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    const ContourId id(c);
    if (id != outer && nesting.region[id] == region) {
      result.contours.push_back(&section.contours[id]);
    }
  }
  return result;
}

IdVector<RegionId, RegionOutline> outlines(const Section& section, const Nesting& nesting) {
  require_nesting_of(section, nesting);
  IdVector<RegionId, RegionOutline> result(nesting.outer.size());
  for (std::size_t r = 0; r < nesting.outer.size(); ++r) {
    result[RegionId(r)].contours.push_back(&section.contours[nesting.outer[RegionId(r)]]);
  }
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    const ContourId id(c);
    const RegionId region = nesting.region[id];
    if (id != nesting.outer[region]) {
      result[region].contours.push_back(&section.contours[id]);
    }
  }
  return result;
}

}  // namespace tetloft
