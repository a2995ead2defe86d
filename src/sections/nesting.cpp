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
#include "sections/sweep.hpp"

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

Nesting nest(const Section& section) {
  require_fit(sections::has_contours(section), "contours of fewer than three finite vertices");
  const std::size_t contours = section.contours.size();
  Nesting nesting;
  nesting.parent.resize(contours);
  nesting.depth.assign(contours, 0);
  nesting.region.resize(contours);

  std::vector<sections::SweepEdge> edges;
  std::vector<ContourId> owner;
  std::vector<bool> inside_above;
  for (std::size_t c = 0; c < contours; ++c) {
    const Contour& contour = section.contours[ContourId(c)];
    const bool ccw = sections::is_counter_clockwise(contour);
    for (std::size_t v = 0; v < contour.vertices.size(); ++v) {
      const Point2& a = contour.vertices[v];
      const Point2& b = contour.vertices[v + 1 == contour.vertices.size() ? 0 : v + 1];
      const bool forward = canonical_less(a, b);
      edges.push_back(forward ? sections::SweepEdge{a, b} : sections::SweepEdge{b, a});
      owner.emplace_back(c);
      inside_above.push_back(forward == ccw);
    }
  }

  std::vector<bool> seen(contours, false);
  sections::Sweep(edges).run([&](const sections::SweepEvent& event) {
    if (event.outgoing.empty()) return true;
    const ContourId c = owner[event.outgoing[0]];
    if (seen[c.index()]) return true;
    seen[c.index()] = true;
    if (event.below != sections::kNoEdge) {
      const ContourId neighbour = owner[event.below];
      nesting.parent[c] = inside_above[event.below] ? neighbour : nesting.parent[neighbour];
    }
    const ContourId parent = nesting.parent[c];
    if (parent.valid()) nesting.depth[c] = nesting.depth[parent] + 1;
    nesting.region[c] =
        nesting.depth[c] % 2 == 0 ? nesting.outer.push_back(c) : nesting.region[parent];
    return true;
  });
  return nesting;
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
